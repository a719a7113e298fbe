// SPDX-License-Identifier: MIT
#include "renderer/tracers/dda/dda_tracer.h"
#include "renderer/tracers/dda2d/dda2d_tracer.h"
#include "renderer/tracers/occupancy/occupancy_map.h"
#include "renderer/tracers/roma/roma_tracer.h"
#include "renderer/tracers/samples/samples_tracer.h"
#include "renderer/tracers/tracer.h"

#include <algorithm>

namespace romascope {

const std::vector<TracerEntry>& tracers() {
    static const std::vector<TracerEntry> entries = {
        {"roma",
         "ray-aligned occupancy map array (Zeng et al. 2023), aligned by rotation or by shear",
         make_roma_tracer, roma_knobs},
        {"dda", "cell by cell through the base occupancy map: exact about its cells",
         make_dda_tracer, dda_knobs},
        {"dda2d", "texel by texel through the base occupancy map (Thiedemann et al. 2011)",
         make_dda2d_tracer, dda2d_knobs},
        {"samples", "a fixed number of cells along the ray (Reinbothe et al. 2009)",
         make_samples_tracer, samples_knobs},
    };
    return entries;
}

bool is_of_other_tracer(const KnobBase& knob, std::string_view chosen) {
    bool of_any = false;
    for (const TracerEntry& tracer : tracers()) {
        const std::vector<const KnobBase*> own = tracer.knobs();
        if (std::ranges::find(own, &knob) == own.end())
            continue;
        if (tracer.name == chosen)
            return false;
        of_any = true;
    }
    return of_any;
}

std::vector<const KnobBase*> tracer_knobs() {
    std::vector<const KnobBase*> all = occupancy_knobs();
    for (const TracerEntry& entry : tracers())
        for (const KnobBase* knob : entry.knobs())
            all.push_back(knob);
    return all;
}

} // namespace romascope
