// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/settings/settings.h"

#include <string>

namespace romascope {

/// One line `#define NAME VALUE`.
struct ShaderDefine {
    std::string name, value;
    friend bool operator==(const ShaderDefine&, const ShaderDefine&) = default;
};

/// The values of these knobs for a shader, in this order. The name is the key in capitals with
/// underscores for dots: `roma.angular_resolution` is ROMA_ANGULAR_RESOLUTION.
/// Boolean: 0 or 1. Integer: an int literal. Real: a float literal with the bits of the value
/// rounded to float; infinity as `uintBitsToFloat(0x7F800000u)`. Choice: its index, followed by one
/// define per choice: ROMA_SAMPLING 1, ROMA_SAMPLING_SNAP 0, ROMA_SAMPLING_CANDIDATES 1.
/// Negative numbers are in parentheses.
/// Throws std::logic_error for a text knob, an integer knob whose range does not fit an int of
/// GLSL, a name that GLSL keeps for itself (GL_...), and two defines of the same name.
std::vector<ShaderDefine> shader_defines(const Settings& settings,
                                         const std::vector<const KnobBase*>& knobs);

} // namespace romascope
