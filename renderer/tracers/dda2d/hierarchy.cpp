// SPDX-License-Identifier: MIT
#include "renderer/tracers/dda2d/hierarchy.h"

#include "shaders/tracers/dda2d/hierarchy_levels.h"

namespace romascope {
namespace {

glm::ivec3 levels_size(glm::ivec3 base) {
    const int width = gpu::hierarchy_padded(base.x);
    return {gpu::hierarchy_begin(gpu::kHierarchyLevels + 1, width),
            gpu::hierarchy_padded(base.y) / 2, base.z};
}

} // namespace

ShaderVariant Hierarchy::variant() {
    return {
        "occupancy hierarchy", {{GL_COMPUTE_SHADER, "tracers/dda2d/hierarchy.comp.glsl"}}, {}, {}};
}

void Hierarchy::build(const FrameContext& frame, const Texture& base) {
    const glm::ivec3 size = levels_size(base.size());
    if (texture_.size() != size)
        texture_ = Texture("occupancy hierarchy", GL_TEXTURE_3D, GL_R32UI, size);
    const Program& program = program_.get(frame.shaders, variant());
    auto pass = frame.timer.compute("occupancy hierarchy");
    program.use();
    program.set("base_size", base.size());
    base.bind(0);
    texture_.bind_image(0, GL_WRITE_ONLY);
    // An invocation begins with 2 x 2 columns.
    pass.repeat([&] {
        program.dispatch_covering(
            {(base.size().x + 1) / 2, (base.size().y + 1) / 2, base.size().z});
        glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    });
}

size_t Hierarchy::bytes_for(glm::ivec3 base) {
    const glm::ivec3 size = levels_size(base);
    return sizeof(uint32_t) * static_cast<size_t>(size.x) * static_cast<size_t>(size.y) *
           static_cast<size_t>(size.z);
}

} // namespace romascope
