// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/scene.h"
#include "renderer/settings/settings.h"

#include <string>
#include <vector>

namespace romascope {

/// What the settings ask for and does not come, a line each, which goes on after the scene's name:
/// what the current context's driver cannot do with a scene of this size, so that it is done in
/// another way; a view of a stage that is off.
std::vector<std::string> notices_of(const Settings& settings, const Scene& scene);

} // namespace romascope
