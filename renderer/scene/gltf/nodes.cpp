// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/nodes.h"

#include "renderer/scene/gltf/message.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <vector>

namespace romascope::gltf {
namespace {

constexpr int kNone = -1;

std::vector<int> parents_of(const tinygltf::Model& model) {
    std::vector<int> parents(model.nodes.size(), kNone);
    for (size_t i = 0; i < model.nodes.size(); ++i)
        for (size_t c = 0; c < model.nodes[i].children.size(); ++c) {
            const int child = model.nodes[i].children[c];
            int& parent = parents[static_cast<size_t>(child)];
            if (parent != kNone)
                refuse(fmt::format("nodes[{}].children[{}]", i, c),
                       fmt::format("node {} is a child of node {} already", child, parent));
            parent = static_cast<int>(i);
        }
    return parents;
}

} // namespace

void check_nodes(const tinygltf::Model& model) {
    const std::vector<int> parents = parents_of(model);
    // From the roots down, level by level. As no node has two parents, none is met twice, and
    // those that are not met at all form cycles.
    std::vector<int> level;
    for (size_t i = 0; i < parents.size(); ++i)
        if (parents[i] == kNone)
            level.push_back(static_cast<int>(i));
    std::vector<bool> met(parents.size(), false);
    for (int depth = 1; !level.empty(); ++depth) {
        if (depth > kMaxNodeDepth)
            refuse(fmt::format("nodes[{}]", level.front()),
                   fmt::format("its tree is deeper than {} levels", kMaxNodeDepth));
        std::vector<int> below;
        for (const int node : level) {
            const auto index = static_cast<size_t>(node);
            met[index] = true;
            const auto& children = model.nodes[index].children;
            below.insert(below.end(), children.begin(), children.end());
        }
        level.swap(below);
    }
    for (size_t i = 0; i < met.size(); ++i)
        if (!met[i])
            refuse(fmt::format("nodes[{}]", i), "is its own descendant: the nodes form a cycle");

    std::vector<size_t> named(parents.size(), 0); // by which scene last, counted from 1
    for (size_t s = 0; s < model.scenes.size(); ++s) {
        for (size_t n = 0; n < model.scenes[s].nodes.size(); ++n) {
            const auto node = static_cast<size_t>(model.scenes[s].nodes[n]);
            const std::string element = fmt::format("scenes[{}].nodes[{}]", s, n);
            if (parents[node] != kNone)
                refuse(element, fmt::format("node {} is a child of node {}, but must be a root",
                                            node, parents[node]));
            if (named[node] == s + 1)
                refuse(element, fmt::format("node {} is named twice", node));
            named[node] = s + 1;
        }
    }
}

} // namespace romascope::gltf
