// SPDX-License-Identifier: MIT
// What the CPU works out for alignment by shear: the three packings of the base map and the map of
// each direction. See shear_shared.h for what they mean.
#pragma once

#include "renderer/tracers/occupancy/bit_grid.h"
#include "shaders/tracers/roma/shear_shared.h"

#include <array>
#include <span>
#include <vector>

namespace romascope {

/// The axes of a map by the axis its slices are counted along: rows of cells lie along p, which is
/// that of the base map's bits unless its slices are.
struct ShearAxes {
    int p, q, m;
    explicit ShearAxes(int dominant)
        : p(dominant == 2 ? 0 : 2), q(dominant == 1 ? 0 : 1), m(dominant) {}
};

/// The base map packed for slices along one axis. Bit b of word w of row q in slice k is the cell
/// at place 32 w + b along p, with the guard's empty cells after those of the grid, and all of that
/// repeated; the row has a word more than its cells take, so that 32 cells from any place on lie in
/// two words. Word (q * row_words + w) * slices + k, so neighbouring slices lie side by side.
struct ShearPacking {
    glm::ivec2 columns{0}; ///< cells along p and q, the guard's included
    int slices = 0;        ///< cells along m
    int row_words = 0;
    size_t first_word = 0; ///< of all three packings, which follow each other

    size_t words() const {
        return static_cast<size_t>(columns.y) * static_cast<size_t>(row_words) *
               static_cast<size_t>(slices);
    }
};

using ShearPackings = std::array<ShearPacking, 3>; ///< by the axis of the slices

/// Empty cells on each side of the grid along p and q: with several taps, those at the border look
/// at cells beyond it, up to two from it where the column's own cell is in the guard.
int shear_guard(int taps);

/// Places of an axis in the table of them, for the largest axis of a grid with this guard.
int shear_table_places(glm::ivec3 grid_size, int guard);

ShearPackings shear_packings(glm::ivec3 grid_size, int guard);
size_t shear_packing_words(const ShearPackings& packings);

/// What the shaders need to know of the maps of a frame.
struct ShearFrame {
    gpu::ShearGrid grid;
    std::vector<gpu::ShearMap> maps;
    size_t texels = 0; ///< of all maps, which lie one after the other
    size_t places = 0; ///< entries of the table of places

    /// Columns of a map along p and q, and its slices.
    glm::ivec3 size(size_t map) const { return gpu::shear_size(grid, maps[map].slope.z); }
    /// The direction that a map is traced in, exactly, towards later slices: slopes are rounded.
    glm::dvec3 along(size_t map) const;
};

/// The maps of these directions, in this order. `offset`: how far rays start off their surface,
/// cells.
ShearFrame shear_frame(std::span<const glm::dvec3> directions, const OccupancyGrid& grid, int taps,
                       int texels_per_column, double offset);

/// The axis that a direction goes farthest along; of equals, the first.
int dominant_axis(glm::dvec3 direction);

} // namespace romascope
