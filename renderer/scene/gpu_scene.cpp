// SPDX-License-Identifier: MIT
#include "renderer/scene/gpu_scene.h"

namespace romascope {
namespace {

Buffer upload_materials(const std::vector<Material>& materials) {
    std::vector<glm::vec4> data;
    for (const Material& material : materials) {
        data.emplace_back(material.base_color, 1.0f);
        data.emplace_back(material.emissive, 0.0f);
    }
    return Buffer::from("materials", std::span<const glm::vec4>(data));
}

} // namespace

GpuScene::GpuScene(const Scene& scene)
    : positions_(Buffer::from("positions", std::span(scene.positions))),
      normals_(Buffer::from("normals", std::span(scene.normals))),
      vertex_materials_(Buffer::from("vertex materials", std::span(scene.vertex_material))),
      indices_(Buffer::from("indices", std::span(scene.indices))),
      materials_(upload_materials(scene.materials)),
      index_count_(static_cast<GLsizei>(scene.indices.size())), bounds_(scene.bounds) {
    GLuint id = 0;
    glCreateVertexArrays(1, &id);
    vertex_array_ = GlHandle<delete_vertex_array>(id);
    const auto attribute = [id](GLuint index, const Buffer& buffer, GLint components,
                                GLsizei stride) {
        glVertexArrayVertexBuffer(id, index, buffer.id(), 0, stride);
        glEnableVertexArrayAttrib(id, index);
        glVertexArrayAttribBinding(id, index, index);
        if (components == 1)
            glVertexArrayAttribIFormat(id, index, 1, GL_UNSIGNED_INT, 0);
        else
            glVertexArrayAttribFormat(id, index, components, GL_FLOAT, GL_FALSE, 0);
    };
    attribute(0, positions_, 3, sizeof(glm::vec3));
    attribute(1, normals_, 3, sizeof(glm::vec3));
    attribute(2, vertex_materials_, 1, sizeof(uint32_t));
    glVertexArrayElementBuffer(id, indices_.id());
}

void GpuScene::draw() const {
    glBindVertexArray(vertex_array_.id());
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

size_t GpuScene::bytes() const {
    return positions_.bytes() + normals_.bytes() + vertex_materials_.bytes() + indices_.bytes() +
           materials_.bytes();
}

} // namespace romascope
