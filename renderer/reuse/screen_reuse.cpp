// SPDX-License-Identifier: MIT
#include "renderer/reuse/screen_reuse.h"

namespace romascope {

std::vector<const KnobBase*> screen_reuse_knobs() {
    return {&kTemporal,
            &kTemporalLength,
            &kTemporalFastLength,
            &kTemporalClamp,
            &kHistoryPlaneDistance,
            &kHistoryNormalAngle,
            &kAtrous,
            &kAtrousIterations,
            &kAtrousPlaneDistance,
            &kAtrousNormalAngle,
            &kTaa,
            &kTaaLength,
            &kTaaClamp};
}

ShaderVariant ScreenReuse::history_view_variant() {
    return {"history view", {{GL_COMPUTE_SHADER, "reuse/history_view.comp.glsl"}}, {}, {}};
}

bool ScreenReuse::looks_back(const Settings& settings) {
    return settings.get(kTemporal) || settings.get(kTaa);
}

size_t ScreenReuse::bytes_per_pixel(const Settings& settings, bool moves) {
    size_t bytes = 0;
    if (looks_back(settings))
        bytes += moves ? 8 + 16 : 8; // surfaces, and how far they have come
    if (settings.get(kTemporal))
        bytes += 2 * 16 + 2;
    if (settings.get(kAtrous))
        bytes += 2 * 2;
    if (settings.get(kTaa))
        bytes += 2 * 16 + 4;
    return bytes;
}

const Texture& ScreenReuse::filter(const FrameContext& frame, const View& view,
                                   const GBuffer& gbuffer, const Texture& value) {
    const Texture* out = &value;
    if (frame.settings.get(kTemporal)) {
        temporal_.run(frame, view, gbuffer, before_, *out);
        out = &temporal_.result();
    } else {
        temporal_.release();
    }
    if (frame.settings.get(kAtrous))
        return atrous_.run(frame, view, gbuffer, *out);
    atrous_.release();
    return *out;
}

const Texture& ScreenReuse::antialias(const FrameContext& frame, const View& view,
                                      const GBuffer& gbuffer, const Texture& picture) {
    if (frame.settings.get(kTaa))
        return taa_.run(frame, view, gbuffer, before_, picture);
    taa_.release();
    return picture;
}

void ScreenReuse::end_frame(const FrameContext& frame, const View& view, const GBuffer& gbuffer) {
    if (looks_back(frame.settings))
        before_.remember(gbuffer, view);
    else
        before_.release();
}

void ScreenReuse::draw_history(const FrameContext& frame, const View& view, const GBuffer& gbuffer,
                               const Texture& picture) {
    const Program& program = history_view_.get(frame.shaders, history_view_variant());
    auto pass = frame.timer.compute("history view");
    const bool known = frame.settings.get(kTemporal) && temporal_.has_history();
    program.use();
    view.set_uniforms(program);
    gbuffer.bind_surface();
    program.set("has_history", known ? 1 : 0);
    program.set("longest", static_cast<float>(frame.settings.get(kTemporalLength)));
    (known ? temporal_.history() : picture).bind(5);
    picture.bind_image(0, GL_WRITE_ONLY);
    program.dispatch_covering(picture.size());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void ScreenReuse::reset() {
    before_.forget();
    temporal_.reset();
    taa_.reset();
}

std::vector<StructureBytes> ScreenReuse::bytes() const {
    return {before_.bytes(), temporal_.bytes(), atrous_.bytes(), taa_.bytes()};
}

} // namespace romascope
