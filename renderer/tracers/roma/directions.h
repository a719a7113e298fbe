// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace romascope {

/// Unit direction with z >= 0 for a point of the square [0, 1]^2: the concentric mapping to the
/// disc (Shirley and Chiu 1997), lifted to the hemisphere so that equal areas stay equal.
glm::dvec3 hemisphere_from_square(glm::dvec2 square);

/// One direction in each of side * side strata of the hemisphere about +z, row by row, at a random
/// place of its stratum (Zeng et al. 2023, sections 4.1 and 4.3), or at its middle.
std::vector<glm::dvec3> candidate_directions(int side, bool jitter, uint32_t seed, uint32_t frame);

/// The strata in an order in which neighbours are neighbours on the hemisphere: along a Hilbert
/// curve over the square. What is spread evenly along it is spread evenly over the directions.
std::vector<int> strata_along_curve(int side);

} // namespace romascope
