// SPDX-License-Identifier: MIT
#include "renderer/frame/idle_knobs.h"

#include "renderer/tracers/occupancy/occupancy_knobs.h"
#include "renderer/tracers/roma/roma_knobs.h"

#include <fmt/format.h>

namespace romascope {
namespace {

/// `knob` counts only while `other` has this value.
struct Need {
    const KnobBase* knob;
    const KnobBase* other;
    KnobValue value;
};

template <class T>
Need need(const KnobBase& knob, const Knob<T>& other, T value) {
    return {&knob, &other, other.to_value(value)};
}

const std::vector<Need>& needs() {
    static const std::vector<Need> all = {
        need(kRomaTaps, kRomaAlignment, RomaAlignment::shear),
        need(kRomaFit, kRomaAlignment, RomaAlignment::rotate),
        need(kRomaIterations, kRomaSnap, false),
        need(kRomaSampling, kRomaSnap, true),
        need(kOccupancyAxes, kOccupancyBuilder, OccupancyBuilder::raster),
        need(kOccupancyCoverage, kOccupancyBuilder, OccupancyBuilder::compute),
        need(kOccupancyInvocations, kOccupancyBuilder, OccupancyBuilder::compute),
    };
    return all;
}

} // namespace

std::string setting_that_wakes(const KnobBase& knob, const Settings& settings) {
    for (const Need& need : needs())
        if (need.knob == &knob && settings.value(*need.other) != need.value)
            return fmt::format("{}={}", need.other->key(), to_text(need.value));
    return {};
}

} // namespace romascope
