// SPDX-License-Identifier: MIT
#include "renderer/passes/deform.h"

#include "renderer/base/error.h"
#include "shaders/passes/deform_shared.h"

#include <fmt/format.h>

#include <bit>

namespace romascope {
namespace {

// The shader takes these apart by words.
static_assert(sizeof(Influence) == 24 && offsetof(Influence, weight) == 8);
static_assert(sizeof(MorphDelta) == 24 && offsetof(MorphDelta, normal) == 12);
static_assert(std::endian::native == std::endian::little);

std::vector<gpu::DeformPart> parts_of(const Motion& motion) {
    std::vector<gpu::DeformPart> parts;
    for (const MovingPart& part : motion.parts)
        parts.push_back({part.first_vertex - motion.first_vertex, part.vertex_count,
                         part.first_matrix, part.first_influence, part.influence_sets,
                         part.first_delta, part.target_count,
                         motion.nodes[part.node].first_weight});
    return parts;
}

/// Positions, then normals.
Buffer upload_rest(const Motion& motion) {
    const auto positions = std::as_bytes(std::span(motion.rest_positions));
    Buffer buffer("vertices at rest", 2 * positions.size());
    if (!positions.empty()) {
        buffer.upload(positions);
        buffer.upload(std::as_bytes(std::span(motion.rest_normals)), positions.size());
    }
    return buffer;
}

/// Three rows a matrix.
std::vector<glm::vec4> rows_of(const std::vector<glm::dmat4>& matrices) {
    std::vector<glm::vec4> rows;
    for (const glm::dmat4& matrix : matrices) {
        const glm::mat4 transposed(glm::transpose(matrix));
        rows.insert(rows.end(), {transposed[0], transposed[1], transposed[2]});
    }
    return rows;
}

} // namespace

ShaderVariant Deform::variant() {
    return {"deform", {{GL_COMPUTE_SHADER, "passes/deform.comp.glsl"}}, {}, {}};
}

Deform::Deform(const Motion& motion) : bounds_(motion) {
    if (motion.parts.empty())
        return;
    parts_ = Buffer::from("moving parts", std::span<const gpu::DeformPart>(parts_of(motion)));
    rest_ = upload_rest(motion);
    influences_ = Buffer::from("influences of joints", std::span(motion.influences));
    deltas_ = Buffer::from("morph targets", std::span(motion.deltas));
    palette_ = Buffer("palette", 3 * sizeof(glm::vec4) * motion.matrix_count);
    weights_ = Buffer("morph weights", sizeof(float) * motion.weights.size());
    GLint64 limit = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &limit);
    for (const auto& [what, buffer] :
         {std::pair("vertices that move", &rest_), std::pair("weights of joints", &influences_),
          std::pair("morph targets", &deltas_)})
        if (buffer->bytes() > static_cast<size_t>(limit))
            throw Error(
                fmt::format("the scene's {} take {} MiB, more than this driver reads in one "
                            "piece ({} MiB)",
                            what, buffer->bytes() >> 20, limit >> 20));
}

void Deform::run(const ShaderLibrary& shaders, PassTimer& timer, GpuScene& scene,
                 const Motion& motion, const Pose& pose) {
    const std::vector<glm::dmat4> matrices = palette(motion, pose);
    const Bounds bounds = bounds_.at(motion, pose, matrices);
    const Program& program = program_.get(shaders, variant());
    scene.set_bounds(bounds);
    const auto vertex_count = static_cast<GLuint>(motion.rest_positions.size());

    auto pass = timer.compute("deform");
    palette_.upload(std::as_bytes(std::span<const glm::vec4>(rows_of(matrices))));
    const std::vector<float> weights(pose.weights.begin(), pose.weights.end());
    if (!weights.empty())
        weights_.upload(std::as_bytes(std::span(weights)));
    program.use();
    program.set("part_count", static_cast<GLuint>(motion.parts.size()));
    program.set("vertex_count", vertex_count);
    const Buffer* const read[] = {&parts_, &rest_, &influences_, &deltas_, &palette_, &weights_};
    GLuint slot = 0;
    for (const Buffer* buffer : read)
        buffer->bind(GL_SHADER_STORAGE_BUFFER, slot++);
    const size_t first = sizeof(glm::vec3) * motion.first_vertex;
    const size_t skipped = scene.positions().bind_storage_from(slot++, first);
    scene.normals().bind_storage_from(slot, first);
    program.set("first_float", static_cast<GLuint>((first - skipped) / sizeof(float)));
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT); // the last frame has read before
    program.dispatch_covering({std::min(vertex_count, gpu::kDeformRow),
                               (vertex_count + gpu::kDeformRow - 1) / gpu::kDeformRow, 1});
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                    GL_TEXTURE_FETCH_BARRIER_BIT);
}

StructureBytes Deform::bytes() const {
    size_t all = 0;
    for (const Buffer* buffer : {&parts_, &rest_, &influences_, &deltas_, &palette_, &weights_})
        all += buffer->bytes();
    return {"motion", all};
}

} // namespace romascope
