// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/settings/settings.h"

namespace romascope {

/// The setting, as KEY=VALUE, without which a knob of a tracer or of the occupancy map decides
/// nothing whatever its value; empty where it counts as the settings are.
std::string setting_that_wakes(const KnobBase& knob, const Settings& settings);

} // namespace romascope
