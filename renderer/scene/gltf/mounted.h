// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/gltf/document.h"
#include "renderer/scene/gltf/hierarchy.h"
#include "renderer/scene/gltf/notices.h"
#include "renderer/scene/scene.h"

namespace romascope::gltf {

/// Adds the cameras and lights of the nodes that are drawn to the scene, in the order of the
/// hierarchy, each where `node_to_world` puts its node; those on nodes that move are listed in
/// Scene::motion too. Camera names are made unique; orthographic cameras are left out.
/// Throws Error (kBadInput) for a transform that leaves no direction.
void add_mounted(const Document& document, const Hierarchy& hierarchy,
                 const std::vector<glm::dmat4>& node_to_world, Scene& scene, Notices& notices);

} // namespace romascope::gltf
