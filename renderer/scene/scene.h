// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/camera.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace romascope {

/// Axis-aligned box; empty (min > max) until a point is added.
struct Bounds {
    glm::vec3 min{std::numeric_limits<float>::infinity()};
    glm::vec3 max{-std::numeric_limits<float>::infinity()};

    void add(glm::vec3 p) {
        min = glm::min(min, p);
        max = glm::max(max, p);
    }
    bool empty() const { return min.x > max.x; }
    glm::vec3 extent() const { return max - min; }
    glm::vec3 centre() const { return 0.5f * (min + max); }
};

/// Surface of a triangle. Colours are linear.
struct Material {
    std::string name;
    glm::vec3 base_color{1.0f}; ///< reflectance in [0, 1]
    glm::vec3 emissive{0.0f};   ///< radiance
};

/// Triangles in world space (metres, y up), every instance written out, and what goes with them.
struct Scene {
    std::string name;                      ///< file name without folder and extension
    std::vector<glm::vec3> positions;      ///< per vertex
    std::vector<glm::vec3> normals;        ///< per vertex, unit length
    std::vector<uint32_t> vertex_material; ///< per vertex, index into `materials`
    std::vector<uint32_t> indices;         ///< three per triangle
    std::vector<Material> materials;       ///< at least one
    std::vector<Camera> cameras;           ///< at least one: a file without any gets one that fits
    Bounds bounds;                         ///< of `positions` used by triangles

    size_t triangle_count() const { return indices.size() / 3; }

    /// The camera of that name. Throws Error (kBadInput) that lists the names there are.
    const Camera& camera(const std::string& wanted) const;
};

} // namespace romascope
