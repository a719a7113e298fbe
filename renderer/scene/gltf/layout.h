// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/gltf/storage.h"

#include <cstddef>
#include <vector>

namespace tinygltf {
struct Accessor;
class Model;
} // namespace tinygltf

namespace romascope::gltf {

/// Where the numbers of an element lie.
struct ElementLayout {
    size_t component = 0; ///< bytes of a number
    size_t rows = 0, columns = 0;
    size_t column_stride = 0; ///< bytes; columns of matrices start at multiples of 4 (3.6.2.4)

    size_t size() const { return (columns - 1) * column_stride + rows * component; }
    size_t stride() const { return columns * column_stride; } ///< where a view gives none
};

/// `type` and `component_type` in tinygltf's numbers.
ElementLayout element_layout(int type, int component_type);

/// Bytes from one element to the next.
size_t element_stride(const tinygltf::Model& model, const tinygltf::Accessor& accessor);

/// Checks that every view lies in its buffer and every accessor, sparse parts included, in its
/// view. `buffer_sizes`: in bytes. Throws Error (kBadInput).
void check_layout(const tinygltf::Model& model, const std::vector<size_t>& buffer_sizes);

/// Gives every sparse accessor a view of its own with the elements in their place.
/// Throws Error (kBadInput) if its indices do not increase or reach beyond the accessor.
void resolve_sparse(tinygltf::Model& model, Storage& storage);

} // namespace romascope::gltf
