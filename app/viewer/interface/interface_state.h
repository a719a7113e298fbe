// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include <filesystem>
#include <optional>
#include <string>

namespace romascope {

/// What of the interface is open, and what its fields hold. Not part of what is rendered.
struct InterfaceState {
    bool panel = true;
    bool help = false;
    glm::ivec2 shot_size{3840, 2160}; ///< of a screenshot at another size than the window's
    std::string filter;               ///< of the list of knobs
};

/// What goes on beside the frames, for the panel to show.
struct Activity {
    std::optional<double> screenshot; ///< the part that is done of one that takes several frames
    bool saved_settings = false;      ///< there are settings to start with, other than the defaults
};

/// What the panel or a key asks for; done after the frame's widgets are laid out.
struct Requests {
    bool copy_command = false;
    bool screenshot = false;       ///< at the window's size
    bool large_screenshot = false; ///< at InterfaceState::shot_size
    bool cancel_screenshot = false;
    bool save_settings = false;   ///< as those that the viewer starts with
    bool forget_settings = false; ///< of the start
    bool reload_shaders = false;
    bool quit = false;
    std::optional<std::string> open; ///< a scene
};

} // namespace romascope
