// SPDX-License-Identifier: MIT
#include "renderer/tracers/occupancy/occupancy_map.h"
#include "renderer/tracers/roma/roma_tracer.h"
#include "renderer/tracers/structure_view.h"
#include "renderer/tracers/tracer.h"

namespace romascope {

const std::vector<TracerEntry>& tracers() {
    static const std::vector<TracerEntry> entries = {
        {"roma", "ray-aligned occupancy map array, aligned by rotation (Zeng et al. 2023)",
         make_roma_tracer, roma_knobs},
    };
    return entries;
}

std::vector<const KnobBase*> tracer_knobs() {
    std::vector<const KnobBase*> all = occupancy_knobs();
    for (const TracerEntry& entry : tracers())
        for (const KnobBase* knob : entry.knobs())
            all.push_back(knob);
    for (const KnobBase* knob : structure_view_knobs())
        all.push_back(knob);
    return all;
}

} // namespace romascope
