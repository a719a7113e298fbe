// SPDX-License-Identifier: MIT
#include "renderer/passes/compose.h"

#include <algorithm>
#include <cmath>

namespace romascope {

ShaderVariant Compose::variant(const Settings& settings) {
    return {"compose",
            {{GL_COMPUTE_SHADER, "passes/compose.comp.glsl"}},
            shader_defines(settings, {&kView, &kHighlights}),
            {}};
}

const Texture& Compose::picture_of_size(glm::ivec2 size) {
    const glm::ivec3 extent(size, 1);
    if (picture_.size() != extent)
        picture_ = Texture("picture", GL_TEXTURE_2D, GL_RGBA32F, extent);
    return picture_;
}

void Compose::run(const FrameContext& frame, const View& view, const GBuffer& gbuffer,
                  const SceneLights& lights, const Texture& visibility) {
    picture_of_size(view.size);
    const Program& program = program_.get(frame.shaders, variant(frame.settings));
    const auto azimuth = static_cast<float>(glm::radians(frame.settings.get(kSunAzimuth)));
    const auto elevation = static_cast<float>(glm::radians(frame.settings.get(kSunElevation)));

    auto pass = frame.timer.compute("compose");
    program.use();
    view.set_uniforms(program);
    const LightSource source = frame.settings.get(kLights);
    const bool own_lights =
        source == LightSource::scene || (source == LightSource::automatic && lights.count() > 0);
    lights.bind(0);
    program.set("light_count", own_lights ? lights.count() : 0);
    program.set("sun_shines", own_lights ? 0 : 1);
    program.set("sun_strength", static_cast<float>(frame.settings.get(kSunStrength)));
    program.set("sky_strength", static_cast<float>(frame.settings.get(kSkyStrength)));
    program.set("sun_direction",
                glm::vec3(std::cos(elevation) * std::cos(azimuth), std::sin(elevation),
                          std::cos(elevation) * std::sin(azimuth)));
    program.set("depth_range", static_cast<float>(frame.settings.get(kDepthRange)) *
                                   std::max(frame.scene.rest_diagonal(), 1e-12f));
    gbuffer.bind_surface();
    gbuffer.base_color().bind(2);
    gbuffer.emission().bind(3);
    visibility.bind(4);
    picture_.bind_image(0, GL_WRITE_ONLY);
    program.dispatch_covering(picture_.size());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

} // namespace romascope
