// SPDX-License-Identifier: MIT
#pragma once

#include "app/viewer/session.h"
#include "app/viewer/window.h"

namespace romascope {

/// What a hand does to the camera in one frame.
struct CameraMove {
    glm::dvec2 orbit{0.0}; ///< way of the mouse over the height of the window; x right, y down
    glm::dvec2 look{0.0};
    glm::dvec2 pan{0.0};
    double wheel = 0.0;  ///< notches
    glm::dvec3 fly{0.0}; ///< right, up, ahead; seconds that the keys were held
    bool fast = false;
};

/// Mouse and held keys of a window as a move; `mouse`, `keyboard`: whether widgets leave them to
/// the camera.
CameraMove camera_move(const Window& window, const WindowInput& input, bool mouse, bool keyboard);

/// The viewpoint after the move; `diagonal`: of the scene, in metres.
Viewpoint moved(Viewpoint viewpoint, const CameraMove& move, double diagonal);

/// Whether there is anything in it.
bool is_still(const CameraMove& move);

} // namespace romascope
