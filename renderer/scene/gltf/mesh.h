// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
}

namespace romascope::gltf {

/// One primitive as an indexed list of triangles in the mesh's own space.
struct Triangles {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals; ///< per vertex; unit length, or zero where nothing defines it
    std::vector<uint32_t> indices;  ///< three per triangle, counter-clockwise from outside
    int material = -1;              ///< -1: none given
};

/// All primitives of meshes[mesh] that consist of triangles; points and lines are left out.
/// Only vertices near those in use are kept, as primitives may share one large buffer.
/// Throws Error (kBadInput) naming the element at fault.
std::vector<Triangles> convert_mesh(const tinygltf::Model& model, size_t mesh);

} // namespace romascope::gltf
