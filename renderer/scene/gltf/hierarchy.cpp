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

/// Nodes that show one mesh multiply its morph targets; no honest file comes near this.
constexpr size_t kMaxWeights = 100'000'000;

/// Per mesh: the most targets that a primitive of it has.
std::vector<size_t> target_counts(const tinygltf::Model& model) {
    std::vector<size_t> counts;
    for (const tinygltf::Mesh& mesh : model.meshes) {
        size_t most = 0;
        for (const tinygltf::Primitive& primitive : mesh.primitives)
            most = std::max(most, primitive.targets.size());
        counts.push_back(most);
    }
    return counts;
}

/// Adds the weights of the morph targets of a node's mesh: its own, its mesh's, or zeros.
void add_weights(const tinygltf::Model& model, const tinygltf::Node& source, size_t targets,
                 const std::string& element, Hierarchy& hierarchy, MotionNode& node) {
    auto& weights = hierarchy.weights;
    if (targets > kMaxWeights - weights.size())
        refuse(element + ".mesh",
               fmt::format("the nodes have more than {} morph targets in all", kMaxWeights));
    node.first_weight = static_cast<uint32_t>(weights.size());
    node.weight_count = static_cast<uint32_t>(targets);
    weights.resize(weights.size() + targets, 0.0f);
    const auto& own = source.weights;
    const auto& given = own.empty() ? model.meshes[static_cast<size_t>(source.mesh)].weights : own;
    for (size_t i = 0; i < std::min(targets, given.size()); ++i) {
        if (!(std::abs(given[i]) <= kMaxCoordinate))
            refuse(fmt::format("{}.weights[{}]", element, i), "is not a sane number");
        weights[node.first_weight + i] = static_cast<float>(given[i]);
    }
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

Hierarchy read_hierarchy(const Document& document, MemoryBudget& budget) {
    const tinygltf::Model& model = document.model();
    const size_t count = model.nodes.size();
    Hierarchy hierarchy;
    hierarchy.place.resize(count);
    const std::vector<size_t> targets = target_counts(model);
    std::vector<bool> has_parent(count, false);
    for (const tinygltf::Node& node : model.nodes)
        for (const int child : node.children)
            has_parent[static_cast<size_t>(child)] = true;
    const std::vector<int> roots = scene_roots(model, has_parent); // checked: no one's children
    std::vector<bool> drawn_root(count, false);
    for (const int root : roots)
        drawn_root[static_cast<size_t>(root)] = true;

    // Depth first, with a stack of its own: hierarchies may be deeper than the program's stack.
    struct Visit {
        uint32_t node;
        int parent;
        bool drawn;
    };
    std::vector<Visit> stack;
    for (size_t i = count; i-- > 0;)
        if (!has_parent[i] && !drawn_root[i])
            stack.push_back({static_cast<uint32_t>(i), -1, false});
    for (auto root = roots.rbegin(); root != roots.rend(); ++root)
        stack.push_back({static_cast<uint32_t>(*root), -1, true});
    while (!stack.empty()) {
        const Visit visit = stack.back();
        stack.pop_back();
        const tinygltf::Node& source = model.nodes[visit.node];
        const std::string element = fmt::format("nodes[{}]", visit.node);
        const auto place = static_cast<uint32_t>(hierarchy.nodes.size());
        MotionNode node;
        node.parent = visit.parent;
        read_transform(source, element, node);
        if (const size_t most = source.mesh < 0 ? 0 : targets[static_cast<size_t>(source.mesh)]) {
            // Kept here, in the scene's motion, and in each pose.
            budget.take(most, 2 * sizeof(float) + sizeof(double), element + ".mesh");
            add_weights(model, source, most, element, hierarchy, node);
        }
        hierarchy.nodes.push_back(node);
        hierarchy.file_node.push_back(visit.node);
        hierarchy.place[visit.node] = place;
        hierarchy.drawn.push_back(visit.drawn);
        for (auto child = source.children.rbegin(); child != source.children.rend(); ++child)
            stack.push_back({static_cast<uint32_t>(*child), static_cast<int>(place), visit.drawn});
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
