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
    enum class Moments { many, one }; ///< whether frames may be of several moments
    std::string technique, camera, size, frames, seed, time, fps, animation;
    std::vector<std::filesystem::path> configs;
    std::vector<std::string> assignments;

    /// `size_help`: what has that size; `frames_help`: what the frames are for.
    /// Of one moment, --fps is not in the help; see check_one_moment.
    void add_to(CLI::App& command, const std::string& size_help, const std::string& frames_help,
                Moments moments = Moments::many);

    /// `settings`, then the technique, then the files in their order, then the command line.
    /// Throws Error (kBadInput) for what is no setting or out of its range.
    Settings apply_to(Settings settings) const;

    /// Whether they give that setting a value, be it the default: then it matters not which of
    /// `values`, two or more, it had before. Throws Error (kBadInput) as apply_to does.
    bool decide(const KnobBase& knob, const std::vector<std::string>& values) const;
};

/// Refuses a course of time where all is of one moment. Throws Error (kBadInput).
void check_one_moment(const Settings& settings);

} // namespace romascope
