// SPDX-License-Identifier: MIT
#include "renderer/reuse/spatial_hash/cell_renewal.h"

#include "renderer/estimators/ambient_occlusion/ambient_occlusion.h"
#include "renderer/tracers/occupancy/bit_grid.h"
#include "renderer/tracers/occupancy/occupancy_knobs.h"
#include "shaders/reuse/spatial_hash/cell_state.h"
#include "shaders/reuse/spatial_hash/stale_cells.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace romascope {
namespace {

static_assert(gpu::kMaxAge == gpu::kOldestUse);

/// Of an occupancy cell: smaller moves change the map less than its jitter does.
constexpr float kToleratedCells = 0.25f;
/// Occupancy cells by which what a ray finds may lie nearer than what moved. A ray whose last cell
/// is entered at one corner while what moved touches the opposite one alone, 1.73 away, is left
/// out.
constexpr float kTracedCells = 1.0f;

} // namespace

bool CellRenewal::follow(const FrameContext& frame, uint32_t max_age) {
    if (!begun_)
        return false;
    if (std::exchange(moved_, false)) {
        if (!changes_.has_begun() || !changes_.covers(frame.scene.bounds()))
            return false;
        changes_.update(frame, reaches(frame.settings), tolerance_);
        needed_ = true;
    }
    const uint32_t oldest = std::max(max_age, std::exchange(max_age_, max_age));
    // Ages beyond kMaxAge are not told apart.
    needed_ = needed_ && (oldest >= gpu::kMaxAge || frame.frame - changes_.last_change() <= oldest);
    return true;
}

void CellRenewal::begin(const FrameContext& frame) {
    const Settings& settings = frame.settings;
    begun_ = moved_ = needed_ = false; // until all is there
    const float radius = ambient_occlusion_radius(settings);
    if (!first_vertex_ || !std::isfinite(radius) || !ChangeVolume::takes(frame.scene)) {
        changes_.release();
        begun_ = true;
        return;
    }
    const auto map_cell = [&](const Bounds& bounds) {
        return OccupancyGrid::fit(bounds, settings.get(kOccupancyResolution), glm::vec3(0.0f))
            .cell_size;
    };
    const float cell = map_cell(frame.scene.bounds());
    changes_.begin(frame, *first_vertex_, radius + kTracedCells * cell);
    tolerance_ = kToleratedCells * cell;
    // The scene may come to fill the volume, and the map's cells grow with it.
    cell_reach_ = radius + kTracedCells * map_cell(changes_.bounds());
    // Cells up to a block share the first reach.
    const float block = 1.0f / changes_.grid().blocks_per_metre;
    first_level_ = gpu::cell_level(block / smallest_cell_size(settings));
    begun_ = true;
}

void CellRenewal::release() {
    changes_.release();
    begun_ = moved_ = needed_ = false;
}

void CellRenewal::bind(const Program& program) const {
    changes_.bind(program);
    program.set("cell_reach", cell_reach_);
    program.set("first_level", first_level_);
}

ChangeVolume::Reaches CellRenewal::reaches(const Settings& settings) const {
    const auto jitter = static_cast<float>(settings.get(kHashJitter));
    ChangeVolume::Reaches reaches{};
    for (int i = 0; i < gpu::kReaches; ++i)
        reaches[static_cast<size_t>(i)] = cell_reach_ + smallest_cell_size(settings) *
                                                            gpu::power_of_two(first_level_ + i) *
                                                            gpu::cell_radius(jitter);
    return reaches;
}

} // namespace romascope
