// SPDX-License-Identifier: MIT
#include "renderer/reuse/atrous_filter.h"

namespace romascope {

ShaderVariant AtrousFilter::variant() {
    return {"a-trous filter", {{GL_COMPUTE_SHADER, "reuse/atrous_filter.comp.glsl"}}, {}, {}};
}

const Texture& AtrousFilter::run(const FrameContext& frame, const View& view,
                                 const GBuffer& gbuffer, const Texture& value) {
    for (Texture& texture : filtered_)
        if (texture.size() != value.size())
            texture = Texture("a-trous filter", GL_TEXTURE_2D, GL_R16, value.size());
    const Program& program = program_.get(frame.shaders, variant());
    const int iterations = frame.settings.get(kAtrousIterations);

    auto pass = frame.timer.compute("a-trous filter");
    program.use();
    view.set_uniforms(program);
    set_edge_uniforms(program, view, frame.settings.get(kAtrousPlaneDistance),
                      frame.settings.get(kAtrousNormalAngle));
    gbuffer.bind_surface();
    const Texture* from = &value;
    for (int i = 0; i < iterations; ++i) {
        const Texture& to = filtered_[static_cast<size_t>(i % 2)];
        program.set("spacing", 1 << i);
        from->bind(5);
        to.bind_image(0, GL_WRITE_ONLY);
        program.dispatch_covering(value.size());
        glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
        from = &to;
    }
    return *from;
}

} // namespace romascope
