// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/gltf/document.h"
#include "renderer/scene/gltf/notices.h"
#include "renderer/scene/scene.h"

#include <map>

namespace romascope::gltf {

/// Where a material's texture coordinates come from.
struct TexcoordSource {
    int set = -1;              ///< TEXCOORD_n; -1: the material has no texture
    glm::dmat3 transform{1.0}; ///< of (u, v, 1): KHR_texture_transform
};

/// Puts the materials that are in use into a scene, each once, with their textures.
class Materials {
public:
    Materials(const Document& document, Scene& scene, MemoryBudget& budget, Notices& notices)
        : document_(document), scene_(scene), budget_(budget), notices_(notices) {}

    /// Index into Scene::materials. `material`: of the file, -1 for none given.
    /// Throws Error (kBadInput) for a texture in use that cannot be read.
    uint32_t use(int material);

    TexcoordSource texcoords(int material) const;

private:
    Material read(size_t material);
    int use_texture(int texture);

    const Document& document_;
    Scene& scene_;
    MemoryBudget& budget_;
    Notices& notices_;
    std::map<int, uint32_t> used_;
    std::map<int, int> textures_; ///< of the file, to those of the scene
};

} // namespace romascope::gltf
