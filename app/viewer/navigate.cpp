// SPDX-License-Identifier: MIT
#include "app/viewer/navigate.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace romascope {
namespace {

constexpr double kOrbitPerHeight = glm::pi<double>(); ///< radians for a drag over the window
constexpr double kNearerPerNotch = 1.12;              ///< of the wheel
/// How far the wheel goes away: in a view of 45 degrees the scene is then an eighth of the height.
/// Farther off there is nothing to see, and a way back of many notches.
constexpr double kFarthestDiagonals = 10.0;
constexpr double kDiagonalsPerSecond = 0.12, kFaster = 4.0;
/// Seconds of flying in one frame: a slow one must not throw the eye across the scene.
constexpr double kLongestStep = 0.5;

} // namespace

CameraMove camera_move(const Window& window, const WindowInput& input, bool mouse, bool keyboard) {
    CameraMove move;
    move.fast = window.is_down(GLFW_KEY_LEFT_SHIFT) || window.is_down(GLFW_KEY_RIGHT_SHIFT);
    if (mouse) {
        const auto way = [&](size_t button) {
            return input.drag[button] / static_cast<double>(std::max(window.size().y, 1));
        };
        (move.fast ? move.pan : move.orbit) = way(GLFW_MOUSE_BUTTON_LEFT);
        move.pan += way(GLFW_MOUSE_BUTTON_MIDDLE);
        move.look = way(GLFW_MOUSE_BUTTON_RIGHT);
        move.wheel = input.wheel;
    }
    const bool control =
        window.is_down(GLFW_KEY_LEFT_CONTROL) || window.is_down(GLFW_KEY_RIGHT_CONTROL);
    if (keyboard && !control) {
        const auto axis = [&](int more, int less) {
            return std::clamp(input.held_seconds(more) - input.held_seconds(less), -kLongestStep,
                              kLongestStep);
        };
        move.fly = {axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q),
                    axis(GLFW_KEY_W, GLFW_KEY_S)};
    }
    return move;
}

bool is_still(const CameraMove& move) {
    const glm::dvec2 none(0.0);
    return move.orbit == none && move.look == none && move.pan == none && move.wheel == 0.0 &&
           move.fly == glm::dvec3(0.0);
}

Viewpoint moved(Viewpoint viewpoint, const CameraMove& move, double diagonal) {
    // The scene follows the mouse: dragged to the right, one stands further to its left.
    if (move.orbit != glm::dvec2(0.0))
        viewpoint.orbit(kOrbitPerHeight * move.orbit.x, -kOrbitPerHeight * move.orbit.y);
    const double fov = glm::radians(viewpoint.fov);
    if (move.look != glm::dvec2(0.0))
        viewpoint.look(fov * move.look.x, -fov * move.look.y);
    // What lies as far away as the target stays under the mouse.
    const double height = 2.0 * viewpoint.distance() * std::tan(0.5 * fov);
    if (move.pan != glm::dvec2(0.0))
        viewpoint.walk({-move.pan.x * height, move.pan.y * height, 0.0});
    if (move.wheel != 0.0)
        viewpoint.approach(std::pow(kNearerPerNotch, move.wheel), kFarthestDiagonals * diagonal);
    if (move.fly != glm::dvec3(0.0))
        viewpoint.walk(move.fly * (diagonal * kDiagonalsPerSecond * (move.fast ? kFaster : 1.0)));
    return viewpoint;
}

} // namespace romascope
