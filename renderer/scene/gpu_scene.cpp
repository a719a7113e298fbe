// SPDX-License-Identifier: MIT
#include "renderer/scene/gpu_scene.h"

namespace romascope {
namespace {

template <class T>
Buffer optional_attribute(const std::string& label, const std::vector<T>& data) {
    return data.empty() ? Buffer() : Buffer::from(label, std::span(data));
}

} // namespace

GpuScene::GpuScene(const Scene& scene)
    : positions_(Buffer::from("positions", std::span(scene.positions))),
      normals_(Buffer::from("normals", std::span(scene.normals))),
      vertex_materials_(Buffer::from("vertex materials", std::span(scene.vertex_material))),
      texcoords_(optional_attribute("texture coordinates", scene.texcoords)),
      colors_(optional_attribute("vertex colours", scene.colors)),
      indices_(Buffer::from("indices", std::span(scene.indices))),
      position_texels_("positions", GL_RGB32F, positions_),
      index_texels_("indices", GL_RGB32UI, indices_), groups_(triangle_groups(scene)),
      surfaces_(scene), bounds_(scene.bounds), rest_diagonal_(glm::length(scene.bounds.extent())) {
    GLuint id = 0;
    glCreateVertexArrays(1, &id);
    vertex_array_ = GlHandle<delete_vertex_array>(id);
    const auto attribute = [id](GLuint index, const Buffer& buffer, GLsizei stride) {
        glVertexArrayVertexBuffer(id, index, buffer.id(), 0, stride);
        glEnableVertexArrayAttrib(id, index);
        glVertexArrayAttribBinding(id, index, index);
    };
    attribute(0, positions_, sizeof(glm::vec3));
    glVertexArrayAttribFormat(id, 0, 3, GL_FLOAT, GL_FALSE, 0);
    attribute(1, normals_, sizeof(glm::vec3));
    glVertexArrayAttribFormat(id, 1, 3, GL_FLOAT, GL_FALSE, 0);
    attribute(2, vertex_materials_, sizeof(uint32_t));
    glVertexArrayAttribIFormat(id, 2, 1, GL_UNSIGNED_INT, 0);
    if (texcoords_.bytes() > 0) {
        attribute(3, texcoords_, sizeof(glm::vec2));
        glVertexArrayAttribFormat(id, 3, 2, GL_FLOAT, GL_FALSE, 0);
    }
    if (colors_.bytes() > 0) {
        attribute(4, colors_, sizeof(uint32_t));
        glVertexArrayAttribFormat(id, 4, 4, GL_UNSIGNED_BYTE, GL_TRUE, 0);
    }
    glVertexArrayElementBuffer(id, indices_.id());
}

void GpuScene::remember_positions() {
    if (!has_previous_positions()) {
        const GLuint id = vertex_array_.id();
        previous_positions_ = Buffer("previous positions", positions_.bytes());
        glVertexArrayVertexBuffer(id, 5, previous_positions_.id(), 0, sizeof(glm::vec3));
        glEnableVertexArrayAttrib(id, 5);
        glVertexArrayAttribBinding(id, 5, 5);
        glVertexArrayAttribFormat(id, 5, 3, GL_FLOAT, GL_FALSE, 0);
    }
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT); // shaders wrote the positions
    glCopyNamedBufferSubData(positions_.id(), previous_positions_.id(), 0, 0,
                             static_cast<GLsizeiptr>(positions_.bytes()));
}

void GpuScene::draw(const TriangleGroup& group) const {
    glBindVertexArray(vertex_array_.id());
    // What attributes are where no buffer gives them; the context's state, not the vertex array's.
    glVertexAttrib2f(3, 0.0f, 0.0f);
    glVertexAttrib4f(4, 1.0f, 1.0f, 1.0f, 1.0f);
    const uintptr_t offset = group.first * 3 * sizeof(uint32_t);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(group.count * 3), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(offset));
}

size_t GpuScene::bytes() const {
    return positions_.bytes() + previous_positions_.bytes() + normals_.bytes() +
           vertex_materials_.bytes() + texcoords_.bytes() + colors_.bytes() + indices_.bytes() +
           surfaces_.bytes();
}

} // namespace romascope
