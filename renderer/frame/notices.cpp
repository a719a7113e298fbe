// SPDX-License-Identifier: MIT
#include "renderer/frame/notices.h"

#include "renderer/tracers/occupancy/compute_builder.h"

namespace romascope {

std::vector<std::string> notices_of(const Settings& settings, const GpuScene& scene) {
    if (settings.get(kOccupancyBuilder) != OccupancyBuilder::compute)
        return {};
    std::string refusal = ComputeBuilder::refusal(scene);
    if (refusal.empty())
        return {};
    return {std::move(refusal)};
}

} // namespace romascope
