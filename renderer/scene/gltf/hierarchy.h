// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/gltf/document.h"
#include "renderer/scene/motion.h"

#include <vector>

namespace romascope::gltf {

/// The nodes of a file, in an order in which parents stand before their children.
struct Hierarchy {
    std::vector<MotionNode> nodes;
    std::vector<float> weights;      ///< of all nodes' morph targets
    std::vector<uint32_t> file_node; ///< per node: its index in the file
    std::vector<uint32_t> place;     ///< per node of the file: its index in `nodes`
    std::vector<bool> drawn;         ///< per node: it belongs to the scene that is drawn
    std::vector<bool> moves;         ///< per node: an animation moves it or one above it
};

/// The default scene is drawn, or the first, or, without scenes, all. `moves` is left false.
/// Throws Error (kBadInput) for a transform that is none, or not finite, and for more morph targets
/// than the budget holds.
Hierarchy read_hierarchy(const Document& document, MemoryBudget& budget);

/// Says what moves, once the animations are known.
void mark_moving(Hierarchy& hierarchy, const std::vector<Animation>& animations);

} // namespace romascope::gltf
