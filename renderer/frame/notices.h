// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/passes/frame_context.h"
#include "renderer/scene/scene.h"
#include "renderer/settings/settings.h"

#include <string>
#include <vector>

namespace romascope {

/// What the settings ask for and does not come, a line each, which goes on after the scene's name:
/// what the current context's driver cannot do with a scene of this size, so that it is done in
/// another way; a view of a stage that is off.
std::vector<std::string> notices_of(const Settings& settings, const Scene& scene);

/// Share of the pixels that see a surface, above which it is told that they found no room in the
/// spatial hash.
inline constexpr double kToleratedFailures = 0.01;

/// What a frame's counts tell of it that a picture does not, likewise: a hash table that is full.
std::vector<std::string> notices_of(const Settings& settings,
                                    const std::vector<NamedCount>& counts);

} // namespace romascope
