// SPDX-License-Identifier: MIT
#include "renderer/reuse/running_mean.h"

namespace romascope {

ShaderVariant RunningMean::variant(GLenum format) {
    return {"running mean",
            {{GL_COMPUTE_SHADER, "reuse/running_mean.comp.glsl"}},
            {{"MEAN_FORMAT", format == GL_R32F ? "r32f" : "rgba32f"}},
            {}};
}

void RunningMean::add(const FrameContext& frame, const Texture& value) {
    name_ = "running mean";
    write(frame, value);
}

void RunningMean::take(const FrameContext& frame, const Texture& value) {
    name_ = "last frame";
    reset();
    write(frame, value);
}

void RunningMean::write(const FrameContext& frame, const Texture& value) {
    const GLenum format = value.format() == GL_RGBA32F ? GL_RGBA32F : GL_R32F;
    if (mean_.size() != value.size() || mean_.format() != format) {
        mean_ = Texture("running mean", GL_TEXTURE_2D, format, value.size());
        reset();
    }
    const Program& program = program_.get(frame.shaders, variant(format));
    auto pass = frame.timer.compute(name_);
    program.use();
    program.set("count", ++count_);
    program.set("picture_size", glm::ivec2(value.size()));
    value.bind(0);
    mean_.bind_image(0, GL_READ_WRITE);
    program.dispatch_covering(value.size());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

} // namespace romascope
