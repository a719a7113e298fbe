// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/bounds.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/motion.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace romascope {

/// Surface of a triangle. Colours are linear.
struct Material {
    std::string name;
    glm::vec3 base_color{1.0f}; ///< reflectance in [0, 1]
    glm::vec3 emissive{0.0f};   ///< radiance
    float alpha = 1.0f;         ///< in [0, 1]
    int texture = -1;           ///< multiplies base_color and alpha; index into Scene::textures
    /// Above 0 an alpha mask: where alpha is below, the surface is not there, to no one. In [0, 1].
    float alpha_cutoff = 0.0f;
    /// False: seen from behind it is not drawn. It still occludes: rays know no sides.
    bool double_sided = false;
};

enum class TextureWrap : uint32_t { repeat, mirror, clamp };

/// A base colour texture.
struct SurfaceTexture {
    glm::ivec2 size{0};
    TextureWrap wrap_u = TextureWrap::repeat;
    TextureWrap wrap_v = TextureWrap::repeat;
    bool nearest = false; ///< no interpolation between texels
    /// Row by row, (u, v) = (0, 0) at the start; red in the lowest byte. Colour is sRGB-encoded,
    /// alpha is linear.
    std::vector<uint32_t> texels;
};

enum class LightKind { directional, point, spot };

/// KHR_lights_punctual.
struct Light {
    std::string name;
    LightKind kind = LightKind::point;
    glm::vec3 position{0.0f};               ///< metres; not for directional ones
    glm::vec3 direction{0.0f, 0.0f, -1.0f}; ///< unit length, the way the light travels
    /// Linear, times intensity: lux for directional ones, candela for the others.
    glm::vec3 color{1.0f};
    float range = std::numeric_limits<float>::infinity(); ///< metres
    float inner_cone = 0.0f, outer_cone = 0.7853982f;     ///< radians from the axis of a spot
};

/// Triangles in world space (metres, y up), every instance written out, and what goes with them.
/// What moves stands as at second 0 of the first animation, see `motion`.
struct Scene {
    std::string name;                      ///< file name without folder and extension
    std::vector<glm::vec3> positions;      ///< per vertex
    std::vector<glm::vec3> normals;        ///< per vertex, unit length, or 0: the triangle's own
    std::vector<glm::vec2> texcoords;      ///< per vertex, or empty: no material has a texture
    std::vector<uint32_t> colors;          ///< per vertex, RGBA8 linear, or empty: all white
    std::vector<uint32_t> vertex_material; ///< per vertex, index into `materials`
    std::vector<uint32_t> indices;         ///< three per triangle, counter-clockwise from outside
    std::vector<Material> materials;       ///< at least one
    std::vector<SurfaceTexture> textures;
    std::vector<Light> lights;
    std::vector<Camera> cameras; ///< at least one: a file without any gets one that fits
    Bounds bounds;               ///< contains all vertices of triangles; tight if nothing moves
    Motion motion;
    std::vector<std::string> notices; ///< one line each: what of the file is not drawn as it says

    size_t triangle_count() const { return indices.size() / 3; }

    /// The camera of that name. Throws Error (kBadInput) that tells the nearest and lists the
    /// names.
    const Camera& camera(const std::string& wanted) const;
};

/// Triangles that follow each other in Scene::indices and are drawn alike.
struct TriangleGroup {
    size_t first = 0, count = 0; ///< triangles
    bool masked = false;         ///< alpha must be looked at
    bool double_sided = false;
};

/// Puts triangles that are drawn alike together, in the order of their groups: at most four.
/// Triangles of a group keep their order.
void sort_by_group(Scene& scene);

/// The groups in their order; they cover all triangles.
std::vector<TriangleGroup> triangle_groups(const Scene& scene);

} // namespace romascope
