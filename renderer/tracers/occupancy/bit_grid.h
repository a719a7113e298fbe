// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace romascope {

/// A grid of cubic cells over the scene's bounds.
struct OccupancyGrid {
    glm::vec3 origin{0.0f}; ///< lower corner of cell (0, 0, 0), metres
    float cell_size = 1.0f; ///< metres
    glm::ivec3 size{1};     ///< cells

    /// The grid with `resolution` cells along the longest side of the bounds. It is one cell longer
    /// than the bounds along each axis, so that a shift by `jitter` cells, in [0, 1), still covers
    /// them: the origin lies `jitter` cells before the bounds' lower corner.
    static OccupancyGrid fit(const Bounds& bounds, int resolution, glm::vec3 jitter);
};

/// One bit per cell. Bit b of word w of column (x, y) is cell (x, y, 32 w + b); the layout of the
/// occupancy map on the GPU, texel for texel.
class BitGrid {
public:
    BitGrid() = default;
    explicit BitGrid(glm::ivec3 size);
    /// `words`: words_per_column() * size.y * size.x of them, x fastest, then y, then the word.
    BitGrid(glm::ivec3 size, std::vector<uint32_t> words);

    glm::ivec3 size() const { return size_; }
    int words_per_column() const { return (size_.z + 31) / 32; }
    const std::vector<uint32_t>& words() const { return words_; }

    /// False outside the grid.
    bool get(glm::ivec3 cell) const;
    void set(glm::ivec3 cell);
    size_t count() const;

    bool operator==(const BitGrid&) const = default;

private:
    size_t word_index(glm::ivec3 cell) const;
    glm::ivec3 size_{0};
    std::vector<uint32_t> words_;
};

} // namespace romascope
