// SPDX-License-Identifier: MIT
#include "renderer/estimators/ambient_occlusion/ambient_occlusion.h"

#include "shaders/common/random.h"

#include <cmath>

namespace romascope {

std::vector<const KnobBase*> ambient_occlusion_knobs() { return {&kAoRadius, &kAoRays}; }

float ambient_occlusion_radius(const Settings& settings) {
    const double radius = settings.get(kAoRadius);
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    return radius > std::numeric_limits<float>::max() ? kInfinity : static_cast<float>(radius);
}

ShaderVariant AmbientOcclusion::variant(const Settings& settings, const Tracer& tracer,
                                        bool listed) {
    std::vector<ShaderDefine> defines = tracer.shader_defines(settings);
    for (ShaderDefine& define : shader_defines(settings, {&kAoRays}))
        defines.push_back(std::move(define));
    defines.push_back({"AO_UNBOUNDED", std::isinf(ambient_occlusion_radius(settings)) ? "1" : "0"});
    defines.push_back({"SAMPLE_CANDIDATES", tracer.sample_candidates(settings) ? "1" : "0"});
    defines.push_back({"AO_LISTED", listed ? "1" : "0"});
    return {"ambient occlusion",
            {{GL_COMPUTE_SHADER, "estimators/ambient_occlusion.comp.glsl"}},
            defines,
            {{"tracer.glsl", tracer.shader_file()}}};
}

const Texture& AmbientOcclusion::visibility_of_size(glm::ivec2 size) {
    const glm::ivec3 extent(size, 1);
    if (visibility_.size() != extent)
        visibility_ = Texture("visibility", GL_TEXTURE_2D, GL_R16, extent);
    return visibility_;
}

void AmbientOcclusion::run(const FrameContext& frame, const View& view, const GBuffer& gbuffer,
                           const Tracer& tracer, const PixelList* list) {
    const Texture& visibility = visibility_of_size(view.size);
    const Program& program =
        program_.get(frame.shaders, variant(frame.settings, tracer, list != nullptr));

    auto pass = frame.timer.compute("ambient occlusion");
    program.use();
    view.set_uniforms(program);
    program.set("seed_key", gpu::pcg_hash(frame.seed));
    program.set("frame", frame.frame);
    gbuffer.bind_surface();
    program.set("radius", ambient_occlusion_radius(frame.settings));
    tracer.bind(program);
    visibility.bind_image(0, GL_WRITE_ONLY);
    pass.repeat([&] {
        if (list)
            list->dispatch();
        else
            program.dispatch_covering(visibility.size());
        glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    });
}

} // namespace romascope
