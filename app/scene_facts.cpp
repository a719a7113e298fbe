// SPDX-License-Identifier: MIT
#include "app/scene_facts.h"

#include "app/json.h"
#include "renderer/base/memory.h"
#include "renderer/scene/gltf/message.h"
#include "renderer/scene/scene_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numbers>

namespace romascope {
namespace {

double degrees(float radians) { return radians * 180.0 / std::numbers::pi; }

const char* name_of(LightKind kind) {
    switch (kind) {
    case LightKind::directional:
        return "directional";
    case LightKind::point:
        return "point";
    case LightKind::spot:
        return "spot";
    }
    return "";
}

size_t moving_vertices(const Motion& motion) {
    size_t count = 0;
    for (const MovingPart& part : motion.parts)
        count += part.vertex_count;
    return count;
}

size_t joints_of(const Motion& motion, const MovingPart& part) {
    return part.skin < 0 ? 0 : motion.skins[static_cast<size_t>(part.skin)].joints.size();
}

Json materials_json(const Scene& scene) {
    Json json = Json::array();
    for (const Material& material : scene.materials)
        json.push_back({{"name", material.name},
                        {"base_color", to_json(material.base_color)},
                        {"alpha", material.alpha},
                        {"alpha_cutoff", material.alpha_cutoff},
                        {"texture", material.texture < 0 ? Json() : Json(material.texture)},
                        {"emissive", to_json(material.emissive)},
                        {"double_sided", material.double_sided}});
    return json;
}

Json lights_json(const Scene& scene) {
    Json json = Json::array();
    for (const Light& light : scene.lights)
        json.push_back({{"name", light.name},
                        {"kind", name_of(light.kind)},
                        {"position_m", to_json(light.position)},
                        {"direction", to_json(light.direction)},
                        {"color", to_json(light.color)}});
    return json;
}

Json parts_json(const Motion& motion) {
    Json json = Json::array();
    for (const MovingPart& part : motion.parts)
        json.push_back({{"vertices", part.vertex_count},
                        {"joints", joints_of(motion, part)},
                        {"morph_targets", part.target_count}});
    return json;
}

/// Names come from files and may be anything.
std::string shown(const std::string& name) {
    return name.empty() ? "(no name)" : gltf::one_line(name);
}

constexpr size_t kColumn = 12;  ///< where what is told begins
constexpr size_t kLongest = 24; ///< of a list

/// A line each: the first behind the label, the others below.
std::string list(const std::string& label, size_t count,
                 const std::function<std::string(size_t)>& entry) {
    std::string text;
    for (size_t i = 0; i < std::min(count, kLongest); ++i)
        text += fmt::format("{:<{}}{}\n", i == 0 ? label : "", kColumn, entry(i));
    if (count > kLongest)
        text += fmt::format("{:<{}}and {} more, see --json\n", "", kColumn, count - kLongest);
    return count == 0 ? fmt::format("{:<{}}none\n", label, kColumn) : text;
}

std::string material_text(const Material& material) {
    std::string text = shown(material.name);
    if (material.texture >= 0)
        text += fmt::format(", texture {}", material.texture);
    if (material.alpha_cutoff > 0.0f)
        text += fmt::format(", alpha mask at {:.3g}", material.alpha_cutoff);
    if (material.double_sided)
        text += ", double-sided";
    if (material.emissive != glm::vec3(0.0f))
        text += ", emits light";
    return text;
}

std::string part_text(const Motion& motion, const MovingPart& part) {
    std::string text = fmt::format("{} vertices", part.vertex_count);
    if (part.skin >= 0)
        text += fmt::format(", skin of {} joints", joints_of(motion, part));
    if (part.target_count > 0)
        text += fmt::format(", {} morph targets", part.target_count);
    return text + (part.skin < 0 && part.target_count == 0 ? ", rigid" : "");
}

} // namespace

Json scene_summary(const Scene& scene, const std::string& file) {
    Json animations = Json::array();
    for (const Animation& animation : scene.motion.animations)
        animations.push_back({{"name", animation.name}, {"seconds", animation.duration}});
    return {{"name", scene.name},
            {"file", file},
            {"triangles", scene.triangle_count()},
            {"vertices", scene.positions.size()},
            {"moving_vertices", moving_vertices(scene.motion)},
            {"materials", scene.materials.size()},
            {"textures", scene.textures.size()},
            {"lights", scene.lights.size()},
            {"cameras", scene.cameras.size()},
            {"bounds_min_m", to_json(scene.bounds.min)},
            {"bounds_max_m", to_json(scene.bounds.max)},
            {"bytes", scene_bytes(scene)},
            {"animations", std::move(animations)},
            {"notices", scene.notices}};
}

Json camera_json(const Camera& camera) {
    return {{"name", camera.name},
            {"eye_m", to_json(camera.eye)},
            {"forward", to_json(camera.forward)},
            {"up", to_json(camera.up)},
            {"vertical_fov_degrees", degrees(camera.vertical_fov)}};
}

std::string scene_json(const Scene& scene, const std::string& file) {
    Json json = {{"schema", kSceneSchema}, {"scene", scene_summary(scene, file)}};
    json["cameras"] = Json::array();
    for (const Camera& camera : scene.cameras)
        json["cameras"].push_back(camera_json(camera));
    json["materials"] = materials_json(scene);
    json["textures"] = Json::array();
    for (const SurfaceTexture& texture : scene.textures)
        json["textures"].push_back({{"width", texture.size.x}, {"height", texture.size.y}});
    json["lights"] = lights_json(scene);
    json["moving_parts"] = parts_json(scene.motion);
    return pretty(json);
}

std::string scene_text(const Scene& scene, const std::string& file) {
    const auto line = [](const char* label, const std::string& value) {
        return fmt::format("{:<{}}{}\n", label, kColumn, value);
    };
    const auto point = [](glm::vec3 p) {
        return fmt::format("{:.4g}, {:.4g}, {:.4g}", p.x, p.y, p.z);
    };
    const glm::vec3 size = scene.bounds.extent();
    std::string text = line("scene", fmt::format("{} ({})", shown(scene.name), file));
    text += line("triangles", std::to_string(scene.triangle_count()));
    text += line("vertices", fmt::format("{}, of which {} move", scene.positions.size(),
                                         moving_vertices(scene.motion)));
    text += line("size", fmt::format("{:.4g} x {:.4g} x {:.4g} m, from {} to {}", size.x, size.y,
                                     size.z, point(scene.bounds.min), point(scene.bounds.max)));
    text += line("memory", format_bytes(scene_bytes(scene)));
    text += list("cameras", scene.cameras.size(), [&](size_t i) {
        return fmt::format("{}, {:.3g} degrees", shown(scene.cameras[i].name),
                           degrees(scene.cameras[i].vertical_fov));
    });
    text += list("materials", scene.materials.size(),
                 [&](size_t i) { return material_text(scene.materials[i]); });
    text += list("textures", scene.textures.size(), [&](size_t i) {
        return fmt::format("{}x{}", scene.textures[i].size.x, scene.textures[i].size.y);
    });
    text += list("lights", scene.lights.size(), [&](size_t i) {
        return fmt::format("{}, {}", shown(scene.lights[i].name), name_of(scene.lights[i].kind));
    });
    text += list("animations", scene.motion.animations.size(), [&](size_t i) {
        const Animation& animation = scene.motion.animations[i];
        return fmt::format("{}, {:.4g} s", shown(animation.name), animation.duration);
    });
    text += list("moving", scene.motion.parts.size(),
                 [&](size_t i) { return part_text(scene.motion, scene.motion.parts[i]); });
    text += list("notices", scene.notices.size(), [&](size_t i) { return scene.notices[i]; });
    return text;
}

} // namespace romascope
