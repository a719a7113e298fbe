// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/mounted.h"

#include "renderer/scene/gltf/numbers.h"

#include <glm/gtc/constants.hpp>
#include <tiny_gltf.h>

#include <algorithm>
#include <map>
#include <optional>

namespace romascope::gltf {
namespace {

/// Names of cameras, each with the number that its next namesake is tried with.
using Names = std::map<std::string, size_t>;

std::string unique_name(const std::string& wanted, Names& taken) {
    const std::string name = wanted.empty() ? "camera" : wanted;
    std::string candidate = name;
    while (!taken.try_emplace(candidate, 2).second)
        candidate = fmt::format("{}_{}", name, taken[name]++);
    return candidate;
}

std::optional<Camera> read_camera(const tinygltf::Model& model, const tinygltf::Node& node,
                                  const glm::dmat4& world, const std::string& element,
                                  Notices& notices) {
    const tinygltf::Camera& source = model.cameras[static_cast<size_t>(node.camera)];
    const std::string name = fmt::format("cameras[{}]", node.camera);
    if (source.type != "perspective") {
        notices.add(name, "only perspective cameras are taken");
        return std::nullopt;
    }
    const double fov = source.perspective.yfov;
    if (!(fov > 0.0 && fov < glm::pi<double>()))
        refuse(name + ".perspective.yfov", fmt::format("{} is not an angle between 0 and pi", fov));
    const glm::dvec3 forward = -glm::dvec3(world[2]);
    const glm::dvec3 side = glm::cross(forward, glm::dvec3(world[1]));
    const glm::dvec3 up = glm::cross(side, forward);
    const double size = glm::length(forward) * glm::length(up);
    if (!(size > 0.0) || !std::isfinite(size) ||
        !(glm::length(glm::dvec3(world[3])) <= kMaxCoordinate))
        refuse(element, "its transform leaves the camera no direction");
    Camera camera;
    camera.eye = glm::vec3(world[3]);
    camera.forward = glm::vec3(glm::normalize(forward));
    camera.up = glm::vec3(glm::normalize(up));
    camera.vertical_fov = static_cast<float>(fov);
    return camera;
}

bool is_known(const tinygltf::Light& light) {
    return light.type == "directional" || light.type == "point" || light.type == "spot";
}

Light read_light(const tinygltf::Light& source, const glm::dmat4& world, const std::string& name,
                 const std::string& element) {
    Light light;
    light.name = source.name;
    light.kind = source.type == "directional" ? LightKind::directional
                 : source.type == "spot"      ? LightKind::spot
                                              : LightKind::point;
    const glm::dvec3 color = numbers<3>(source.color, glm::dvec3(1.0), name + ".color");
    if (!(source.intensity >= 0.0 && source.intensity <= 1e20))
        refuse(name + ".intensity", fmt::format("{} is not a sane number", source.intensity));
    light.color = glm::vec3(glm::clamp(color, 0.0, 1e3) * source.intensity);
    if (source.range > 0.0 && std::isfinite(source.range))
        light.range = static_cast<float>(std::min(source.range, 1e30));
    light.inner_cone = static_cast<float>(source.spot.innerConeAngle);
    light.outer_cone = static_cast<float>(source.spot.outerConeAngle);
    if (light.kind == LightKind::spot &&
        !(light.inner_cone >= 0.0f && light.inner_cone < light.outer_cone &&
          source.spot.outerConeAngle <= glm::half_pi<double>() + 1e-6))
        refuse(name + ".spot", "cone angles must be 0 <= inner < outer <= pi / 2");
    const glm::dvec3 forward = -glm::dvec3(world[2]);
    const double size = glm::length(forward);
    if (light.kind != LightKind::point && (!(size > 0.0) || !std::isfinite(size)))
        refuse(element, "its transform leaves the light no direction");
    if (!(glm::length(glm::dvec3(world[3])) <= kMaxCoordinate))
        refuse(element, fmt::format("places a light beyond {} m", kMaxCoordinate));
    light.position = glm::vec3(world[3]);
    if (size > 0.0 && std::isfinite(size))
        light.direction = glm::vec3(forward / size);
    return light;
}

/// The light of a node, -1 for none.
int light_of(const tinygltf::Node& node) {
    const auto found = node.extensions.find("KHR_lights_punctual");
    return found != node.extensions.end() && found->second.Has("light")
               ? found->second.Get("light").GetNumberAsInt()
               : -1;
}

} // namespace

void add_mounted(const Document& document, const Hierarchy& hierarchy,
                 const std::vector<glm::dmat4>& node_to_world, Scene& scene, Notices& notices) {
    const tinygltf::Model& model = document.model();
    Names names;
    for (uint32_t place = 0; place < hierarchy.nodes.size(); ++place) {
        if (!hierarchy.drawn[place])
            continue;
        const uint32_t n = hierarchy.file_node[place];
        const tinygltf::Node& node = model.nodes[n];
        const std::string element = fmt::format("nodes[{}]", n);
        if (node.camera >= 0) {
            auto camera = read_camera(model, node, node_to_world[place], element, notices);
            if (camera) {
                const auto& source = model.cameras[static_cast<size_t>(node.camera)];
                camera->name = unique_name(node.name.empty() ? source.name : node.name, names);
                if (hierarchy.moves[place])
                    scene.motion.cameras.push_back(
                        {static_cast<uint32_t>(scene.cameras.size()), place});
                scene.cameras.push_back(*camera);
            }
        }
        if (const int light = light_of(node); light >= 0) {
            const std::string name =
                fmt::format("extensions.KHR_lights_punctual.lights[{}]", light);
            const tinygltf::Light& source = model.lights[static_cast<size_t>(light)];
            if (!is_known(source)) {
                notices.add(name, "is of a type that is not known, and is left out");
                continue;
            }
            if (hierarchy.moves[place])
                scene.motion.lights.push_back({static_cast<uint32_t>(scene.lights.size()), place});
            scene.lights.push_back(read_light(source, node_to_world[place], name, element));
            if (scene.lights.back().name.empty())
                scene.lights.back().name = node.name;
        }
    }
}

} // namespace romascope::gltf
