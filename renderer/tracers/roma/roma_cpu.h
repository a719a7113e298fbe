// SPDX-License-Identifier: MIT
// The CPU twin of the rotation and of the tracing: the same functions of roma_shared.h, around them
// plain loops. Tests compare it bit for bit with the shaders.
#pragma once

#include "renderer/tracers/roma/aligned_box.h"
#include "renderer/tracers/roma/column_cpu.h"

#include <vector>

namespace romascope {

/// One aligned map on the CPU: column (i, j) starts at words[(j * side + i) * words_per_column].
struct AlignedMap {
    gpu::RomaDirection direction;
    int side = 0;
    std::vector<uint32_t> words;

    int words_per_column() const { return (side + 31) / 32; }
    std::span<const uint32_t> column(glm::ivec2 place) const {
        const auto count = static_cast<size_t>(words_per_column());
        return std::span(words).subspan((static_cast<size_t>(place.y) * side + place.x) * count,
                                        count);
    }
};

AlignedMap rotate_on_cpu(const BitGrid& base, const gpu::RomaDirection& direction, int side);

} // namespace romascope
