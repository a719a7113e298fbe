// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/scene.h"

#include <string>

namespace romascope::fuzz {

/// What scene.h, motion.h and pose.h promise of an imported scene, at rest and posed at several
/// times of each animation. The first promise that is broken, in words; "" if all are kept.
std::string broken_promise(const Scene& scene);

} // namespace romascope::fuzz
