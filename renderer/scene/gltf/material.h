// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/gltf/document.h"
#include "renderer/scene/gltf/notices.h"
#include "renderer/scene/scene.h"

#include <array>
#include <map>
#include <vector>

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

    /// Textures that show one picture in one way are one: its image, wrapS, wrapT, magFilter.
    using TextureKey = std::array<int, 4>;
    TextureKey key_of(int texture) const;

    const Document& document_;
    Scene& scene_;
    MemoryBudget& budget_;
    Notices& notices_;
    std::map<int, uint32_t> used_;
    std::map<TextureKey, int> textures_; ///< index into Scene::textures; -1: cannot be read
    std::vector<bool> holes_;            ///< per Scene::textures: some of it is transparent
};

} // namespace romascope::gltf
