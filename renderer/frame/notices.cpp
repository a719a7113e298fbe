// SPDX-License-Identifier: MIT
#include "renderer/frame/notices.h"

#include "renderer/estimators/ambient_occlusion/ambient_occlusion.h"
#include "renderer/passes/compose.h"
#include "renderer/reuse/spatial_hash/hash_knobs.h"
#include "renderer/reuse/temporal_accumulation.h"
#include "renderer/tracers/occupancy/compute_limits.h"
#include "renderer/tracers/occupancy/occupancy_knobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace romascope {
namespace {

/// A view of what a stage keeps, where only a switch of its own makes the stage run.
struct StageView {
    PictureKind kind;
    const Knob<bool>* stage;
};

constexpr StageView kStageViews[] = {{PictureKind::history, &kTemporal}};

uint64_t count_of(const std::vector<NamedCount>& counts, std::string_view name) {
    const auto found = std::ranges::find(counts, name, &NamedCount::name);
    return found == counts.end() ? 0 : found->count;
}

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

std::vector<std::string> notices_of(const Settings& settings,
                                    const std::vector<NamedCount>& counts) {
    const uint64_t failed = count_of(counts, "hash failed pixels");
    const uint64_t rays =
        count_of(counts, "hash rays traced") + count_of(counts, "hash rays saved");
    const uint64_t surfaces = rays / static_cast<uint64_t>(settings.get(kAoRays));
    if (static_cast<double>(failed) <= kToleratedFailures * static_cast<double>(surfaces))
        return {};
    return {fmt::format("hash table full: {} of {} pixels found no room in the last frame and show "
                        "their own rays; pictures may differ from run to run; raise {}",
                        failed, surfaces, kHashCapacity.key())};
}

} // namespace romascope
