// SPDX-License-Identifier: MIT
#pragma once

namespace tinygltf {
class Model;
}

namespace romascope::gltf {

/// Trees deeper than this are refused: no honest tool makes them, and each level is work.
inline constexpr int kMaxNodeDepth = 1024;

/// Checks that the nodes make trees no deeper than kMaxNodeDepth and that scenes name roots of
/// them, each once. A node with two parents could make a small file grow without bound.
/// Throws Error (kBadInput).
void check_nodes(const tinygltf::Model& model);

} // namespace romascope::gltf
