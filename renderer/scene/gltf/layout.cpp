// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/layout.h"

#include "renderer/scene/gltf/message.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

namespace romascope::gltf {
namespace {

/// True if `count` elements of `size` bytes, `stride` apart, from `offset` on, fit into `length`
/// bytes. Nothing here can overflow.
bool fits(size_t offset, size_t count, size_t stride, size_t size, size_t length) {
    if (count == 0)
        return offset <= length;
    return offset <= length && size <= length - offset &&
           count - 1 <= (length - offset - size) / stride;
}

void check_views(const tinygltf::Model& model, const std::vector<size_t>& buffer_sizes) {
    for (size_t i = 0; i < model.bufferViews.size(); ++i) {
        const tinygltf::BufferView& view = model.bufferViews[i];
        const size_t size = buffer_sizes[static_cast<size_t>(view.buffer)];
        if (!fits(view.byteOffset, view.byteLength, 1, 1, size))
            refuse(fmt::format("bufferViews[{}]", i),
                   fmt::format("{} bytes from byte {} reach beyond buffers[{}] of {} bytes",
                               view.byteLength, view.byteOffset, view.buffer, size));
    }
}

void check_accessor(const tinygltf::Model& model, const tinygltf::Accessor& accessor,
                    const std::string& element) {
    if (accessor.bufferView < 0)
        return; // zeros
    const auto& view = model.bufferViews[static_cast<size_t>(accessor.bufferView)];
    const ElementLayout layout = element_layout(accessor.type, accessor.componentType);
    const size_t stride = element_stride(model, accessor);
    if (stride < layout.size())
        refuse(element, fmt::format("byteStride {} of bufferViews[{}] is less than an element's {} "
                                    "bytes",
                                    stride, accessor.bufferView, layout.size()));
    if (!fits(accessor.byteOffset, accessor.count, stride, layout.size(), view.byteLength))
        refuse(element,
               fmt::format("{} elements from byte {} reach beyond bufferViews[{}] of {} bytes",
                           accessor.count, accessor.byteOffset, accessor.bufferView,
                           view.byteLength));
}

void check_sparse(const tinygltf::Model& model, const tinygltf::Accessor& accessor,
                  const std::string& element) {
    const auto& sparse = accessor.sparse;
    const auto count = static_cast<size_t>(sparse.count);
    if (count > accessor.count)
        refuse(element + ".count",
               fmt::format("{}, more than the {} elements there are", count, accessor.count));
    const auto check = [&](int view, int offset, ElementLayout layout, const char* part) {
        const auto& source = model.bufferViews[static_cast<size_t>(view)];
        if (source.byteStride != 0)
            refuse(element + part, fmt::format("bufferViews[{}] must not have a byteStride", view));
        if (!fits(static_cast<size_t>(offset), count, layout.stride(), layout.size(),
                  source.byteLength))
            refuse(element + part,
                   fmt::format("{} elements from byte {} reach beyond bufferViews[{}] of {} bytes",
                               count, offset, view, source.byteLength));
    };
    check(sparse.indices.bufferView, sparse.indices.byteOffset,
          element_layout(TINYGLTF_TYPE_SCALAR, sparse.indices.componentType), ".indices");
    check(sparse.values.bufferView, sparse.values.byteOffset,
          element_layout(accessor.type, accessor.componentType), ".values");
}

} // namespace

ElementLayout element_layout(int type, int component_type) {
    const bool matrix =
        type == TINYGLTF_TYPE_MAT2 || type == TINYGLTF_TYPE_MAT3 || type == TINYGLTF_TYPE_MAT4;
    const auto numbers =
        static_cast<size_t>(tinygltf::GetNumComponentsInType(static_cast<uint32_t>(type)));
    ElementLayout layout;
    layout.component = static_cast<size_t>(
        tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(component_type)));
    layout.rows = type == TINYGLTF_TYPE_MAT2   ? 2
                  : type == TINYGLTF_TYPE_MAT3 ? 3
                  : type == TINYGLTF_TYPE_MAT4 ? 4
                                               : numbers;
    layout.columns = numbers / layout.rows;
    layout.column_stride = layout.rows * layout.component;
    if (matrix)
        layout.column_stride = (layout.column_stride + 3) / 4 * 4;
    return layout;
}

size_t element_stride(const tinygltf::Model& model, const tinygltf::Accessor& accessor) {
    const size_t given =
        accessor.bufferView < 0
            ? 0
            : model.bufferViews[static_cast<size_t>(accessor.bufferView)].byteStride;
    return given ? given : element_layout(accessor.type, accessor.componentType).stride();
}

void check_layout(const tinygltf::Model& model, const std::vector<size_t>& buffer_sizes) {
    check_views(model, buffer_sizes);
    for (size_t i = 0; i < model.accessors.size(); ++i) {
        const std::string element = fmt::format("accessors[{}]", i);
        check_accessor(model, model.accessors[i], element);
        if (model.accessors[i].sparse.isSparse)
            check_sparse(model, model.accessors[i], element + ".sparse");
    }
}

} // namespace romascope::gltf
