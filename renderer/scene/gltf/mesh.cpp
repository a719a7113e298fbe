// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/mesh.h"

#include "renderer/scene/gltf/accessor.h"
#include "renderer/scene/gltf/document.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <numeric>

namespace romascope::gltf {
namespace {

const std::vector<int> kFloat = {TINYGLTF_COMPONENT_TYPE_FLOAT};

/// A strip's or fan's corners as separate triangles (glTF 2.0, 3.7.2.1). Triangles with a
/// repeated corner only join strips and are dropped.
std::vector<uint32_t> to_list(const std::vector<uint32_t>& corners, int mode,
                              const std::string& element) {
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        if (corners.size() % 3 != 0)
            refuse(element, fmt::format("{} corners do not make triangles", corners.size()));
        return corners;
    }
    if (corners.size() < 3)
        refuse(element, fmt::format("{} corners do not make a triangle", corners.size()));
    std::vector<uint32_t> list;
    list.reserve(3 * (corners.size() - 2));
    for (size_t i = 0; i + 2 < corners.size(); ++i) {
        const bool fan = mode == TINYGLTF_MODE_TRIANGLE_FAN;
        const uint32_t a = fan ? corners[i + 1] : corners[i];
        const uint32_t b = fan ? corners[i + 2] : corners[i + 1 + i % 2];
        const uint32_t c = fan ? corners[0] : corners[i + 2 - i % 2];
        if (a != b && b != c && c != a)
            list.insert(list.end(), {a, b, c});
    }
    return list;
}

/// Unit normal of a triangle, zero if it has no area. In double, so that the products of small
/// edges do not underflow.
glm::vec3 face_normal(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    return length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f);
}

glm::vec3 face_normal(const Triangles& mesh, size_t corner) {
    const auto position = [&](size_t i) { return mesh.positions[mesh.indices[i]]; };
    return face_normal(position(corner), position(corner + 1), position(corner + 2));
}

/// Flat shading as glTF asks for where normals are missing: each triangle gets its own vertices.
void split_flat(Triangles& mesh) {
    Triangles flat;
    flat.material = mesh.material;
    flat.positions.reserve(mesh.indices.size());
    flat.normals.reserve(mesh.indices.size());
    for (size_t i = 0; i < mesh.indices.size(); ++i) {
        flat.positions.push_back(mesh.positions[mesh.indices[i]]);
        flat.normals.push_back(i % 3 == 0 ? face_normal(mesh, i) : flat.normals.back());
    }
    flat.indices.resize(mesh.indices.size());
    std::iota(flat.indices.begin(), flat.indices.end(), 0u);
    mesh = std::move(flat);
}

/// Makes normals unit length. One that is zero becomes that of a triangle it belongs to.
void repair_normals(Triangles& mesh) {
    bool missing = false;
    for (glm::vec3& normal : mesh.normals) {
        const double length = glm::length(glm::dvec3(normal));
        missing |= length == 0.0;
        normal = length > 0.0 ? glm::vec3(glm::dvec3(normal) / length) : glm::vec3(0.0f);
    }
    for (size_t i = 0; missing && i < mesh.indices.size(); ++i) {
        glm::vec3& normal = mesh.normals[mesh.indices[i]];
        if (normal == glm::vec3(0.0f))
            normal = face_normal(mesh, i - i % 3);
    }
}

/// Reads the vertices that `corners` use, and renumbers those.
Triangles gather(std::vector<uint32_t> corners, const AccessorSpan& positions,
                 const AccessorSpan* normals, const std::string& element) {
    const auto [low, high] = std::ranges::minmax(corners);
    const size_t range = size_t{high} - low + 1;
    Triangles mesh;
    const auto read = [&](size_t first, size_t count) {
        for (const auto& [span, out, name] :
             {std::tuple(&positions, &mesh.positions, ".attributes.POSITION"),
              std::tuple(normals, &mesh.normals, ".attributes.NORMAL")}) {
            if (!span)
                continue;
            const auto values = read_vec3(*span, first, count, element + name);
            out->insert(out->end(), values.begin(), values.end());
        }
    };
    if (range <= 2 * corners.size()) {
        read(low, range);
        for (uint32_t& corner : corners)
            corner -= low;
    } else {
        // Few corners far apart in a large shared buffer: only the vertices themselves, lest a
        // small file that shares one buffer a million times becomes a huge scene.
        std::vector<uint32_t> used = corners;
        std::ranges::sort(used);
        used.erase(std::ranges::unique(used).begin(), used.end());
        for (const uint32_t vertex : used)
            read(vertex, 1);
        for (uint32_t& corner : corners)
            corner = static_cast<uint32_t>(std::ranges::lower_bound(used, corner) - used.begin());
    }
    mesh.indices = std::move(corners);
    return mesh;
}

Triangles convert_primitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                            const std::string& element) {
    if (primitive.extensions.contains("KHR_draco_mesh_compression"))
        refuse(element, "compressed by KHR_draco_mesh_compression, which is not supported");
    const auto attribute = [&](const char* name) {
        const auto found = primitive.attributes.find(name);
        return found == primitive.attributes.end() ? -1 : found->second;
    };
    const std::string position_name = element + ".attributes.POSITION";
    const AccessorSpan positions =
        open_accessor(model, attribute("POSITION"), TINYGLTF_TYPE_VEC3, kFloat, position_name);
    AccessorSpan normals;
    const bool has_normals = primitive.attributes.contains("NORMAL");
    if (has_normals) {
        const std::string name = element + ".attributes.NORMAL";
        normals = open_accessor(model, attribute("NORMAL"), TINYGLTF_TYPE_VEC3, kFloat, name);
        if (normals.count != positions.count)
            refuse(name,
                   fmt::format("{} normals for {} positions", normals.count, positions.count));
    }

    std::vector<uint32_t> corners;
    const std::string index_name = element + ".indices";
    if (present(primitive.indices, model.accessors.size(), index_name, "accessor")) {
        corners = read_indices(model, primitive.indices, index_name);
        for (size_t i = 0; i < corners.size(); ++i)
            if (corners[i] >= positions.count)
                refuse(index_name, fmt::format("index {} names vertex {}, there are {}", i,
                                               corners[i], positions.count));
    } else {
        if (positions.count > UINT32_MAX)
            refuse(position_name, "too many vertices");
        corners.resize(positions.count);
        std::iota(corners.begin(), corners.end(), 0u);
    }
    corners = to_list(corners, primitive.mode, element);
    Triangles mesh;
    if (!corners.empty()) {
        mesh = gather(std::move(corners), positions, has_normals ? &normals : nullptr, element);
        if (has_normals)
            repair_normals(mesh);
        else
            split_flat(mesh);
    }
    present(primitive.material, model.materials.size(), element + ".material", "material");
    mesh.material = primitive.material;
    return mesh;
}

} // namespace

std::vector<Triangles> convert_mesh(const tinygltf::Model& model, size_t mesh) {
    std::vector<Triangles> converted;
    const auto& primitives = model.meshes[mesh].primitives;
    for (size_t p = 0; p < primitives.size(); ++p) {
        const std::string element = fmt::format("meshes[{}].primitives[{}]", mesh, p);
        const int mode = primitives[p].mode;
        if (mode < TINYGLTF_MODE_POINTS || mode > TINYGLTF_MODE_TRIANGLE_FAN)
            refuse(element + ".mode", fmt::format("{} is not a kind of primitive", mode));
        if (mode >= TINYGLTF_MODE_TRIANGLES)
            converted.push_back(convert_primitive(model, primitives[p], element));
    }
    return converted;
}

} // namespace romascope::gltf
