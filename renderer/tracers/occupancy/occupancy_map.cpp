// SPDX-License-Identifier: MIT
#include "renderer/tracers/occupancy/occupancy_map.h"

#include "shaders/common/random.h"

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
    return {&kOccupancyResolution, &kOccupancyJitter, &kOccupancyBuilder,
            &kOccupancyCoverage,   &kOccupancyAxes,   &kOccupancyInvocations};
}

void OccupancyMap::build(const FrameContext& frame, BaseStore store) {
    const int resolution = frame.settings.get(kOccupancyResolution);
    const auto amount = static_cast<float>(frame.settings.get(kOccupancyJitter));
    grid_ = OccupancyGrid::fit(frame.scene.bounds(), resolution, jitter_of_frame(frame, amount));
    if (map_.cells() != grid_.size || map_.store() != store)
        map_ = BaseMap(store, grid_.size);
    const bool in_compute = frame.settings.get(kOccupancyBuilder) == OccupancyBuilder::compute &&
                            ComputeBuilder::takes(frame.scene);
    if (!in_compute)
        compute_ = ComputeBuilder(); // its memory

    auto pass =
        in_compute ? frame.timer.compute("occupancy map") : frame.timer.raster("occupancy map");
    pass.repeat([&] {
        // The last frame's atomics come before.
        glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
        map_.clear();
        if (in_compute)
            compute_.build(frame, grid_, map_);
        else
            raster_.build(frame, grid_, map_);
        glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                        GL_SHADER_STORAGE_BARRIER_BIT);
    });
}

size_t OccupancyMap::bytes_needed(const Settings& settings) {
    const Bounds cube{glm::vec3(0.0f), glm::vec3(1.0f)};
    const glm::ivec3 size =
        OccupancyGrid::fit(cube, settings.get(kOccupancyResolution), glm::vec3(0.0f)).size;
    const size_t map =
        sizeof(uint32_t) * static_cast<size_t>(size.x) * size.y * ((size.z + 31) / 32);
    return settings.get(kOccupancyBuilder) == OccupancyBuilder::compute
               ? map + ComputeBuilder::bytes_needed()
               : map;
}

std::vector<ShaderVariant> OccupancyMap::variants() {
    std::vector<ShaderVariant> all = RasterBuilder::variants();
    for (ShaderVariant& variant : ComputeBuilder::variants())
        all.push_back(std::move(variant));
    return all;
}

} // namespace romascope
