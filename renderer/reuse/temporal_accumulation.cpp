// SPDX-License-Identifier: MIT
#include "renderer/reuse/temporal_accumulation.h"

#include <cmath>

namespace romascope {

ShaderVariant TemporalAccumulation::variant(bool motion) {
    return {"temporal accumulation",
            {{GL_COMPUTE_SHADER, "reuse/temporal_accumulation.comp.glsl"}},
            {{"MOTION", motion ? "1" : "0"}},
            {}};
}

ShaderVariant TemporalAccumulation::clamp_variant(bool clamped) {
    return {"temporal clamp",
            {{GL_COMPUTE_SHADER, "reuse/temporal_clamp.comp.glsl"}},
            {{"CLAMPED", clamped ? "1" : "0"}},
            {}};
}

void TemporalAccumulation::run(const FrameContext& frame, const View& view, const GBuffer& gbuffer,
                               const SurfaceHistory& before, const Texture& value) {
    const glm::ivec3 size = value.size();
    if (history_.size() != size) {
        accumulated_ = Texture("temporal accumulation", GL_TEXTURE_2D, GL_RGBA32F, size);
        history_ = Texture("temporal history", GL_TEXTURE_2D, GL_RGBA32F, size);
        result_ = Texture("temporal result", GL_TEXTURE_2D, GL_R16, size);
        reset();
    }
    const auto longest = static_cast<float>(frame.settings.get(kTemporalLength));
    const auto fastest = static_cast<float>(frame.settings.get(kTemporalFastLength));
    const double deviations = frame.settings.get(kTemporalClamp);
    const bool clamped = deviations < static_cast<double>(std::numeric_limits<float>::max());
    const Program& accumulate = program_.get(frame.shaders, variant(gbuffer.motion().id() != 0));
    const Program& clamp = clamp_program_.get(frame.shaders, clamp_variant(clamped));

    auto pass = frame.timer.compute("temporal accumulation");
    accumulate.use();
    before.bind(accumulate, frame, view, gbuffer);
    accumulate.set("has_history", has_history_ && before.is_of(view.size) ? 1 : 0);
    accumulate.set("longest", longest);
    accumulate.set("fastest", fastest);
    value.bind(5);
    history_.bind(6);
    accumulated_.bind_image(0, GL_WRITE_ONLY);
    accumulate.dispatch_covering(size);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);

    clamp.use();
    view.set_uniforms(clamp);
    set_edge_uniforms(clamp, view, frame.settings.get(kHistoryPlaneDistance),
                      frame.settings.get(kHistoryNormalAngle));
    clamp.set("deviations", static_cast<float>(deviations));
    clamp.set("fastest", fastest);
    accumulated_.bind(5);
    history_.bind_image(0, GL_WRITE_ONLY);
    result_.bind_image(1, GL_WRITE_ONLY);
    clamp.dispatch_covering(size);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    has_history_ = true;
}

void TemporalAccumulation::release() {
    for (Texture* texture : {&accumulated_, &history_, &result_})
        *texture = {};
    reset();
}

} // namespace romascope
