// SPDX-License-Identifier: MIT
#include "renderer/tracers/occupancy/occupancy_slice.h"

#include "renderer/tracers/structure_view.h"

namespace romascope {

ShaderVariant OccupancySlice::variant(BaseStore store) {
    return {"occupancy slice",
            {{GL_COMPUTE_SHADER, "tracers/occupancy/slice.comp.glsl"}},
            {BaseMap::define(store)},
            {}};
}

void OccupancySlice::draw(const FrameContext& frame, const OccupancyMap& map,
                          const Texture& picture) {
    const Program& program = program_.get(frame.shaders, variant(map.map().store()));
    auto pass = frame.timer.compute("occupancy slice");
    program.use();
    set_cell_view_uniforms(program, frame.settings, picture);
    program.set("axis", static_cast<int>(frame.settings.get(kViewAxis)));
    program.set("grid_size", map.grid().size);
    map.map().bind(0);
    picture.bind_image(0, GL_WRITE_ONLY);
    program.dispatch_covering(picture.size());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

} // namespace romascope
