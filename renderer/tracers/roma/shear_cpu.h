// SPDX-License-Identifier: MIT
// The CPU twin of alignment by shear and of its tracing: the same functions of shear_shared.h,
// around them plain loops over cells. Tests compare it bit for bit with the shaders.
#pragma once

#include "renderer/tracers/roma/column_cpu.h"
#include "renderer/tracers/roma/shear.h"

namespace romascope {

/// One map on the CPU: column (i, j), wrapped, starts at
/// words[(j * size.x + i) * words_per_column].
struct ShearedMap {
    gpu::ShearGrid grid;
    gpu::ShearMap map;
    glm::ivec3 size; ///< columns along p and q, slices
    std::vector<uint32_t> words;

    int words_per_column() const { return (size.z + 31) / 32; }
    /// The words of an unwrapped column.
    std::span<const uint32_t> column(glm::ivec2 unwrapped) const;
    /// The cells of a span that its unwrapped column has; its column is wrapped after that.
    gpu::RomaSpan inside(gpu::RomaSpan span) const;
    /// A snapped ray, as gpu::shear_ray has it, cut to the cells of its column.
    gpu::RomaRay ray(bool forward, glm::vec3 point, glm::vec3 normal, float t_max) const;
};

/// The words of the base map's three packings.
std::vector<uint32_t> pack_on_cpu(const BitGrid& base, const ShearPackings& packings);

/// Map `map` of a frame.
ShearedMap shear_on_cpu(const BitGrid& base, const ShearFrame& frame, size_t map, int taps);

} // namespace romascope
