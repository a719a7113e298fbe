// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/layout.h"
#include "renderer/scene/gltf/message.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <cstring>

namespace romascope::gltf {
namespace {

/// The `i`-th of tightly packed unsigned integers of `size` bytes, little-endian.
uint32_t integer_at(const std::byte* data, size_t i, size_t size) {
    uint32_t value = 0;
    std::memcpy(&value, data + i * size, size);
    return value;
}

const std::byte* bytes_of(const Storage& storage, int view, int offset,
                          const std::string& element) {
    const auto& span = storage.views[static_cast<size_t>(view)];
    if (!span)
        refuse(element, fmt::format("the buffer of bufferViews[{}] has no data", view));
    return span->data() + offset;
}

void resolve(tinygltf::Model& model, Storage& storage, tinygltf::Accessor& accessor,
             const std::string& element) {
    const ElementLayout layout = element_layout(accessor.type, accessor.componentType);
    auto dense = storage.allocate(accessor.count, layout.stride(), element);
    if (accessor.bufferView >= 0) {
        const size_t stride = element_stride(model, accessor);
        const auto& base = storage.views[static_cast<size_t>(accessor.bufferView)];
        if (!base)
            refuse(element,
                   fmt::format("the buffer of bufferViews[{}] has no data", accessor.bufferView));
        for (size_t i = 0; i < accessor.count; ++i)
            std::memcpy(dense.data() + i * layout.stride(),
                        base->data() + accessor.byteOffset + i * stride, layout.size());
    }
    const auto& sparse = accessor.sparse;
    const std::byte* indices = bytes_of(storage, sparse.indices.bufferView,
                                        sparse.indices.byteOffset, element + ".sparse.indices");
    const std::byte* values = bytes_of(storage, sparse.values.bufferView, sparse.values.byteOffset,
                                       element + ".sparse.values");
    const size_t width =
        element_layout(TINYGLTF_TYPE_SCALAR, sparse.indices.componentType).component;
    for (size_t i = 0; i < static_cast<size_t>(sparse.count); ++i) {
        const size_t index = integer_at(indices, i, width);
        if (index >= accessor.count)
            refuse(
                element + ".sparse.indices",
                fmt::format("number {} names element {}, there are {}", i, index, accessor.count));
        if (i > 0 && index <= integer_at(indices, i - 1, width))
            refuse(element + ".sparse.indices", fmt::format("number {} does not increase", i));
        std::memcpy(dense.data() + index * layout.stride(), values + i * layout.stride(),
                    layout.size());
    }
    accessor.bufferView = storage.add_view(model, std::move(dense));
    accessor.byteOffset = 0;
    accessor.sparse.isSparse = false;
}

} // namespace

void resolve_sparse(tinygltf::Model& model, Storage& storage) {
    for (size_t i = 0; i < model.accessors.size(); ++i)
        if (model.accessors[i].sparse.isSparse)
            resolve(model, storage, model.accessors[i], fmt::format("accessors[{}]", i));
}

} // namespace romascope::gltf
