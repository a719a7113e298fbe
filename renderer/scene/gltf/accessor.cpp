// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/accessor.h"

#include "renderer/scene/gltf/layout.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

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

template <class T>
T load(const std::byte* from) {
    T value;
    std::memcpy(&value, from, sizeof(value));
    return value;
}

/// Normalised: 3.11 of the specification.
template <class T>
float to_float(const std::byte* from, bool normalized) {
    const auto value = static_cast<float>(load<T>(from));
    if (!normalized)
        return value;
    return std::max(value / static_cast<float>(std::numeric_limits<T>::max()), -1.0f);
}

float to_float(const std::byte* from, int component_type, bool normalized) {
    switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return to_float<int8_t>(from, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return to_float<uint8_t>(from, normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return to_float<int16_t>(from, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return to_float<uint16_t>(from, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return to_float<uint32_t>(from, normalized);
    default:
        return load<float>(from);
    }
}

} // namespace

AccessorReader::AccessorReader(const Document& document, int accessor, const AccessorKind& kind,
                               std::string element)
    : element_(std::move(element)) {
    const tinygltf::Model& model = document.model();
    if (accessor < 0 || static_cast<size_t>(accessor) >= model.accessors.size())
        refuse(element_, "has no accessor");
    const tinygltf::Accessor& source = model.accessors[static_cast<size_t>(accessor)];
    const auto name = [&] { return fmt::format("{}: accessors[{}]", element_, accessor); };
    if (source.type != kind.type)
        refuse(name(), fmt::format("is {}, but {} is needed", type_name(source.type),
                                   type_name(kind.type)));
    if (std::ranges::find(kind.component_types, source.componentType) == kind.component_types.end())
        refuse(name(), fmt::format("component type {} does not go here", source.componentType));
    const ElementLayout layout = element_layout(source.type, source.componentType);
    count_ = source.count;
    stride_ = element_stride(model, source);
    component_ = layout.component;
    rows_ = layout.rows;
    column_stride_ = layout.column_stride;
    components_ = static_cast<int>(layout.rows * layout.columns);
    component_type_ = source.componentType;
    normalized_ = source.normalized;
    if (source.bufferView >= 0) // the document has checked that all elements lie in the view
        data_ = document.view(source.bufferView).data() + source.byteOffset;
}

const std::byte* AccessorReader::at(size_t i, int c) const {
    const auto component = static_cast<size_t>(c);
    return data_ + i * stride_ + component / rows_ * column_stride_ +
           component % rows_ * component_;
}

void AccessorReader::read(size_t i, int first, int n, float* out) const {
    for (int c = 0; c < n; ++c) {
        out[c] = data_ ? to_float(at(i, first + c), component_type_, normalized_) : 0.0f;
        if (!std::isfinite(out[c]))
            refuse(element_, fmt::format("element {} is not finite", i));
    }
}

float AccessorReader::number(size_t i, int c) const {
    float value;
    read(i, c, 1, &value);
    return value;
}

glm::vec2 AccessorReader::vec2(size_t i) const {
    glm::vec2 value;
    read(i, 0, 2, &value.x);
    return value;
}

glm::vec3 AccessorReader::vec3(size_t i) const {
    glm::vec3 value;
    read(i, 0, 3, &value.x);
    return value;
}

glm::vec4 AccessorReader::vec4(size_t i) const {
    glm::vec4 value;
    read(i, 0, 4, &value.x);
    return value;
}

glm::mat4 AccessorReader::mat4(size_t i) const {
    glm::mat4 value;
    read(i, 0, 16, &value[0].x);
    return value;
}

uint32_t AccessorReader::integer(size_t i, int c) const {
    if (!data_)
        return 0;
    switch (component_type_) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return load<uint8_t>(at(i, c));
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return load<uint16_t>(at(i, c));
    default:
        return load<uint32_t>(at(i, c));
    }
}

std::vector<uint32_t> read_indices(const Document& document, int accessor, size_t vertex_count,
                                   const std::string& element) {
    const AccessorReader reader(
        document, accessor,
        {TINYGLTF_TYPE_SCALAR,
         {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
          TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT}},
        element);
    std::vector<uint32_t> indices(reader.count());
    for (size_t i = 0; i < indices.size(); ++i) {
        indices[i] = reader.integer(i);
        if (indices[i] >= vertex_count)
            refuse(element, fmt::format("index {} names vertex {}, there are {}", i, indices[i],
                                        vertex_count));
    }
    return indices;
}

} // namespace romascope::gltf
