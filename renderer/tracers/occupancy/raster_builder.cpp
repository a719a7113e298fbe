// SPDX-License-Identifier: MIT
#include "renderer/tracers/occupancy/raster_builder.h"

#include "renderer/tracers/occupancy/occupancy_knobs.h"

#include <algorithm>

namespace romascope {
namespace {

ShaderVariant variant(bool masked, BaseStore store) {
    return {masked ? "voxelize masked" : "voxelize",
            {{GL_VERTEX_SHADER, "tracers/occupancy/voxelize.vert.glsl"},
             {GL_FRAGMENT_SHADER, "tracers/occupancy/voxelize.frag.glsl"}},
            {{"ALPHA_MASK", masked ? "1" : "0"}, BaseMap::define(store)},
            {}};
}

} // namespace

void RasterBuilder::build(const FrameContext& frame, const OccupancyGrid& grid,
                          const BaseMap& map) {
    const int side = std::max({grid.size.x, grid.size.y, grid.size.z});
    if (framebuffer_side_ != side) {
        framebuffer_ = Framebuffer("occupancy map", glm::ivec2(side));
        framebuffer_side_ = side;
    }
    const GpuScene& scene = frame.scene;
    const bool any_masked = std::ranges::any_of(scene.groups(), &TriangleGroup::masked);
    const Program& plain = program_.get(frame.shaders, variant(false, map.store()));
    const Program& masked =
        any_masked ? masked_program_.get(frame.shaders, variant(true, map.store())) : plain;

    framebuffer_.bind();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    map.bind_image(0, GL_READ_WRITE);
    if (any_masked)
        scene.surfaces().bind();
    const bool all = frame.settings.get(kOccupancyAxes) == OccupancyAxes::all;
    for (const TriangleGroup& group : scene.groups()) {
        const Program& program = group.masked ? masked : plain;
        program.use();
        program.set("grid_origin", grid.origin);
        program.set("cells_per_metre", 1.0f / grid.cell_size);
        program.set("grid_size", grid.size);
        for (int axis = all ? 0 : 2; axis < 3; ++axis) {
            program.set("axis", axis);
            glViewport(0, 0, grid.size[(axis + 1) % 3], grid.size[(axis + 2) % 3]);
            scene.draw(group);
        }
    }
}

std::vector<ShaderVariant> RasterBuilder::variants() {
    return {variant(false, BaseStore::texture), variant(true, BaseStore::texture),
            variant(false, BaseStore::buffer), variant(true, BaseStore::buffer)};
}

} // namespace romascope
