// SPDX-License-Identifier: MIT
#include "app/viewer/keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace romascope {

std::span<const KeyBinding> key_bindings() {
    constexpr bool kOnce = false, kRepeats = true;
    static const KeyBinding bindings[] = {
        {KeyAction::help, GLFW_KEY_F1, 0, kOnce, "F1", "this help"},
        {KeyAction::panel, GLFW_KEY_TAB, 0, kOnce, "Tab", "the panel, or only the picture"},
        {KeyAction::scene_camera, GLFW_KEY_1, 0, kOnce, "1 ... 9", "the scene's cameras"},
        {KeyAction::fit, GLFW_KEY_F, 0, kOnce, "F", "fit all of the scene in the view"},
        {KeyAction::play, GLFW_KEY_SPACE, 0, kOnce, "Space", "play the animation, or pause"},
        {KeyAction::step_back, GLFW_KEY_COMMA, 0, kRepeats, ",", "1/30 s back"},
        {KeyAction::step_on, GLFW_KEY_PERIOD, 0, kRepeats, ".", "1/30 s on"},
        {KeyAction::screenshot, GLFW_KEY_F12, 0, kOnce, "F12", "save the picture as it is seen"},
        {KeyAction::large_screenshot, GLFW_KEY_F12, GLFW_MOD_SHIFT, kOnce, "Shift+F12",
         "save it at the size that the panel names"},
        {KeyAction::copy_command, GLFW_KEY_C, GLFW_MOD_CONTROL, kOnce, "Ctrl+C",
         "copy the command that renders this picture"},
        {KeyAction::begin_anew, GLFW_KEY_R, 0, kOnce, "R",
         "begin the picture anew, with an empty spatial hash and no history"},
        {KeyAction::reset_all, GLFW_KEY_R, GLFW_MOD_CONTROL, kOnce, "Ctrl+R", "reset all knobs"},
        {KeyAction::reload_shaders, GLFW_KEY_F5, 0, kOnce, "F5", "look for changed shaders now"},
        {KeyAction::quit, GLFW_KEY_Q, GLFW_MOD_CONTROL, kOnce, "Ctrl+Q", "close the window"},
    };
    return bindings;
}

std::span<const Gesture> gestures() {
    static const Gesture list[] = {
        {"left drag", "turn around what is looked at"},
        {"right drag", "look around"},
        {"middle or Shift+left drag", "move sideways"},
        {"wheel", "come nearer, go away"},
        {"W A S D, Q E", "fly ahead, left, back, right, down, up; with Shift faster"},
        {"drop a file", "open a .gltf or .glb"},
        {"Ctrl+click on a slider", "type a number"},
    };
    return list;
}

} // namespace romascope
