// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/plan.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>

namespace romascope::gltf {
namespace {

constexpr size_t kMaxTriangles = 50'000'000;
/// What a plan counts stops here, far above what is refused, so that no sum overflows.
constexpr size_t kMost = kMaxTriangles * 100;

size_t count_of(const tinygltf::Model& model, int accessor) {
    return accessor < 0 ? 0 : model.accessors[static_cast<size_t>(accessor)].count;
}

} // namespace

MeshPlan plan_mesh(const tinygltf::Model& model, size_t mesh, const Materials& materials) {
    MeshPlan plan;
    const auto raise = [](size_t& sum, size_t more) {
        sum = std::min(sum + std::min(more, kMost), kMost);
    };
    for (const tinygltf::Primitive& primitive : model.meshes[mesh].primitives) {
        const auto& attributes = primitive.attributes;
        const auto position = attributes.find("POSITION");
        if (position == attributes.end() || primitive.mode < TINYGLTF_MODE_TRIANGLES)
            continue;
        const size_t vertices = count_of(model, position->second);
        size_t corners = primitive.indices < 0 ? vertices : count_of(model, primitive.indices);
        if (primitive.mode != TINYGLTF_MODE_TRIANGLES)
            corners = corners < 3 ? 0 : 3 * (corners - 2);
        if (model.accessors[static_cast<size_t>(position->second)].bufferView < 0)
            corners = std::min<size_t>(corners, 3); // all at one point, see read_piece
        const size_t used = std::min(vertices, corners);
        raise(plan.corners, corners);
        // Without normals each triangle has its own, and its own vertices.
        raise(plan.still_vertices, attributes.contains("NORMAL") ? used : corners);
        raise(plan.moving_vertices, used);
        raise(plan.deltas, used * primitive.targets.size());
        for (int set = 0; attributes.contains(fmt::format("JOINTS_{}", set)); ++set)
            raise(plan.influences, used);
        plan.colors = plan.colors || attributes.contains("COLOR_0");
        plan.texcoords = plan.texcoords || materials.texcoords(primitive.material).set >= 0;
    }
    return plan;
}

void Plan::add(const MeshPlan& mesh, bool moves, bool skinned, const std::string& element) {
    corners += mesh.corners;
    vertices += moves ? mesh.moving_vertices : mesh.still_vertices;
    colors = colors || mesh.colors;
    texcoords = texcoords || mesh.texcoords;
    if (moves) {
        moving_vertices += mesh.moving_vertices;
        deltas += mesh.deltas;
        influences += skinned ? mesh.influences : 0;
    }
    if (corners / 3 > kMaxTriangles)
        refuse(element, fmt::format("the scene has more than {} triangles", kMaxTriangles));
    if (deltas > 10 * kMaxTriangles || influences > 10 * kMaxTriangles)
        refuse(element, "too many vertices, joints and morph targets");
}

} // namespace romascope::gltf
