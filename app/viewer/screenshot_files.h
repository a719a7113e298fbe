// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace romascope {

/// Where screenshots go: romascope/ in the user's folder of pictures ($XDG_PICTURES_DIR, also of
/// user-dirs.dirs, or ~/Pictures if there is one), else below state_directory(). Not created.
std::filesystem::path screenshot_folder();

/// A file that does not exist yet, named after the scene and the time of day:
/// "hall-20261122-083015.png", "hall-20261122-083015-2.png".
std::filesystem::path new_screenshot_file(const std::filesystem::path& folder,
                                          const std::filesystem::path& scene_file);

} // namespace romascope
