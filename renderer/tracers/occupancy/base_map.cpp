// SPDX-License-Identifier: MIT
#include "renderer/tracers/occupancy/base_map.h"

namespace romascope {

BaseMap::BaseMap(BaseStore store, glm::ivec3 cells) : store_(store), cells_(cells) {
    const glm::ivec3 texels(cells.x, cells.y, (cells.z + 31) / 32);
    if (store == BaseStore::texture)
        texture_ = Texture("occupancy map", GL_TEXTURE_3D, GL_R32UI, texels);
    else
        words_ = TexelBuffer("occupancy map", GL_R32UI,
                             static_cast<size_t>(texels.x) * texels.y * texels.z);
}

void BaseMap::clear() {
    if (store_ == BaseStore::texture) {
        texture_.clear_uint(0);
    } else {
        words_.bind_storage(0);
        glClearBufferData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT,
                          nullptr);
    }
}

void BaseMap::bind(GLuint unit) const {
    if (store_ == BaseStore::texture)
        texture_.bind(unit);
    else
        words_.bind(unit);
}

void BaseMap::bind_image(GLuint unit, GLenum access) const {
    if (store_ == BaseStore::texture)
        texture_.bind_image(unit, access);
    else
        words_.bind_image(unit, access);
}

BitGrid BaseMap::download() const {
    return BitGrid(cells_,
                   store_ == BaseStore::texture ? texture_.download_uint(1) : words_.download());
}

ShaderDefine BaseMap::define(BaseStore store) {
    return {"BASE_MAP_IN_BUFFER", store == BaseStore::buffer ? "1" : "0"};
}

} // namespace romascope
