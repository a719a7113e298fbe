// SPDX-License-Identifier: MIT
#include "renderer/tracers/occupancy/bit_grid.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace romascope {

OccupancyGrid OccupancyGrid::fit(const Bounds& bounds, int resolution, glm::vec3 jitter) {
    const glm::vec3 extent = bounds.extent();
    // A single point has no size; any will do.
    float longest = std::max({extent.x, extent.y, extent.z});
    if (!(longest > 0.0f))
        longest = 1.0f;
    OccupancyGrid grid;
    grid.cell_size = longest / static_cast<float>(resolution - 1);
    for (int axis = 0; axis < 3; ++axis) {
        // Cells that the extent touches, and one more for the shift. A longest side that rounding
        // puts a hair above its whole number of cells must not get another one.
        const float cells = extent[axis] / grid.cell_size;
        grid.size[axis] =
            std::min(static_cast<int>(std::ceil(cells * (1.0f - 1e-6f))) + 1, resolution);
    }
    grid.origin = bounds.min - jitter * grid.cell_size;
    return grid;
}

BitGrid::BitGrid(glm::ivec3 size)
    : size_(size), words_(static_cast<size_t>(size.x) * size.y * ((size.z + 31) / 32)) {}

BitGrid::BitGrid(glm::ivec3 size, std::vector<uint32_t> words)
    : size_(size), words_(std::move(words)) {
    assert(words_.size() == static_cast<size_t>(size.x) * size.y * words_per_column());
}

size_t BitGrid::word_index(glm::ivec3 cell) const {
    return (static_cast<size_t>(cell.z / 32) * size_.y + cell.y) * size_.x + cell.x;
}

bool BitGrid::get(glm::ivec3 cell) const {
    if (cell.x < 0 || cell.y < 0 || cell.z < 0 || cell.x >= size_.x || cell.y >= size_.y ||
        cell.z >= size_.z)
        return false;
    return (words_[word_index(cell)] >> (cell.z % 32)) & 1u;
}

void BitGrid::set(glm::ivec3 cell) { words_[word_index(cell)] |= 1u << (cell.z % 32); }

size_t BitGrid::count() const {
    size_t count = 0;
    for (uint32_t word : words_)
        count += static_cast<size_t>(std::popcount(word));
    return count;
}

} // namespace romascope
