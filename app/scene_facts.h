// SPDX-License-Identifier: MIT
// What a scene is made of: for `romascope info SCENE` and for the report of a render.
#pragma once

#include "renderer/scene/scene.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace romascope {

inline constexpr const char* kSceneSchema = "romascope-scene/1";

/// The fields `scene.*` of a report (docs/user/report.md).
nlohmann::ordered_json scene_summary(const Scene& scene, const std::string& file);

/// Fields `camera.*` of a report.
nlohmann::ordered_json camera_json(const Camera& camera);

/// Everything that `info SCENE --json` tells (docs/user/scenes.md), pretty-printed.
std::string scene_json(const Scene& scene, const std::string& file);

/// The same for people, in columns; long lists are cut.
std::string scene_text(const Scene& scene, const std::string& file);

} // namespace romascope
