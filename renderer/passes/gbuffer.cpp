// SPDX-License-Identifier: MIT
#include "renderer/passes/gbuffer.h"

#include <algorithm>

namespace romascope {

ShaderVariant GBuffer::variant(bool detail, bool masked, bool motion) {
    return {masked ? "gbuffer masked" : "gbuffer",
            {{GL_VERTEX_SHADER, "passes/gbuffer.vert.glsl"},
             {GL_FRAGMENT_SHADER, "passes/gbuffer.frag.glsl"}},
            {{"SURFACE_DETAIL", detail || masked ? "1" : "0"},
             {"ALPHA_MASK", masked ? "1" : "0"},
             {"MOTION", motion ? "1" : "0"}},
            {}};
}

void GBuffer::resize(glm::ivec2 size, bool with_motion) {
    if (depth_.size() == glm::ivec3(size, 1) && with_motion == (motion_.id() != 0))
        return;
    const glm::ivec3 extent(size, 1);
    depth_ = Texture("gbuffer depth", GL_TEXTURE_2D, GL_DEPTH_COMPONENT32F, extent);
    normal_ = Texture("gbuffer normal", GL_TEXTURE_2D, GL_R32UI, extent);
    base_color_ = Texture("gbuffer base colour", GL_TEXTURE_2D, GL_SRGB8_ALPHA8, extent);
    emission_ = Texture("gbuffer emission", GL_TEXTURE_2D, GL_R11F_G11F_B10F, extent);
    motion_ =
        with_motion ? Texture("gbuffer motion", GL_TEXTURE_2D, GL_RGBA32F, extent) : Texture();
    const Texture* colors[] = {&normal_, &base_color_, &emission_, &motion_};
    framebuffer_ = Framebuffer("gbuffer", std::span(colors).first(with_motion ? 4 : 3), &depth_);
}

void GBuffer::draw(const FrameContext& frame, const View& view, bool with_motion) {
    resize(view.size, with_motion);
    const GpuScene& scene = frame.scene;
    const Program& plain =
        program_.get(frame.shaders, variant(scene.has_detail(), false, with_motion));
    const bool any_masked = std::ranges::any_of(scene.groups(), &TriangleGroup::masked);
    const Program& masked =
        any_masked ? masked_program_.get(frame.shaders, variant(true, true, with_motion)) : plain;
    auto pass = frame.timer.raster("gbuffer");
    framebuffer_.bind();
    const GLuint no_normal[4] = {};
    const GLfloat black[4] = {};
    const GLfloat far = 0.0f;
    glClearNamedFramebufferuiv(framebuffer_.id(), GL_COLOR, 0, no_normal);
    glClearNamedFramebufferfv(framebuffer_.id(), GL_COLOR, 1, black);
    glClearNamedFramebufferfv(framebuffer_.id(), GL_COLOR, 2, black);
    if (with_motion)
        glClearNamedFramebufferfv(framebuffer_.id(), GL_COLOR, 3, black);
    glDepthMask(GL_TRUE);
    glClearNamedFramebufferfv(framebuffer_.id(), GL_DEPTH, 0, &far);

    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_BLEND);
    glFrontFace(GL_CW); // the projection mirrors
    glCullFace(GL_BACK);
    Camera at_origin = view.camera;
    at_origin.eye = glm::vec3(0.0f);
    const glm::mat4 view_projection =
        at_origin.projection(view.size, view.near_plane, view.offset) * at_origin.view();
    scene.surfaces().bind();
    for (const TriangleGroup& group : scene.groups()) {
        const Program& program = group.masked ? masked : plain;
        program.use();
        program.set("eye", view.camera.eye);
        program.set("view_projection", view_projection);
        if (group.double_sided)
            glDisable(GL_CULL_FACE);
        else
            glEnable(GL_CULL_FACE);
        scene.draw(group);
    }
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);
}

void GBuffer::bind_surface() const {
    depth_.bind(0);
    normal_.bind(1);
}

StructureBytes GBuffer::bytes() const {
    return {"gbuffer", depth_.bytes() + normal_.bytes() + base_color_.bytes() + emission_.bytes() +
                           motion_.bytes()};
}

} // namespace romascope
