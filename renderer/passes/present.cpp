// SPDX-License-Identifier: MIT
#include "renderer/passes/present.h"

#include "renderer/image/color.h"
#include "shaders/common/letterbox.h"

namespace romascope {

ShaderVariant Present::variant() {
    return {"present", {{GL_COMPUTE_SHADER, "passes/present.comp.glsl"}}, {}, {}};
}

const Texture& Present::run(const ShaderLibrary& shaders, PassTimer& timer, const Texture& linear) {
    if (linear.size().x == 0)
        return picture_ = Texture();
    if (picture_.size() != linear.size())
        picture_ = Texture("shown picture", GL_TEXTURE_2D, GL_RGBA8, linear.size());
    if (thresholds_.bytes() == 0)
        thresholds_ = Buffer::from<float>("sRGB thresholds", srgb8_thresholds());
    const Program& program = program_.get(shaders, variant());

    auto pass = timer.compute("present");
    program.use();
    program.set("grey", linear.format() == GL_R32F ? 1 : 0);
    program.set("picture_size", glm::ivec2(linear.size()));
    linear.bind(0);
    thresholds_.bind(GL_SHADER_STORAGE_BUFFER, 0);
    picture_.bind_image(0, GL_WRITE_ONLY);
    program.dispatch_covering(linear.size());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
    return picture_;
}

void show(const Texture& picture, GLuint framebuffer, glm::ivec2 framebuffer_size) {
    if (framebuffer_size.x <= 0 || framebuffer_size.y <= 0)
        return;                 // a window that is folded away
    glDisable(GL_SCISSOR_TEST); // it would cut both
    const GLfloat black[4] = {0, 0, 0, 1};
    glClearNamedFramebufferfv(framebuffer, GL_COLOR, 0, black);
    const glm::ivec2 size(picture.size());
    if (size.x == 0)
        return;
    const Texture* const source[] = {&picture};
    const Framebuffer from("shown picture", source, nullptr);
    const glm::ivec2 fitted = gpu::letterbox_size(size, framebuffer_size);
    const glm::ivec2 low = gpu::letterbox_corner(fitted, framebuffer_size);
    const glm::ivec2 high = low + fitted;
    // Rows of a framebuffer go up.
    glBlitNamedFramebuffer(from.id(), framebuffer, 0, 0, size.x, size.y, low.x, high.y, high.x,
                           low.y, GL_COLOR_BUFFER_BIT, fitted == size ? GL_NEAREST : GL_LINEAR);
}

} // namespace romascope
