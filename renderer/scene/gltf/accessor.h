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

/// True if `index` names one of `count` things; false if it is -1, tinygltf's "absent".
/// Throws Error "ELEMENT: KIND index does not exist, there are count".
bool present(int index, size_t count, const std::string& element, const char* kind);

/// The bytes of an accessor, every element of which lies inside its buffer.
struct AccessorSpan {
    const unsigned char* data = nullptr;
    size_t count = 0;
    size_t stride = 0; ///< bytes
    int component_type = 0;

    /// Element `i` < count, three floats.
    glm::vec3 vec3(size_t i) const;
};

/// Checks accessor, view, buffer, offsets, stride and count before anything is read or allocated.
/// `type` and `component_types`: what is allowed, in tinygltf's numbers; `element` names the user
/// of the accessor. Throws Error (kBadInput).
AccessorSpan open_accessor(const tinygltf::Model& model, int accessor, int type,
                           const std::vector<int>& component_types, const std::string& element);

/// Indices of a primitive: u8, u16 or u32. Not yet compared with the number of vertices.
std::vector<uint32_t> read_indices(const tinygltf::Model& model, int accessor,
                                   const std::string& element);

/// Elements first .. first + count of a float VEC3 accessor, all finite.
std::vector<glm::vec3> read_vec3(const AccessorSpan& span, size_t first, size_t count,
                                 const std::string& element);

} // namespace romascope::gltf
