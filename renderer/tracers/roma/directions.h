// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/tracers/occupancy/bit_grid.h"
#include "shaders/tracers/roma/roma_shared.h"

#include <cstdint>
#include <vector>

namespace romascope {

/// Unit direction with z >= 0 for a point of the square [0, 1]^2: the concentric mapping to the
/// disc (Shirley and Chiu 1997), lifted to the hemisphere so that equal areas stay equal.
glm::dvec3 hemisphere_from_square(glm::dvec2 square);

/// One direction in each of side * side strata of the hemisphere about +z, row by row, at a random
/// place of its stratum (Zeng et al. 2023, sections 4.1 and 4.3), or at its middle.
std::vector<glm::dvec3> candidate_directions(int side, bool jitter, uint32_t seed, uint32_t frame);

/// The cube of an aligned map: it encloses the scene whatever way it is turned.
struct AlignedCube {
    glm::vec3 centre{0.0f};
    double cell_size = 1.0; ///< metres
    int side = 1;           ///< cells

    /// The smallest for scenes within `bounds` whose occupied cells, of size `base_cell`, reach up
    /// to one cell beyond them.
    static AlignedCube around(const Bounds& bounds, double base_cell, int side);
};

/// What the shaders need to know of the map that is aligned with a unit direction.
gpu::RomaDirection aligned_map(const AlignedCube& cube, glm::dvec3 direction,
                               const OccupancyGrid& grid);

} // namespace romascope
