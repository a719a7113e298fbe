// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/scene.h"

#include <limits>

namespace romascope {

/// Finds the nearest place from which a camera sees all points that were added: from in front, to
/// the right and a little above, 45 degrees from the lower to the upper edge. In a picture of 16:9,
/// points touch a margin of 5 % of the picture's width or height, and none lies in it. The
/// eye keeps a hundredth of the points' extent off the nearest of them.
class ViewFit {
public:
    ViewFit();
    void add(glm::vec3 point);
    void add(const Bounds& box);
    /// Named "default". At least one point must have been added.
    Camera camera() const;

private:
    glm::dvec3 right_, up_, back_; ///< unit axes of the camera; `back_` from the scene to the eye
    /// Largest offsets of planes through points that will bound the picture: their normals lean by
    /// the slope of the picture's right, left, upper and lower edge.
    double right_edge_ = kNone, left_edge_ = kNone, upper_edge_ = kNone, lower_edge_ = kNone;
    double nearest_ = kNone; ///< along `back_`
    Bounds bounds_;

    static constexpr double kNone = -std::numeric_limits<double>::infinity();
};

/// The camera of a scene that has none: sees every vertex of a triangle and, of what moves, boxes
/// around it at a few times of the first animation. Throws as
/// MovingBounds::at does.
Camera fit_camera(const Scene& scene);

} // namespace romascope
