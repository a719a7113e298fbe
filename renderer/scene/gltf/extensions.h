// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace romascope::gltf {

/// Checks asset.version, asset.minVersion and extensionsRequired; comes before all other checks,
/// as what they say tells how the rest is to be read. Adds a line to `notices` for each extension
/// in use that is not drawn. Throws Error (kBadInput).
void check_versions(const nlohmann::json& file, std::vector<std::string>& notices);

} // namespace romascope::gltf
