// SPDX-License-Identifier: MIT
#include "renderer/scene/camera_path.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>

namespace romascope {
namespace {

glm::quat orientation(const Camera& camera) {
    return glm::quat_cast(glm::mat3(camera.right(), camera.up, -camera.forward));
}

/// From b at 0 to c at 1, at b and c along the chords of their neighbours.
glm::vec3 catmull_rom(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d, float t) {
    return b + 0.5f * t *
                   ((c - a) +
                    t * ((2.0f * a - 5.0f * b + 4.0f * c - d) + t * (3.0f * (b - c) + d - a)));
}

} // namespace

Camera camera_along(std::span<const Camera> stops, double way) {
    const double legs = static_cast<double>(stops.size() - 1);
    const double place = std::clamp(way, 0.0, 1.0) * legs;
    const size_t leg = std::min(static_cast<size_t>(place), stops.size() - 1);
    const auto t = static_cast<float>(place - static_cast<double>(leg));
    const auto stop = [&](size_t index) { return stops[std::min(index, stops.size() - 1)]; };
    const Camera from = stop(leg), to = stop(leg + 1);
    if (t == 0.0f)
        return from;
    Camera camera = from;
    if (from.eye != to.eye) // else it would leave and come back
        camera.eye =
            catmull_rom(stop(leg == 0 ? 0 : leg - 1).eye, from.eye, to.eye, stop(leg + 2).eye, t);
    const glm::mat3 turned =
        glm::mat3_cast(glm::normalize(glm::slerp(orientation(from), orientation(to), t)));
    camera.up = turned[1];
    camera.forward = -turned[2];
    camera.vertical_fov = glm::mix(from.vertical_fov, to.vertical_fov, t);
    return camera;
}

} // namespace romascope
