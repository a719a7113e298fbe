// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/base/memory.h"

#include <nlohmann/json_fwd.hpp>

#include <string_view>

namespace romascope::gltf {

/// What a JSON text will become, counted without parsing it.
struct JsonSize {
    size_t objects = 0;
    size_t bytes = 0; ///< at most that many in memory, parsed
};

/// Throws Error (kBadInput) if the text is nested deeper than any honest glTF: parsers recurse.
JsonSize measure_json(std::string_view text);

/// Throws Error (kBadInput) that says where the syntax is wrong.
nlohmann::json parse_json(std::string_view text);

} // namespace romascope::gltf
