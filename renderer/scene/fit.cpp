// SPDX-License-Identifier: MIT
#include "renderer/scene/fit.h"

#include "renderer/base/error.h"
#include "renderer/scene/pose.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace romascope {
namespace {

constexpr double kVerticalFov = 0.25 * glm::pi<double>();
constexpr double kAspect = 16.0 / 9.0;
constexpr double kMargin = 0.05; ///< of the picture's width and height, on each side
/// Of the scene's diagonal: no nearer, even where all lies behind the nearest point.
constexpr double kLeastDistance = 0.01;

/// Tangents of the angles from the middle of the picture to its margin.
const double kSlopeY = (1.0 - 2.0 * kMargin) * std::tan(0.5 * kVerticalFov);
const double kSlopeX = kSlopeY * kAspect;

/// Adds where things are in the course of the first animation.
void add_course(ViewFit& fit, const Motion& motion) {
    constexpr int kTimes = 16;
    const MovingBounds boxes(motion);
    for (int i = 0; i < kTimes; ++i) {
        const Pose pose = pose_at(motion, 0, motion.animations[0].duration * i / kTimes);
        try {
            fit.add(boxes.moving_at(motion, pose, palette(motion, pose)));
        } catch (const Error&) {
            continue; // far out of sight at a moment that nobody has asked for
        }
    }
}

} // namespace

ViewFit::ViewFit() : back_(glm::normalize(glm::dvec3(0.6, 0.5, 1.0))) {
    right_ = glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.0), back_));
    up_ = glm::cross(back_, right_);
}

void ViewFit::add(glm::vec3 point) {
    bounds_.add(point);
    const glm::dvec3 exact(point);
    const double x = glm::dot(exact, right_);
    const double y = glm::dot(exact, up_);
    const double z = glm::dot(exact, back_);
    right_edge_ = std::max(right_edge_, x + kSlopeX * z);
    left_edge_ = std::max(left_edge_, -x + kSlopeX * z);
    upper_edge_ = std::max(upper_edge_, y + kSlopeY * z);
    lower_edge_ = std::max(lower_edge_, -y + kSlopeY * z);
    nearest_ = std::max(nearest_, z);
}

void ViewFit::add(const Bounds& box) {
    for (int corner = 0; corner < 8; ++corner)
        add(glm::vec3(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                      corner & 4 ? box.max.z : box.min.z));
}

Camera ViewFit::camera() const {
    assert(!bounds_.empty());
    // An eye at (x, y, z) sees a point within the right margin if the point's plane passes below
    // the eye: right_edge <= x + slope * z. With the left one: right_edge + left_edge <= 2 slope z.
    const double x = 0.5 * (right_edge_ - left_edge_);
    const double y = 0.5 * (upper_edge_ - lower_edge_);
    double z = std::max(0.5 * (right_edge_ + left_edge_) / kSlopeX,
                        0.5 * (upper_edge_ + lower_edge_) / kSlopeY);
    const double diagonal = glm::length(glm::dvec3(bounds_.max) - glm::dvec3(bounds_.min));
    z = std::max(z, nearest_ + (diagonal > 0.0 ? kLeastDistance * diagonal : 1.0));
    // The eye is rounded to floats, by up to half a unit in the last place along each axis.
    const double largest = std::max({std::abs(x), std::abs(y), std::abs(z)});
    z += largest * std::numeric_limits<float>::epsilon() / std::min(kSlopeX, kSlopeY);

    Camera camera;
    camera.name = "default";
    camera.eye = glm::vec3(x * right_ + y * up_ + z * back_);
    camera.forward = glm::vec3(-back_);
    camera.up = glm::vec3(up_);
    camera.vertical_fov = static_cast<float>(kVerticalFov);
    return camera;
}

Camera fit_camera(const Scene& scene) {
    ViewFit fit;
    for (const uint32_t index : scene.indices)
        fit.add(scene.positions[index]);
    if (!scene.motion.parts.empty() && !scene.motion.animations.empty())
        add_course(fit, scene.motion);
    return fit.camera();
}

} // namespace romascope
