// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/scene.h"

#include <array>

namespace romascope {

/// What of a scene's triangles is there, and for whom: copied from its materials and textures.
class ReferenceSurfaces {
public:
    explicit ReferenceSurfaces(const Scene& scene);

    /// Whether all triangles are the same from both sides.
    bool all_double_sided() const { return all_double_sided_; }
    bool is_double_sided(uint32_t triangle) const { return double_sided_[triangle]; }
    /// Whether the triangle is without a mask, or its mask leaves the point with the barycentric
    /// coordinates (1 - u - v, u, v).
    bool is_there(uint32_t triangle, float u, float v) const;

private:
    struct Masked {
        uint32_t material = 0;
        std::array<glm::vec2, 3> texcoords{};
        std::array<float, 3> alphas{1.0f, 1.0f, 1.0f}; ///< of the vertices
    };
    std::vector<bool> double_sided_; ///< per triangle
    bool all_double_sided_ = true;
    std::vector<uint32_t> slot_; ///< per triangle, or empty: into masked_, or kNoMask
    std::vector<Masked> masked_;
    std::vector<Material> materials_;
    std::vector<SurfaceTexture> textures_; ///< those of masked materials, the others without texels
};

} // namespace romascope
