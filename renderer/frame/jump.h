// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/settings/settings.h"

namespace romascope {

/// What a change of settings makes of frames that were rendered before it.
enum class Jump {
    none,       ///< they are of the same things, perhaps from elsewhere or at another time
    picture,    ///< the picture shows something else; what was estimated holds
    everything, ///< they are of no use
};

/// Whether the knob only chooses what is seen of a frame: nothing that a frame leaves for the next
/// depends on it.
bool chooses_view(const KnobBase& knob);

/// From one frame's settings to the next one's. A knob that is not known to leave something as it
/// was is one that changes everything.
Jump jump_between(const Settings& before, const Settings& now);

} // namespace romascope
