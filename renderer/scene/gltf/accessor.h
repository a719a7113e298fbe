// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/gltf/document.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace romascope::gltf {

/// What an accessor may be where it is used, in tinygltf's numbers.
struct AccessorKind {
    int type;                         ///< TINYGLTF_TYPE_*
    std::vector<int> component_types; ///< TINYGLTF_COMPONENT_TYPE_*, in any normalisation
};

/// The numbers of an accessor: normalised integers become [0, 1] or [-1, 1] (glTF 2.0, 3.11), other
/// integers keep their value (KHR_mesh_quantization), an accessor without a view is zero. Valid as
/// long as the document.
class AccessorReader {
public:
    /// `element` names the user of the accessor. Throws Error (kBadInput) if it is not of `kind`.
    AccessorReader(const Document& document, int accessor, const AccessorKind& kind,
                   std::string element);

    size_t count() const { return count_; }
    int components() const { return components_; }

    /// Component `c` of element `i` < count. Throws Error (kBadInput) if it is not finite.
    float number(size_t i, int c = 0) const;
    glm::vec2 vec2(size_t i) const;
    glm::vec3 vec3(size_t i) const;
    glm::vec4 vec4(size_t i) const;
    /// Column-major, as stored; columns of small integers are padded (glTF 2.0, 3.6.2.4).
    glm::mat4 mat4(size_t i) const;
    /// An integer component as it is: indices, joints.
    uint32_t integer(size_t i, int c = 0) const;

private:
    void read(size_t i, int first, int n, float* out) const;
    const std::byte* at(size_t i, int c) const;

    const std::byte* data_ = nullptr; ///< null: zeros
    size_t count_ = 0, stride_ = 0;
    size_t component_ = 0;                ///< bytes
    size_t rows_ = 0, column_stride_ = 0; ///< see ElementLayout
    int components_ = 0, component_type_ = 0;
    bool normalized_ = false;
    std::string element_;
};

/// Indices of a primitive: u8, u16 or u32, each below `vertex_count`; the value that means
/// primitive restart is refused. Throws Error (kBadInput).
std::vector<uint32_t> read_indices(const Document& document, int accessor, size_t vertex_count,
                                   const std::string& element);

} // namespace romascope::gltf
