// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/import.h"

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/scene/gltf/accessor.h"
#include "renderer/scene/gltf/document.h"
#include "renderer/scene/gltf/mesh.h"

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace romascope {
namespace gltf {
namespace {

/// Instances can multiply a small file beyond any memory; this many triangles take about 5 GB.
constexpr size_t kMaxTriangles = 50'000'000;
/// Metres. Products of two edges, squared, must stay below the largest float.
constexpr double kMaxCoordinate = 1e9;

/// `values` as N finite numbers, or `fallback` if empty.
template <int N>
glm::vec<N, double> numbers(const std::vector<double>& values, glm::vec<N, double> fallback,
                            const std::string& element) {
    if (values.empty())
        return fallback;
    if (values.size() != N)
        refuse(element, fmt::format("has {} numbers instead of {}", values.size(), N));
    glm::vec<N, double> result;
    for (int i = 0; i < N; ++i) {
        result[i] = values[static_cast<size_t>(i)];
        if (!std::isfinite(result[i]))
            refuse(element, "is not finite");
    }
    return result;
}

glm::dmat4 local_transform(const tinygltf::Node& node, const std::string& element) {
    if (!node.matrix.empty()) {
        const std::string name = element + ".matrix";
        if (node.matrix.size() != 16)
            refuse(name, fmt::format("has {} numbers instead of 16", node.matrix.size()));
        glm::dmat4 matrix;
        for (int i = 0; i < 16; ++i) {
            const double value = node.matrix[static_cast<size_t>(i)];
            if (!std::isfinite(value))
                refuse(name, "is not finite");
            matrix[i / 4][i % 4] = value; // column-major, as in glTF
        }
        const glm::dvec4 row(matrix[0][3], matrix[1][3], matrix[2][3], matrix[3][3]);
        if (glm::distance(row, glm::dvec4(0.0, 0.0, 0.0, 1.0)) > 1e-5)
            refuse(name, "is not affine: its last row must be 0 0 0 1");
        return matrix;
    }
    const auto move = numbers<3>(node.translation, glm::dvec3(0.0), element + ".translation");
    const auto scale = numbers<3>(node.scale, glm::dvec3(1.0), element + ".scale");
    const auto turn =
        numbers<4>(node.rotation, glm::dvec4(0.0, 0.0, 0.0, 1.0), element + ".rotation");
    const double length = glm::length(turn);
    if (!(length > 0.0) || !std::isfinite(length))
        refuse(element + ".rotation", "is not a quaternion of unit length");
    glm::dquat rotation;
    rotation.x = turn.x / length;
    rotation.y = turn.y / length;
    rotation.z = turn.z / length;
    rotation.w = turn.w / length;
    return glm::scale(glm::translate(glm::dmat4(1.0), move) * glm::mat4_cast(rotation), scale);
}

/// Writes what nodes refer to into a Scene.
class Builder {
public:
    explicit Builder(const tinygltf::Model& model) : model_(model), meshes_(model.meshes.size()) {}

    Scene build() {
        add_materials();
        walk();
        if (scene_.indices.empty())
            refuse("scene", "has no triangles");
        if (scene_.cameras.empty())
            add_fitting_camera();
        return std::move(scene_);
    }

private:
    void add_materials();
    std::vector<int> roots() const;
    void walk();
    void add_mesh(size_t mesh, const glm::dmat4& world, const std::string& element);
    void add_instance(const Triangles& mesh, const glm::dmat4& world, const std::string& element);
    void add_camera(const tinygltf::Node& node, const glm::dmat4& world,
                    const std::string& element);
    void add_fitting_camera();
    uint32_t material_index(int material);
    std::string unique_camera_name(std::string name) const;

    const tinygltf::Model& model_;
    std::vector<std::optional<std::vector<Triangles>>> meshes_; ///< as far as converted
    std::optional<uint32_t> default_material_;
    Scene scene_;
};

void Builder::add_materials() {
    for (size_t i = 0; i < model_.materials.size(); ++i) {
        const tinygltf::Material& source = model_.materials[i];
        const std::string element = fmt::format("materials[{}]", i);
        const glm::dvec4 base = numbers<4>(source.pbrMetallicRoughness.baseColorFactor,
                                           glm::dvec4(1.0), element + ".baseColorFactor");
        const glm::dvec3 emissive =
            numbers<3>(source.emissiveFactor, glm::dvec3(0.0), element + ".emissiveFactor");
        scene_.materials.push_back({source.name, glm::vec3(glm::clamp(glm::dvec3(base), 0.0, 1.0)),
                                    glm::vec3(glm::clamp(emissive, 0.0, 1e30))});
    }
    if (scene_.materials.empty())
        material_index(-1);
}

uint32_t Builder::material_index(int material) {
    if (material >= 0)
        return static_cast<uint32_t>(material);
    if (!default_material_) {
        default_material_ = static_cast<uint32_t>(scene_.materials.size());
        scene_.materials.push_back({"default"});
    }
    return *default_material_;
}

/// The nodes of the default scene, of the first one, or, without scenes, all without a parent.
std::vector<int> Builder::roots() const {
    const std::string element = "scene";
    if (present(model_.defaultScene, model_.scenes.size(), element, "scene"))
        return model_.scenes[static_cast<size_t>(model_.defaultScene)].nodes;
    if (!model_.scenes.empty())
        return model_.scenes.front().nodes;
    std::vector<bool> has_parent(model_.nodes.size(), false);
    for (const tinygltf::Node& node : model_.nodes)
        for (const int child : node.children)
            if (child >= 0 && static_cast<size_t>(child) < has_parent.size())
                has_parent[static_cast<size_t>(child)] = true;
    std::vector<int> nodes;
    for (size_t i = 0; i < has_parent.size(); ++i)
        if (!has_parent[i])
            nodes.push_back(static_cast<int>(i));
    return nodes;
}

/// Depth first with a stack of its own, as hierarchies may be deeper than the program's stack.
/// A node reached twice has two parents or is part of a cycle, which glTF forbids; allowing it
/// would let a small file grow without bound.
void Builder::walk() {
    struct Visit {
        int node;
        glm::dmat4 parent;
        std::string from;
    };
    std::vector<Visit> stack;
    const auto push = [&](const std::vector<int>& nodes, const glm::dmat4& parent,
                          const std::string& from) {
        for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
            stack.push_back({*node, parent, from});
    };
    push(roots(), glm::dmat4(1.0), "scene.nodes");
    std::vector<bool> seen(model_.nodes.size(), false);
    while (!stack.empty()) {
        const Visit visit = std::move(stack.back());
        stack.pop_back();
        if (!present(visit.node, model_.nodes.size(), visit.from, "node"))
            refuse(visit.from, "node -1 does not exist");
        const auto index = static_cast<size_t>(visit.node);
        if (seen[index])
            refuse(visit.from,
                   fmt::format("node {} is reached twice (a cycle, or two parents)", visit.node));
        seen[index] = true;
        const tinygltf::Node& node = model_.nodes[index];
        const std::string element = fmt::format("nodes[{}]", index);
        const glm::dmat4 world = visit.parent * local_transform(node, element);
        if (present(node.mesh, model_.meshes.size(), element + ".mesh", "mesh"))
            add_mesh(static_cast<size_t>(node.mesh), world, element);
        if (present(node.camera, model_.cameras.size(), element + ".camera", "camera"))
            add_camera(node, world, element);
        push(node.children, world, element + ".children");
    }
}

void Builder::add_mesh(size_t mesh, const glm::dmat4& world, const std::string& element) {
    auto& converted = meshes_[mesh];
    if (!converted)
        converted = convert_mesh(model_, mesh);
    for (const Triangles& triangles : *converted)
        add_instance(triangles, world, element);
}

void Builder::add_instance(const Triangles& mesh, const glm::dmat4& world,
                           const std::string& element) {
    if (mesh.indices.size() / 3 > kMaxTriangles - scene_.triangle_count())
        refuse(element, fmt::format("the scene has more than {} triangles", kMaxTriangles));
    // The cofactors are the inverse transpose times the determinant, and exist even where a scale
    // is zero; the determinant's sign is what a mirrored instance needs.
    const glm::dmat3 linear(world);
    const bool mirrored = glm::determinant(linear) < 0.0;
    glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                         glm::cross(linear[0], linear[1]));
    if (mirrored)
        cofactors = -cofactors;
    if (cofactors == glm::dmat3(0.0))
        return; // scaled to a line or a point: the usual way to hide something

    const auto first = static_cast<uint32_t>(scene_.positions.size());
    const uint32_t material = material_index(mesh.material);
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dvec3 position(world * glm::dvec4(mesh.positions[i], 1.0));
        if (!(glm::all(glm::lessThanEqual(glm::abs(position), glm::dvec3(kMaxCoordinate)))))
            refuse(element, fmt::format("places a vertex beyond {} m", kMaxCoordinate));
        const glm::dvec3 normal = cofactors * glm::dvec3(mesh.normals[i]);
        const double length = glm::length(normal);
        scene_.positions.push_back(glm::vec3(position));
        scene_.normals.push_back(length > 0.0 && std::isfinite(length)
                                     ? glm::vec3(normal / length)
                                     : glm::vec3(0.0f, 1.0f, 0.0f));
    }
    scene_.vertex_material.resize(scene_.positions.size(), material);
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        uint32_t corners[3] = {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
        if (mirrored)
            std::swap(corners[1], corners[2]);
        for (const uint32_t corner : corners) {
            scene_.indices.push_back(first + corner);
            scene_.bounds.add(scene_.positions[first + corner]);
        }
    }
}

std::string Builder::unique_camera_name(std::string name) const {
    if (name.empty())
        name = "camera";
    const auto taken = [&](const std::string& candidate) {
        return std::ranges::any_of(scene_.cameras,
                                   [&](const Camera& camera) { return camera.name == candidate; });
    };
    std::string candidate = name;
    for (int n = 2; taken(candidate); ++n)
        candidate = fmt::format("{}_{}", name, n);
    return candidate;
}

void Builder::add_camera(const tinygltf::Node& node, const glm::dmat4& world,
                         const std::string& element) {
    const tinygltf::Camera& source = model_.cameras[static_cast<size_t>(node.camera)];
    if (source.type != "perspective")
        return;
    const double fov = source.perspective.yfov;
    if (!(fov > 0.0 && fov < glm::pi<double>()))
        refuse(fmt::format("cameras[{}].perspective.yfov", node.camera),
               fmt::format("{} is not an angle between 0 and pi", fov));
    const glm::dvec3 forward = -glm::dvec3(world[2]);
    const glm::dvec3 side = glm::cross(forward, glm::dvec3(world[1]));
    const glm::dvec3 up = glm::cross(side, forward);
    const double size = glm::length(forward) * glm::length(up);
    if (!(size > 0.0) || !std::isfinite(size) || glm::length(world[3]) > kMaxCoordinate)
        refuse(element, "its transform leaves the camera no direction");
    Camera camera;
    camera.name = unique_camera_name(node.name.empty() ? source.name : node.name);
    camera.eye = glm::vec3(world[3]);
    camera.forward = glm::vec3(glm::normalize(forward));
    camera.up = glm::vec3(glm::normalize(up));
    camera.vertical_fov = static_cast<float>(fov);
    scene_.cameras.push_back(camera);
}

/// Looks at the whole scene from in front, to the right and a little above.
void Builder::add_fitting_camera() {
    const float fov = glm::radians(45.0f);
    const glm::vec3 centre = scene_.bounds.centre();
    const float size = 0.5f * glm::length(scene_.bounds.extent());
    const float radius = size > 0.0f ? size : 1.0f; // a single point
    const float distance = radius / std::sin(0.5f * fov);
    const glm::vec3 from = glm::normalize(glm::vec3(0.6f, 0.5f, 1.0f));
    scene_.cameras.push_back(look_at("default", centre + distance * from, centre, fov));
}

/// Names and messages come from the file: kept to one line of sane length.
std::string one_line(const std::string& text) {
    std::string line;
    for (const char c : text.substr(0, text.find_last_not_of(" \n\r") + 1))
        line += c == '\n' ? ';' : static_cast<unsigned char>(c) < 32 || c == 127 ? '?' : c;
    return line.size() > 400 ? line.substr(0, 400) + " ..." : line;
}

} // namespace
} // namespace gltf

Scene load_gltf(const std::filesystem::path& path, size_t max_memory) {
    return import_gltf(read_text_file(path), path, max_memory);
}

Scene import_gltf(std::string content, const std::filesystem::path& path, size_t) {
    try {
        tinygltf::Model model;
        gltf::parse(content, path, model);
        Scene scene = gltf::Builder(model).build();
        scene.name = path.stem().string();
        return scene;
    } catch (const Error& error) {
        throw Error(path.string() + ": " + gltf::one_line(error.what()), error.exit_status());
    }
}

} // namespace romascope
