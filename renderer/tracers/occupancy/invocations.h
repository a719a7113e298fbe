// SPDX-License-Identifier: MIT
// What the building of structures has in common, in which way a device likes it.
#pragma once

#include "renderer/gl/context.h"

namespace romascope {

/// How the work of a structure is split: many small invocations of a shader that share it within a
/// work group, few large ones without barriers, or whichever suits the current context's device.
enum class Invocations { device, many, few };

inline bool wants_many(Invocations wanted) {
    return wanted == Invocations::many || (wanted == Invocations::device && !is_software_context());
}

} // namespace romascope
