// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/gltf/hierarchy.h"
#include "renderer/scene/gltf/piece.h"

#include <vector>

namespace romascope::gltf {

/// Writes the meshes of the nodes that are drawn into a scene: what stands still in world space, at
/// `node_to_world`, then what moves, at rest, with its part of Scene::motion (whose nodes, weights,
/// skins and animations must be there). What is written is taken from the budget before any of it
/// is. Throws Error (kBadInput).
void add_instances(const Document& document, const Hierarchy& hierarchy,
                   const std::vector<glm::dmat4>& node_to_world, Scene& scene, MemoryBudget& budget,
                   Notices& notices);

} // namespace romascope::gltf
