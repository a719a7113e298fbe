// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace romascope::gltf {

/// Checks a parsed glTF 2.0 file against the specification's schema as far as this program reads
/// it: types, ranges, choices, and that every index names something. Integers written as floats
/// become integers; extras and unknown properties and extensions go. What is odd but can be drawn
/// passes: empty lists, missing bounds, unknown kinds of cameras and lights.
/// Throws Error (kBadInput) with the JSON path of the first fault.
void check_schema(nlohmann::json& file);

} // namespace romascope::gltf
