// SPDX-License-Identifier: MIT
#include "renderer/passes/gbuffer.h"

namespace romascope {

ShaderVariant GBuffer::variant() {
    return {"gbuffer",
            {{GL_VERTEX_SHADER, "passes/gbuffer.vert.glsl"},
             {GL_FRAGMENT_SHADER, "passes/gbuffer.frag.glsl"}},
            {},
            {}};
}

void GBuffer::resize(glm::ivec2 size) {
    if (depth_.size() == glm::ivec3(size, 1))
        return;
    const glm::ivec3 extent(size, 1);
    depth_ = Texture("gbuffer depth", GL_TEXTURE_2D, GL_DEPTH_COMPONENT32F, extent);
    normal_ = Texture("gbuffer normal", GL_TEXTURE_2D, GL_R32UI, extent);
    base_color_ = Texture("gbuffer base colour", GL_TEXTURE_2D, GL_SRGB8_ALPHA8, extent);
    emission_ = Texture("gbuffer emission", GL_TEXTURE_2D, GL_R11F_G11F_B10F, extent);
    const Texture* colors[] = {&normal_, &base_color_, &emission_};
    framebuffer_ = Framebuffer("gbuffer", colors, &depth_);
}

void GBuffer::draw(const FrameContext& frame, const View& view) {
    resize(view.size);
    const Program& program = program_.get(frame.shaders, variant());
    auto pass = frame.timer.raster("gbuffer");
    framebuffer_.bind();
    const GLuint no_normal[4] = {};
    const GLfloat black[4] = {};
    const GLfloat far = 0.0f;
    glClearNamedFramebufferuiv(framebuffer_.id(), GL_COLOR, 0, no_normal);
    glClearNamedFramebufferfv(framebuffer_.id(), GL_COLOR, 1, black);
    glClearNamedFramebufferfv(framebuffer_.id(), GL_COLOR, 2, black);
    glDepthMask(GL_TRUE);
    glClearNamedFramebufferfv(framebuffer_.id(), GL_DEPTH, 0, &far);

    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    program.use();
    Camera at_origin = view.camera;
    at_origin.eye = glm::vec3(0.0f);
    program.set("eye", view.camera.eye);
    program.set("view_projection",
                at_origin.projection(view.size, view.near_plane, view.offset) * at_origin.view());
    frame.scene.materials().bind(GL_SHADER_STORAGE_BUFFER, 0);
    frame.scene.draw();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);
}

void GBuffer::bind_surface() const {
    depth_.bind(0);
    normal_.bind(1);
}

StructureBytes GBuffer::bytes() const {
    return {"gbuffer", depth_.bytes() + normal_.bytes() + base_color_.bytes() + emission_.bytes()};
}

} // namespace romascope
