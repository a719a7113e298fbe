// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/shader_source.h"

#include <vector>

namespace romascope {

/// Every shader variant that some settings can ask for, up to numbers that do not change which
/// lines are compiled: each choice of each knob that reaches a shader, each tracer, each resolution
/// that lays out its maps in another way. For tests that compile them all.
std::vector<ShaderVariant> all_shader_variants();

} // namespace romascope
