// SPDX-License-Identifier: MIT
#include "renderer/scene/camera.h"

#include "renderer/base/error.h"

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

namespace romascope {
namespace {

bool finite(glm::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// "1,2.5,-3" as `count` finite numbers. Not the locale's decimal comma: files and scripts must
/// mean the same everywhere.
std::optional<std::vector<float>> numbers(std::string_view text, size_t count) {
    std::vector<float> values;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (values.size() < count) {
        float value = 0.0f;
        const auto [next, code] = std::from_chars(at, end, value);
        if (code != std::errc() || !std::isfinite(value))
            return std::nullopt;
        values.push_back(value);
        at = next;
        if (values.size() == count)
            break;
        if (at == end || *at != ',')
            return std::nullopt;
        ++at;
    }
    return at == end ? std::optional(values) : std::nullopt;
}

} // namespace

glm::vec3 Camera::direction_through(glm::vec2 pixel, glm::ivec2 size) const {
    const float slope = std::tan(0.5f * vertical_fov);
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    const glm::vec2 relative = 2.0f * pixel / glm::vec2(size) - 1.0f;
    return glm::normalize(forward + right() * (relative.x * slope * aspect) -
                          up * (relative.y * slope));
}

glm::mat4 Camera::view() const {
    const glm::vec3 side = right();
    const glm::mat3 rotation = glm::transpose(glm::mat3(side, up, -forward));
    glm::mat4 matrix(rotation);
    matrix[3] = glm::vec4(-(rotation * eye), 1.0f);
    return matrix;
}

glm::mat4 Camera::projection(glm::ivec2 size, float near_plane, glm::vec2 offset) const {
    const float scale = 1.0f / std::tan(0.5f * vertical_fov);
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    glm::mat4 matrix(0.0f);
    matrix[0][0] = scale / aspect;
    matrix[1][1] = -scale;
    // Divided by w = -z, these two become the shift by -offset pixels.
    matrix[2][0] = 2.0f * offset.x / static_cast<float>(size.x);
    matrix[2][1] = 2.0f * offset.y / static_cast<float>(size.y);
    matrix[2][3] = -1.0f;
    matrix[3][2] = near_plane;
    return matrix;
}

Camera look_at(const std::string& name, glm::vec3 eye, glm::vec3 target, float vertical_fov) {
    const glm::vec3 way = target - eye;
    if (!finite(eye) || !finite(target) || !finite(way))
        throw Error(fmt::format("camera '{}': eye and target must be finite numbers", name),
                    kBadInput);
    if (!(vertical_fov > 0.0f && vertical_fov < glm::pi<float>()))
        throw Error(
            fmt::format("camera '{}': the field of view must lie between 0 and 180 degrees", name),
            kBadInput);
    // In double, so that neither tiny nor huge distances under- or overflow when squared.
    const glm::dvec3 exact(way);
    const double distance = glm::length(exact);
    if (distance == 0.0)
        throw Error(fmt::format("camera '{}': eye and target are the same point", name), kBadInput);

    Camera camera;
    camera.name = name;
    camera.eye = eye;
    camera.forward = glm::vec3(exact / distance);
    camera.vertical_fov = vertical_fov;
    const bool vertical = std::abs(camera.forward.y) > 0.9999f;
    const glm::vec3 hint = vertical ? glm::vec3(0.0f, 0.0f, 1.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
    const glm::vec3 side = glm::normalize(glm::cross(camera.forward, hint));
    camera.up = glm::normalize(glm::cross(side, camera.forward));
    return camera;
}

Camera parse_camera(const std::string& text) {
    const std::string_view all = text;
    const size_t first = all.find('/');
    const size_t second = first == all.npos ? all.npos : all.find('/', first + 1);
    if (second != all.npos) {
        const auto eye = numbers(all.substr(0, first), 3);
        const auto target = numbers(all.substr(first + 1, second - first - 1), 3);
        const auto degrees = numbers(all.substr(second + 1), 1);
        if (eye && target && degrees)
            return look_at(text, {(*eye)[0], (*eye)[1], (*eye)[2]},
                           {(*target)[0], (*target)[1], (*target)[2]}, glm::radians((*degrees)[0]));
    }
    throw Error(fmt::format("camera '{}' is not of the form eye/target/degrees, as in "
                            "1,2,3/0,0.5,0/60",
                            text),
                kBadInput);
}

} // namespace romascope
