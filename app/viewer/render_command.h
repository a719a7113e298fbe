// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/settings/settings.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace romascope {

/// The command line, quoted for a shell, that renders what a viewer with these settings shows after
/// `frames` frames. `scene_file`: a built-in scene goes by its name. `shaders`: the folder they are
/// read from, if any.
std::string render_command(const std::filesystem::path& scene_file, const Settings& settings,
                           uint32_t frames, const std::filesystem::path& shaders);

} // namespace romascope
