// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/motion.h"

namespace romascope::gltf {

/// A bound, in metres, on how far from the origin any vertex, camera or light of the motion can
/// come at any time; far above what happens, but finite if all poses are.
double reach(const Motion& motion);

} // namespace romascope::gltf
