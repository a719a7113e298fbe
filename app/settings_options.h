// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/settings/settings.h"

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace romascope {

/// Options that say what is rendered and how: --technique, --config, --set, --camera, --size,
/// --frames, --seed, --time, --fps, --animation. All are settings by another name.
struct SettingsOptions {
    std::string technique, camera, size, frames, seed, time, fps, animation;
    std::vector<std::filesystem::path> configs;
    std::vector<std::string> assignments;

    /// `size_help`: what has that size; `frames_help`: what the frames are for.
    void add_to(CLI::App& command, const std::string& size_help, const std::string& frames_help);

    /// `settings`, then the technique, then the files in their order, then the command line.
    /// Throws Error (kBadInput) for what is no setting or out of its range.
    Settings apply_to(Settings settings) const;
};

} // namespace romascope
