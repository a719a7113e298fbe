// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

namespace romascope {

/// What a key does.
enum class KeyAction {
    help,
    panel,
    play,
    step_back,
    step_on,
    scene_camera,
    fit,
    screenshot,
    large_screenshot,
    copy_command,
    begin_anew,
    reset_all,
    reload_shaders,
    quit,
};

struct KeyBinding {
    KeyAction action;
    int key = 0;           ///< GLFW_KEY_...; of scene_camera the first of nine
    int mods = 0;          ///< GLFW_MOD_..., and no other of Control, Shift, Alt and Super
    bool repeats = false;  ///< as long as the key is held
    std::string_view name; ///< as people read it: "Ctrl+C"
    std::string_view help;
};

/// All of them, in the order of the help.
std::span<const KeyBinding> key_bindings();

/// A move of the mouse or a key that is held, for the help alone.
struct Gesture {
    std::string_view name;
    std::string_view help;
};
std::span<const Gesture> gestures();

} // namespace romascope
