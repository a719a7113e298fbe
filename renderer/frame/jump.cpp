// SPDX-License-Identifier: MIT
#include "renderer/frame/jump.h"

#include "renderer/frame/technique.h"
#include "renderer/passes/compose.h"
#include "renderer/reuse/running_mean.h"
#include "renderer/reuse/screen_reuse.h"
#include "renderer/reuse/spatial_hash/hash_knobs.h"
#include "renderer/tracers/structure_view.h"

#include <algorithm>

namespace romascope {
namespace {

bool is_among(const std::vector<const KnobBase*>& knobs, const KnobBase* knob) {
    return std::ranges::find(knobs, knob) != knobs.end();
}

/// Camera and time move what is seen, which reprojection follows; how long the mean is, or whether
/// there is one, is nothing that a single frame knows.
Jump jump_of(const KnobBase* knob) {
    static const std::vector<const KnobBase*> leave_all = {
        &kCamera, &kTime, &kFps, &kFrames, &kAntialias, &kMean, &kTaa, &kTaaLength, &kTaaClamp};
    if (is_among(leave_all, knob))
        return Jump::none;
    if (chooses_view(*knob) || is_among(screen_reuse_knobs(), knob))
        return Jump::picture;
    return Jump::everything;
}

} // namespace

bool chooses_view(const KnobBase& knob) {
    return &knob == &kHashView || is_among(compose_knobs(), &knob) ||
           is_among(structure_view_knobs(), &knob);
}

Jump jump_between(const Settings& before, const Settings& now) {
    Jump jump = Jump::none;
    if (before == now)
        return jump;
    for (const KnobBase* knob : now.table().all())
        if (before.value(*knob) != now.value(*knob))
            jump = std::max(jump, jump_of(knob));
    return jump;
}

} // namespace romascope
