// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/gltf/hierarchy.h"
#include "renderer/scene/gltf/notices.h"

#include <vector>

namespace romascope::gltf {

/// All animations of the file; channels of nodes that are not there, or that move nothing we know,
/// are left out. An animation without a channel stays, so that numbers count as in the file.
/// Throws Error (kBadInput) for keys that do not increase or are not finite, and for outputs that
/// do not fit their keys.
std::vector<Animation> read_animations(const Document& document, const Hierarchy& hierarchy,
                                       MemoryBudget& budget, Notices& notices);

} // namespace romascope::gltf
