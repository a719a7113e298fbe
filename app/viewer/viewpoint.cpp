// SPDX-License-Identifier: MIT
#include "app/viewer/viewpoint.h"

#include <fmt/format.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace romascope {
namespace {

/// How far the view may turn up or down: straight up, "right" would have no meaning.
constexpr double kMaxPitch = glm::radians(89.0);
/// Nearer to the target than this, of a metre or of where it lies, an eye is not put: text of
/// single precision could no longer tell the two apart.
constexpr double kLeastDistance = 1e-5;

/// Unit direction turned by radians to the right and up, its pitch kept in bounds.
glm::dvec3 turned(glm::dvec3 direction, double right, double up) {
    const double pitch =
        std::clamp(std::asin(std::clamp(direction.y, -1.0, 1.0)) + up, -kMaxPitch, kMaxPitch);
    const double yaw = std::atan2(direction.x, -direction.z) + right;
    return {std::sin(yaw) * std::cos(pitch), std::sin(pitch), -std::cos(yaw) * std::cos(pitch)};
}

double least_distance(glm::dvec3 place) {
    const glm::dvec3 size = glm::abs(place);
    return kLeastDistance * std::max({1.0, size.x, size.y, size.z});
}

} // namespace

Viewpoint Viewpoint::of(const Camera& camera, const Bounds& scene) {
    Viewpoint viewpoint;
    viewpoint.eye = camera.eye;
    viewpoint.fov = glm::degrees(static_cast<double>(camera.vertical_fov));
    const double diagonal = glm::length(glm::dvec3(scene.extent()));
    const glm::dvec3 forward = turned(camera.forward, 0.0, 0.0);
    const double to_middle = glm::dot(glm::dvec3(scene.centre()) - viewpoint.eye, forward);
    const double away = std::max({to_middle, 0.05 * diagonal, 2.0 * least_distance(viewpoint.eye)});
    viewpoint.target = viewpoint.eye + away * forward;
    return viewpoint;
}

std::string Viewpoint::text() const {
    // Shortest numbers that single precision reads back: what render.camera is parsed as.
    const glm::vec3 from(eye), to(target);
    return fmt::format("{},{},{}/{},{},{}/{}", from.x, from.y, from.z, to.x, to.y, to.z,
                       static_cast<float>(fov));
}

void Viewpoint::orbit(double right, double up) {
    const double away = distance();
    eye = target - away * turned((target - eye) / away, right, up);
}

void Viewpoint::look(double right, double up) {
    const double away = distance();
    target = eye + away * turned((target - eye) / away, right, up);
}

void Viewpoint::walk(glm::dvec3 metres) {
    const glm::dvec3 forward = (target - eye) / distance();
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0.0, 1.0, 0.0)));
    const glm::dvec3 up = glm::cross(right, forward);
    const glm::dvec3 way = metres.x * right + metres.y * up + metres.z * forward;
    const glm::dvec3 limit(kMaxCoordinate);
    if (glm::any(glm::greaterThan(glm::abs(eye + way), limit)) ||
        glm::any(glm::greaterThan(glm::abs(target + way), limit)))
        return;
    eye += way;
    target += way;
}

void Viewpoint::approach(double times, double farthest) {
    const double least = 2.0 * least_distance(target);
    const double most = std::clamp(std::max(farthest, distance()), least, double{kMaxCoordinate});
    const double away = std::clamp(distance() / times, least, most);
    eye = target - away * ((target - eye) / distance());
}

} // namespace romascope
