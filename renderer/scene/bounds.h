// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include <limits>

namespace romascope {

/// No vertex lies further out on any axis, in metres: products of two edges, squared, must stay
/// below the largest float.
inline constexpr double kMaxCoordinate = 1e9;

/// Axis-aligned box; empty (min > max) until a point is added.
struct Bounds {
    glm::vec3 min{std::numeric_limits<float>::infinity()};
    glm::vec3 max{-std::numeric_limits<float>::infinity()};

    void add(glm::vec3 p) {
        min = glm::min(min, p);
        max = glm::max(max, p);
    }
    void add(const Bounds& other) {
        min = glm::min(min, other.min);
        max = glm::max(max, other.max);
    }
    bool empty() const { return min.x > max.x; }
    glm::vec3 extent() const { return max - min; }
    glm::vec3 centre() const { return 0.5f * (min + max); }
};

} // namespace romascope
