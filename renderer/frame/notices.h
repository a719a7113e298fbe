// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/gpu_scene.h"
#include "renderer/settings/settings.h"

#include <string>
#include <vector>

namespace romascope {

/// What the settings ask for and this driver cannot do with a scene of this size, so that it is
/// done in another way: a line each, which goes on after the scene's name.
std::vector<std::string> notices_of(const Settings& settings, const GpuScene& scene);

} // namespace romascope
