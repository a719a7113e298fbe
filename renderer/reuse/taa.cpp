// SPDX-License-Identifier: MIT
#include "renderer/reuse/taa.h"

#include <utility>

namespace romascope {

ShaderVariant Taa::variant(bool single_channel, bool motion) {
    return {"taa",
            {{GL_COMPUTE_SHADER, "reuse/taa.comp.glsl"}},
            {{"SINGLE_CHANNEL", single_channel ? "1" : "0"}, {"MOTION", motion ? "1" : "0"}},
            {}};
}

const Texture& Taa::run(const FrameContext& frame, const View& view, const GBuffer& gbuffer,
                        const SurfaceHistory& before, const Texture& picture) {
    const bool single = picture.format() != GL_RGBA32F;
    if (history_[0].size() != picture.size() || format_ != picture.format()) {
        for (Texture& history : history_)
            history = Texture("taa history", GL_TEXTURE_2D, GL_RGBA32F, picture.size());
        result_ =
            single ? Texture("taa result", GL_TEXTURE_2D, GL_R32F, picture.size()) : Texture();
        format_ = picture.format();
        reset();
    }
    const Program& program =
        program_.get(frame.shaders, variant(single, gbuffer.motion().id() != 0));

    auto pass = frame.timer.compute("taa");
    program.use();
    before.bind(program, frame, view, gbuffer);
    program.set("has_history", has_history_ && before.is_of(view.size) ? 1 : 0);
    program.set("longest", static_cast<float>(frame.settings.get(kTaaLength)));
    program.set("deviations", static_cast<float>(frame.settings.get(kTaaClamp)));
    picture.bind(5);
    history_[0].bind(6);
    history_[1].bind_image(0, GL_WRITE_ONLY);
    if (single)
        result_.bind_image(1, GL_WRITE_ONLY);
    program.dispatch_covering(picture.size());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    std::swap(history_[0], history_[1]);
    has_history_ = true;
    return single ? result_ : history_[0];
}

void Taa::release() {
    history_ = {};
    result_ = {};
    reset();
}

} // namespace romascope
