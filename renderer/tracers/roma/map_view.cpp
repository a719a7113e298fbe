// SPDX-License-Identifier: MIT
#include "renderer/tracers/roma/map_view.h"

#include "renderer/tracers/structure_view.h"

#include <algorithm>

namespace romascope {

ShaderVariant MapView::variant(const Settings& settings, const Tracer& tracer) {
    return {"aligned map view",
            {{GL_COMPUTE_SHADER, "tracers/roma/map_view.comp.glsl"}},
            tracer.shader_defines(settings),
            {{"tracer.glsl", tracer.shader_file()}}};
}

void MapView::draw(const FrameContext& frame, const Tracer& tracer, int map_count,
                   std::string_view name, const Texture& picture) {
    const Program& program = program_.get(frame.shaders, variant(frame.settings, tracer));
    auto pass = frame.timer.compute("aligned map view");
    program.use();
    set_cell_view_uniforms(program, frame.settings, picture);
    program.set("map", std::min(frame.settings.get(kViewMap), map_count - 1));
    program.set("columns", name == kColumns ? 1 : 0);
    tracer.bind(program);
    picture.bind_image(0, GL_WRITE_ONLY);
    program.dispatch_covering(picture.size());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

} // namespace romascope
