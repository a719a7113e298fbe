// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include <string>

namespace romascope {

using Json = nlohmann::ordered_json;

inline Json to_json(glm::vec3 v) { return {v.x, v.y, v.z}; }

/// Pretty-printed; names in files may be anything, what is no UTF-8 is replaced.
inline std::string pretty(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace romascope
