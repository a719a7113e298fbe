// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/hierarchy.h"

#include "renderer/scene/gltf/numbers.h"

#include <tiny_gltf.h>

#include <algorithm>

namespace romascope::gltf {
namespace {

glm::dmat4 read_matrix(const std::vector<double>& values, const std::string& element) {
    if (values.size() != 16)
        refuse(element, fmt::format("has {} numbers instead of 16", values.size()));
    glm::dmat4 matrix;
    for (int i = 0; i < 16; ++i) {
        const double value = values[static_cast<size_t>(i)];
        if (!std::isfinite(value))
            refuse(element, "is not finite");
        matrix[i / 4][i % 4] = value; // column-major, as in glTF
    }
    const glm::dvec4 row(matrix[0][3], matrix[1][3], matrix[2][3], matrix[3][3]);
    if (glm::distance(row, glm::dvec4(0.0, 0.0, 0.0, 1.0)) > 1e-5)
        refuse(element, "is not affine: its last row must be 0 0 0 1");
    return matrix;
}

void read_transform(const tinygltf::Node& source, const std::string& element, MotionNode& node) {
    if (!source.matrix.empty()) {
        node.has_matrix = true;
        node.matrix = read_matrix(source.matrix, element + ".matrix");
        return;
    }
    node.translation = numbers<3>(source.translation, glm::dvec3(0.0), element + ".translation");
    node.scale = numbers<3>(source.scale, glm::dvec3(1.0), element + ".scale");
    const auto turn =
        numbers<4>(source.rotation, glm::dvec4(0.0, 0.0, 0.0, 1.0), element + ".rotation");
    const double length = glm::length(turn);
    if (!(length > 0.0) || !std::isfinite(length))
        refuse(element + ".rotation", "is not a quaternion of unit length");
    node.rotation.x = turn.x / length;
    node.rotation.y = turn.y / length;
    node.rotation.z = turn.z / length;
    node.rotation.w = turn.w / length;
}

/// The weights of the morph targets of a node's mesh: its own, its mesh's, or zeros.
std::vector<float> read_weights(const tinygltf::Model& model, const tinygltf::Node& node,
                                const std::string& element) {
    if (node.mesh < 0)
        return {};
    const tinygltf::Mesh& mesh = model.meshes[static_cast<size_t>(node.mesh)];
    size_t targets = 0;
    for (const tinygltf::Primitive& primitive : mesh.primitives)
        targets = std::max(targets, primitive.targets.size());
    const auto& given = node.weights.empty() ? mesh.weights : node.weights;
    std::vector<float> weights(targets, 0.0f);
    for (size_t i = 0; i < std::min(targets, given.size()); ++i) {
        weights[i] = static_cast<float>(given[i]);
        if (!(std::abs(given[i]) <= kMaxCoordinate))
            refuse(fmt::format("{}.weights[{}]", element, i), "is not a sane number");
    }
    return weights;
}

/// Nodes of the scene that is drawn, by their index in the file.
std::vector<int> scene_roots(const tinygltf::Model& model, const std::vector<bool>& has_parent) {
    if (!model.scenes.empty())
        return model.scenes[static_cast<size_t>(std::max(model.defaultScene, 0))].nodes;
    std::vector<int> roots;
    for (size_t i = 0; i < has_parent.size(); ++i)
        if (!has_parent[i])
            roots.push_back(static_cast<int>(i));
    return roots;
}

} // namespace

Hierarchy read_hierarchy(const Document& document) {
    const tinygltf::Model& model = document.model();
    const size_t count = model.nodes.size();
    Hierarchy hierarchy;
    hierarchy.place.resize(count);
    std::vector<bool> has_parent(count, false);
    for (const tinygltf::Node& node : model.nodes)
        for (const int child : node.children)
            has_parent[static_cast<size_t>(child)] = true;
    const std::vector<int> roots = scene_roots(model, has_parent);
    std::vector<bool> in_scene(count, false);
    for (const int root : roots)
        in_scene[static_cast<size_t>(root)] = true;

    // Depth first, with a stack of its own: hierarchies may be deeper than the program's stack.
    struct Visit {
        uint32_t node;
        int parent;
        bool drawn;
    };
    std::vector<Visit> stack;
    for (size_t i = count; i-- > 0;)
        if (!has_parent[i] && !in_scene[i])
            stack.push_back({static_cast<uint32_t>(i), -1, false});
    for (auto root = roots.rbegin(); root != roots.rend(); ++root)
        if (!has_parent[static_cast<size_t>(*root)]) // others are drawn below their parents
            stack.push_back({static_cast<uint32_t>(*root), -1, true});
    while (!stack.empty()) {
        const Visit visit = stack.back();
        stack.pop_back();
        const tinygltf::Node& source = model.nodes[visit.node];
        const std::string element = fmt::format("nodes[{}]", visit.node);
        const auto place = static_cast<uint32_t>(hierarchy.nodes.size());
        const bool drawn = visit.drawn || in_scene[visit.node];
        MotionNode node;
        node.parent = visit.parent;
        read_transform(source, element, node);
        const std::vector<float> weights = read_weights(model, source, element);
        node.first_weight = static_cast<uint32_t>(hierarchy.weights.size());
        node.weight_count = static_cast<uint32_t>(weights.size());
        hierarchy.weights.insert(hierarchy.weights.end(), weights.begin(), weights.end());
        hierarchy.nodes.push_back(node);
        hierarchy.file_node.push_back(visit.node);
        hierarchy.place[visit.node] = place;
        hierarchy.drawn.push_back(drawn);
        for (auto child = source.children.rbegin(); child != source.children.rend(); ++child)
            stack.push_back({static_cast<uint32_t>(*child), static_cast<int>(place), drawn});
    }
    hierarchy.moves.resize(count, false);
    return hierarchy;
}

void mark_moving(Hierarchy& hierarchy, const std::vector<Animation>& animations) {
    for (const Animation& animation : animations)
        for (const MotionChannel& channel : animation.channels)
            if (channel.path != MotionPath::weights)
                hierarchy.moves[channel.node] = true;
    for (size_t i = 0; i < hierarchy.nodes.size(); ++i)
        if (const int parent = hierarchy.nodes[i].parent; parent >= 0)
            hierarchy.moves[i] = hierarchy.moves[i] || hierarchy.moves[static_cast<size_t>(parent)];
}

} // namespace romascope::gltf
