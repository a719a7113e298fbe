// SPDX-License-Identifier: MIT
// The settings that a user wants the viewer to start with, kept in config_directory().
#pragma once

#include "renderer/settings/settings.h"

#include <filesystem>

namespace romascope {

/// "viewer.toml" in config_directory(); it need not exist.
std::filesystem::path start_settings_file();

bool has_start_settings();

/// Loads that file, if there is one, over `settings`. True if there is. Throws Error (kBadInput)
/// for a fault in it.
bool load_start_settings(Settings& settings);

/// Keeps the methods and their values; not the scene's camera and time nor the picture's size.
/// Throws Error if the file cannot be written.
void save_start_settings(const Settings& settings);

/// False if there were none. Throws Error if the file cannot be removed.
bool forget_start_settings();

} // namespace romascope
