// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/gltf/material.h"

#include <cstddef>
#include <string>

namespace romascope::gltf {

/// Most that an instance of a mesh can come to hold, from counts alone.
struct MeshPlan {
    size_t corners = 0;
    size_t still_vertices = 0;  ///< where it stands still
    size_t moving_vertices = 0; ///< where it moves
    size_t influences = 0, deltas = 0;
    bool texcoords = false, colors = false;
};

MeshPlan plan_mesh(const tinygltf::Model& model, size_t mesh, const Materials& materials);

/// Most that a scene can come to hold.
struct Plan {
    size_t vertices = 0, corners = 0;
    size_t moving_vertices = 0, influences = 0, deltas = 0;
    bool texcoords = false, colors = false;

    /// Adds an instance. Throws Error (kBadInput) naming `element` for more than any scene should
    /// have: instances can multiply a small file beyond any patience.
    void add(const MeshPlan& mesh, bool moves, bool skinned, const std::string& element);
};

} // namespace romascope::gltf
