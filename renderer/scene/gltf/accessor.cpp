// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/accessor.h"

#include "renderer/scene/gltf/document.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>

namespace romascope::gltf {
namespace {

const char* type_name(int type) {
    switch (type) {
    case TINYGLTF_TYPE_SCALAR:
        return "SCALAR";
    case TINYGLTF_TYPE_VEC2:
        return "VEC2";
    case TINYGLTF_TYPE_VEC3:
        return "VEC3";
    case TINYGLTF_TYPE_VEC4:
        return "VEC4";
    default:
        return "a matrix";
    }
}

/// The bytes of a buffer view. Sums are arranged so that they cannot overflow.
std::span<const unsigned char> view_bytes(const tinygltf::Model& model, int index,
                                          const std::string& element) {
    if (!present(index, model.bufferViews.size(), element, "bufferView"))
        refuse(element, "has no bufferView; sparse and compressed accessors are not supported");
    const tinygltf::BufferView& view = model.bufferViews[static_cast<size_t>(index)];
    const std::string name = fmt::format("{}: bufferViews[{}]", element, index);
    if (!view.extensions.empty() && view.extensions.contains("EXT_meshopt_compression"))
        refuse(name, "compressed by EXT_meshopt_compression, which is not supported");
    if (!present(view.buffer, model.buffers.size(), name, "buffer"))
        refuse(name, "has no buffer");
    const auto& bytes = model.buffers[static_cast<size_t>(view.buffer)].data;
    if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset)
        refuse(name, fmt::format("offset {} and length {} reach beyond buffers[{}] of {} bytes",
                                 view.byteOffset, view.byteLength, view.buffer, bytes.size()));
    return std::span(bytes).subspan(view.byteOffset, view.byteLength);
}

template <class T>
void copy_indices(const AccessorSpan& span, std::vector<uint32_t>& out) {
    for (size_t i = 0; i < span.count; ++i) {
        T value;
        std::memcpy(&value, span.data + i * span.stride, sizeof(T));
        out[i] = value;
    }
}

} // namespace

bool present(int index, size_t count, const std::string& element, const char* kind) {
    if (index == -1)
        return false;
    if (index < 0 || static_cast<size_t>(index) >= count)
        refuse(element, fmt::format("{} {} does not exist, there are {}", kind, index, count));
    return true;
}

glm::vec3 AccessorSpan::vec3(size_t i) const {
    glm::vec3 value;
    std::memcpy(&value, data + i * stride, sizeof(value));
    return value;
}

AccessorSpan open_accessor(const tinygltf::Model& model, int index, int type,
                           const std::vector<int>& component_types, const std::string& element) {
    if (!present(index, model.accessors.size(), element, "accessor"))
        refuse(element, "has no accessor");
    const tinygltf::Accessor& accessor = model.accessors[static_cast<size_t>(index)];
    const std::string name = fmt::format("{}: accessors[{}]", element, index);
    if (accessor.sparse.isSparse)
        refuse(name, "sparse accessors are not supported");
    if (accessor.type != type)
        refuse(name,
               fmt::format("is {}, but {} is needed", type_name(accessor.type), type_name(type)));
    if (std::ranges::find(component_types, accessor.componentType) == component_types.end())
        refuse(name,
               fmt::format("component type {} is not supported here", accessor.componentType));
    if (accessor.count == 0)
        refuse(name, "has no elements");

    const auto bytes = view_bytes(model, accessor.bufferView, name);
    const auto& view = model.bufferViews[static_cast<size_t>(accessor.bufferView)];
    const auto component = static_cast<size_t>(
        tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(accessor.componentType)));
    const size_t element_size =
        component *
        static_cast<size_t>(tinygltf::GetNumComponentsInType(static_cast<uint32_t>(accessor.type)));
    const size_t stride = view.byteStride == 0 ? element_size : view.byteStride;
    if (stride < element_size || stride > 252 || stride % component != 0)
        refuse(name, fmt::format("byteStride {} does not fit elements of {} bytes", stride,
                                 element_size));
    if (accessor.byteOffset % component != 0)
        refuse(name, fmt::format("byteOffset {} is not a multiple of {}", accessor.byteOffset,
                                 component));
    if (accessor.byteOffset > bytes.size() || element_size > bytes.size() - accessor.byteOffset ||
        accessor.count - 1 > (bytes.size() - accessor.byteOffset - element_size) / stride)
        refuse(name,
               fmt::format("{} elements from byte {} reach beyond bufferViews[{}] of {} bytes",
                           accessor.count, accessor.byteOffset, accessor.bufferView, bytes.size()));
    return {bytes.data() + accessor.byteOffset, accessor.count, stride, accessor.componentType};
}

std::vector<uint32_t> read_indices(const tinygltf::Model& model, int accessor,
                                   const std::string& element) {
    const AccessorSpan span = open_accessor(model, accessor, TINYGLTF_TYPE_SCALAR,
                                            {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
                                             TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                                             TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT},
                                            element);
    std::vector<uint32_t> indices(span.count);
    if (span.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE)
        copy_indices<uint8_t>(span, indices);
    else if (span.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT)
        copy_indices<uint16_t>(span, indices);
    else
        copy_indices<uint32_t>(span, indices);
    return indices;
}

std::vector<glm::vec3> read_vec3(const AccessorSpan& span, size_t first, size_t count,
                                 const std::string& element) {
    std::vector<glm::vec3> values(count);
    for (size_t i = 0; i < count; ++i) {
        values[i] = span.vec3(first + i);
        if (!std::isfinite(values[i].x) || !std::isfinite(values[i].y) ||
            !std::isfinite(values[i].z))
            refuse(element, fmt::format("element {} is not finite", first + i));
    }
    return values;
}

} // namespace romascope::gltf
