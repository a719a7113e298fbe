// SPDX-License-Identifier: MIT
// Moves of a camera by hand. All of them keep the horizon level: y is up.
#pragma once

#include "renderer/scene/bounds.h"
#include "renderer/scene/camera.h"

#include <string>

namespace romascope {

/// Where one stands and what one looks at.
struct Viewpoint {
    glm::dvec3 eye{0.0, 0.0, 1.0};
    glm::dvec3 target{0.0}; ///< what `orbit` turns about; not the eye
    double fov = 45.0;      ///< degrees from the lower to the upper edge

    /// A camera of a scene as a start: its target is where the view passes the scene's middle.
    /// What the camera leans to a side is lost.
    static Viewpoint of(const Camera& camera, const Bounds& scene);

    /// As `render.camera` has it; parse_camera gives the same camera again.
    std::string text() const;

    /// Turns the eye about the target: radians to the right and up.
    void orbit(double right, double up);
    /// Turns the view about the eye: radians to the right and up.
    void look(double right, double up);
    /// Moves eye and target: metres to the right, up and forward as the camera sees it.
    void walk(glm::dvec3 metres);
    /// Comes so many times nearer to the target; below 1: goes away from it, up to `farthest`
    /// metres, or not at all where it is farther already.
    void approach(double times, double farthest = kMaxCoordinate);

    double distance() const { return glm::length(target - eye); }
};

} // namespace romascope
