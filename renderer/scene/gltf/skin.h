// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/gltf/hierarchy.h"
#include "renderer/scene/gltf/notices.h"

#include <vector>

namespace romascope::gltf {

/// All skins of the file. Throws Error (kBadInput) for matrices that do not fit the joints, or are
/// not finite.
std::vector<Skin> read_skins(const Document& document, const Hierarchy& hierarchy,
                             MemoryBudget& budget);

/// The pairs JOINTS_n, WEIGHTS_n of a primitive, for n from 0 on.
struct InfluenceAccessors {
    std::vector<int> joints, weights;
};

/// The accessors of the sets that a primitive has; empty: it is rigid. Throws Error (kBadInput) for
/// joints without weights and the reverse.
InfluenceAccessors influence_accessors(const tinygltf::Model& model, size_t mesh, size_t primitive);

/// Influences of the vertices `sources` of a primitive, all sets of a vertex in turn; their
/// weights' sum is 1. Throws Error (kBadInput) for joints that the skin does not have, negative
/// weights, and accessors that do not have `vertex_count` elements.
std::vector<Influence> read_influences(const Document& document, const InfluenceAccessors& from,
                                       const std::vector<uint32_t>& sources, size_t vertex_count,
                                       const Skin& skin, const std::string& element,
                                       Notices& notices);

} // namespace romascope::gltf
