// SPDX-License-Identifier: MIT
#include "renderer/frame/notices.h"

#include "renderer/passes/compose.h"
#include "renderer/reuse/temporal_accumulation.h"
#include "renderer/tracers/occupancy/compute_limits.h"
#include "renderer/tracers/occupancy/occupancy_knobs.h"

#include <fmt/format.h>

namespace romascope {
namespace {

/// A view of what a stage keeps, where only a switch of its own makes the stage run.
struct StageView {
    PictureKind kind;
    const Knob<bool>* stage;
};

constexpr StageView kStageViews[] = {{PictureKind::history, &kTemporal}};

} // namespace

std::vector<std::string> notices_of(const Settings& settings, const Scene& scene) {
    std::vector<std::string> all;
    if (settings.get(kOccupancyBuilder) == OccupancyBuilder::compute)
        if (std::string refusal = beyond_compute(scene.positions.size(), scene.triangle_count(),
                                                 query_compute_limits());
            !refusal.empty())
            all.push_back(std::move(refusal));
    for (const StageView& view : kStageViews)
        if (settings.get(kView) == view.kind && !settings.get(*view.stage))
            all.push_back(fmt::format("{}={} has nothing to show without {}=true", kView.key(),
                                      to_text(kView.to_value(view.kind)), view.stage->key()));
    return all;
}

} // namespace romascope
