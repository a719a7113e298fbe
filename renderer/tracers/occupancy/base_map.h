// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/program.h"
#include "renderer/tracers/occupancy/bit_grid.h"

namespace romascope {

/// What holds the words of a base occupancy map. Readers of cells here and there want a texture,
/// which keeps neighbours in all directions near each other; the shear reads rows of words, for
/// which a GPU's loads from a buffer are several times as fast as fetches.
enum class BaseStore { texture, buffer };

/// The memory of a base occupancy map, R32UI: the words of a BitGrid in their order, as texels (x,
/// y, word) of a 3D texture or as a buffer. What is in it is left to who fills it.
class BaseMap {
public:
    BaseMap() = default;
    BaseMap(BaseStore store, glm::ivec3 cells);

    glm::ivec3 cells() const { return cells_; }
    BaseStore store() const { return store_; }
    /// Of the one that holds the words; the other is empty.
    const Texture& texture() const { return texture_; }
    const TexelBuffer& words() const { return words_; }
    size_t bytes() const { return texture_.bytes() + words_.bytes(); }

    void clear();
    void bind(GLuint unit) const;
    void bind_image(GLuint unit, GLenum access) const;
    BitGrid download() const;

    /// BASE_MAP_IN_BUFFER for shaders that take either, by shaders/tracers/occupancy/base_map.glsl.
    static ShaderDefine define(BaseStore store);

private:
    BaseStore store_ = BaseStore::texture;
    glm::ivec3 cells_{0};
    Texture texture_;
    TexelBuffer words_;
};

} // namespace romascope
