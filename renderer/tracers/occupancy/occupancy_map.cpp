// SPDX-License-Identifier: MIT
#include "renderer/tracers/occupancy/occupancy_map.h"

#include "shaders/common/random.h"

#include <algorithm>

namespace romascope {
namespace {

/// Where this frame's grid lies, in [0, amount)^3 cells: R2-like steps in three dimensions (Roberts
/// 2018), which spread evenly from the first frames on.
glm::vec3 jitter_of_frame(const FrameContext& frame, float amount) {
    constexpr uint32_t kSteps[3] = {3518319155u, 2882110345u, 2360945575u};
    glm::vec3 jitter;
    for (uint32_t axis = 0; axis < 3; ++axis) {
        const uint32_t shift = gpu::pcg_hash(frame.seed + gpu::pcg_hash(0x6f6d6170u + axis));
        jitter[static_cast<int>(axis)] =
            amount * gpu::unit_float(kSteps[axis] * frame.frame + shift);
    }
    return jitter;
}

} // namespace

std::vector<const KnobBase*> occupancy_knobs() {
    return {&kOccupancyResolution, &kOccupancyJitter, &kOccupancyAxes};
}

ShaderVariant OccupancyMap::variant(bool masked) {
    return {masked ? "voxelize masked" : "voxelize",
            {{GL_VERTEX_SHADER, "tracers/occupancy/voxelize.vert.glsl"},
             {GL_FRAGMENT_SHADER, "tracers/occupancy/voxelize.frag.glsl"}},
            {{"ALPHA_MASK", masked ? "1" : "0"}},
            {}};
}

void OccupancyMap::build(const FrameContext& frame) {
    const int resolution = frame.settings.get(kOccupancyResolution);
    const auto amount = static_cast<float>(frame.settings.get(kOccupancyJitter));
    grid_ = OccupancyGrid::fit(frame.scene.bounds(), resolution, jitter_of_frame(frame, amount));
    const glm::ivec3 texels(grid_.size.x, grid_.size.y, (grid_.size.z + 31) / 32);
    if (texture_.size() != texels)
        texture_ = Texture("occupancy map", GL_TEXTURE_3D, GL_R32UI, texels);
    if (framebuffer_side_ != resolution) {
        framebuffer_ = Framebuffer("occupancy map", glm::ivec2(resolution));
        framebuffer_side_ = resolution;
    }
    const GpuScene& scene = frame.scene;
    const bool any_masked = std::ranges::any_of(scene.groups(), &TriangleGroup::masked);
    const Program& plain = program_.get(frame.shaders, variant(false));
    const Program& masked = any_masked ? masked_program_.get(frame.shaders, variant(true)) : plain;

    auto pass = frame.timer.raster("occupancy map");
    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT); // the last frame's atomics come before
    texture_.clear_uint(0);
    framebuffer_.bind();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    texture_.bind_image(0, GL_READ_WRITE);
    if (any_masked)
        scene.surfaces().bind();
    const bool all = frame.settings.get(kOccupancyAxes) == OccupancyAxes::all;
    for (const TriangleGroup& group : scene.groups()) {
        const Program& program = group.masked ? masked : plain;
        program.use();
        program.set("grid_origin", grid_.origin);
        program.set("cells_per_metre", 1.0f / grid_.cell_size);
        program.set("grid_size", grid_.size);
        for (int axis = all ? 0 : 2; axis < 3; ++axis) {
            program.set("axis", axis);
            glViewport(0, 0, grid_.size[(axis + 1) % 3], grid_.size[(axis + 2) % 3]);
            scene.draw(group);
        }
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

size_t OccupancyMap::bytes_needed(const Settings& settings) {
    const Bounds cube{glm::vec3(0.0f), glm::vec3(1.0f)};
    const glm::ivec3 size =
        OccupancyGrid::fit(cube, settings.get(kOccupancyResolution), glm::vec3(0.0f)).size;
    return sizeof(uint32_t) * static_cast<size_t>(size.x) * size.y * ((size.z + 31) / 32);
}

BitGrid OccupancyMap::download() const { return BitGrid(grid_.size, texture_.download_uint(1)); }

} // namespace romascope
