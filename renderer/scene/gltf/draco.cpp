// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/draco.h"

#include "renderer/scene/gltf/draco_header.h"
#include "renderer/scene/gltf/layout.h"
#include "renderer/scene/gltf/message.h"

#include <draco/compression/decode.h>
#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <memory>
#include <tuple>

namespace romascope::gltf {
namespace {

constexpr const char* kExtension = "KHR_draco_mesh_compression";

/// Bytes that the library takes for its own tables, rounded up from what was measured: 128 MB in
/// all for 980,000 triangles, 491,401 vertices and three attributes encoded by edgebreaker.
constexpr size_t kPerFace = 128, kPerPoint = 64, kPerFaceOfAttribute = 32;

/// What a primitive asks for. Equal ones are decoded once.
struct Request {
    int view = 0, indices = -1;
    bool list = true; ///< the primitive's corners are a list, so that their number is known
    /// Name, number in the Draco data, accessor.
    std::vector<std::tuple<std::string, int, int>> attributes;

    auto operator<=>(const Request&) const = default;
};

/// Accessors instead of the request's.
struct Decoded {
    int indices = -1;
    std::map<std::string, int> attributes;
};

Request request_of(const tinygltf::Primitive& primitive, const std::string& element) {
    const tinygltf::Value& extension = primitive.extensions.at(kExtension);
    Request request;
    request.view = extension.Get("bufferView").GetNumberAsInt();
    request.indices = primitive.indices;
    request.list = primitive.mode == TINYGLTF_MODE_TRIANGLES;
    if (!request.list && primitive.mode != TINYGLTF_MODE_TRIANGLE_STRIP)
        refuse(element, fmt::format("does not go with mode {}", primitive.mode));
    for (const std::string& name : extension.Get("attributes").Keys()) {
        const auto accessor = primitive.attributes.find(name);
        if (accessor == primitive.attributes.end())
            refuse(element + ".attributes." + name, "the primitive has no such attribute");
        request.attributes.emplace_back(
            name, extension.Get("attributes").Get(name).GetNumberAsInt(), accessor->second);
    }
    return request;
}

template <class T>
bool convert(const draco::PointAttribute& attribute, size_t points, int components,
             std::byte* out) {
    T values[4] = {};
    for (uint32_t i = 0; i < points; ++i) {
        const auto index = attribute.mapped_index(draco::PointIndex(i));
        if (index.value() >= attribute.size() ||
            !attribute.ConvertValue<T>(index, static_cast<int8_t>(components), values))
            return false;
        std::memcpy(out, values, sizeof(T) * static_cast<size_t>(components));
        out += sizeof(T) * static_cast<size_t>(components);
    }
    return true;
}

bool convert(const draco::PointAttribute& attribute, size_t points, int components,
             int component_type, std::byte* out) {
    switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return convert<int8_t>(attribute, points, components, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return convert<uint8_t>(attribute, points, components, out);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return convert<int16_t>(attribute, points, components, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return convert<uint16_t>(attribute, points, components, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return convert<uint32_t>(attribute, points, components, out);
    default:
        return convert<float>(attribute, points, components, out);
    }
}

/// Compares what the data says about itself with what the file says about it.
void check_header(const DracoHeader& header, const Request& request, const tinygltf::Model& model,
                  const std::string& element) {
    const auto count = [&](int accessor) {
        return model.accessors[static_cast<size_t>(accessor)].count;
    };
    if (request.list && request.indices >= 0 && 3 * header.faces > count(request.indices))
        refuse(element, fmt::format("its Draco data has {} triangles, but accessors[{}] only {} "
                                    "indices",
                                    header.faces, request.indices, count(request.indices)));
    for (const auto& [name, id, accessor] : request.attributes)
        if (header.vertices > count(accessor))
            refuse(element, fmt::format("its Draco data has {} vertices, but accessors[{}] only {}",
                                        header.vertices, accessor, count(accessor)));
}

/// Bytes that decoding takes besides its results. After check_header, so that nothing overflows.
size_t working_memory(const DracoHeader& header, const Request& request,
                      const tinygltf::Model& model) {
    size_t points = 3 * header.faces; // none is unused
    size_t per_point = kPerPoint;
    for (const auto& [name, id, accessor] : request.attributes) {
        const auto& like = model.accessors[static_cast<size_t>(accessor)];
        points = std::min(points, like.count);
        per_point += 3 * element_layout(like.type, like.componentType).size();
    }
    const size_t attributes = std::max(request.attributes.size(), header.seamed);
    return (kPerFace + kPerFaceOfAttribute * attributes) * header.faces + per_point * points;
}

std::unique_ptr<draco::Mesh> decode_bytes(std::span<const std::byte> bytes,
                                          const std::string& element) {
    std::string reason;
    try {
        draco::DecoderBuffer buffer;
        buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        draco::Decoder decoder;
        auto mesh = decoder.DecodeMeshFromBuffer(&buffer);
        if (mesh.ok() && mesh.value())
            return std::move(mesh).value();
        reason = mesh.status().error_msg_string();
    } catch (const std::exception& exception) { // e.g. bad_alloc
        reason = exception.what();
    }
    refuse(element, fmt::format("its Draco data is broken ({})", reason));
}

int add_accessor(tinygltf::Model& model, Storage& storage, tinygltf::Accessor accessor,
                 size_t count, std::vector<std::byte> bytes) {
    accessor.bufferView = storage.add_view(model, std::move(bytes));
    accessor.byteOffset = 0;
    accessor.count = count;
    accessor.sparse.isSparse = false;
    model.accessors.push_back(std::move(accessor));
    return static_cast<int>(model.accessors.size() - 1);
}

int add_indices(tinygltf::Model& model, Storage& storage, const draco::Mesh& mesh,
                const std::string& element) {
    auto bytes = storage.allocate(mesh.num_faces(), 3 * sizeof(uint32_t), element);
    for (uint32_t f = 0; f < mesh.num_faces(); ++f) {
        const auto& face = mesh.face(draco::FaceIndex(f));
        for (size_t corner = 0; corner < 3; ++corner) {
            const uint32_t point = face[corner].value();
            if (point >= mesh.num_points())
                refuse(element, fmt::format("triangle {} of its Draco data names vertex {}, there "
                                            "are {}",
                                            f, point, mesh.num_points()));
            std::memcpy(bytes.data() + (3 * size_t{f} + corner) * sizeof(point), &point,
                        sizeof(point));
        }
    }
    tinygltf::Accessor accessor;
    accessor.type = TINYGLTF_TYPE_SCALAR;
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    return add_accessor(model, storage, accessor, 3 * size_t{mesh.num_faces()}, std::move(bytes));
}

int add_attribute(tinygltf::Model& model, Storage& storage, const draco::Mesh& mesh, int id,
                  int like, const std::string& element) {
    const tinygltf::Accessor accessor = model.accessors[static_cast<size_t>(like)];
    const auto* attribute = mesh.GetAttributeByUniqueId(static_cast<uint32_t>(id));
    if (!attribute)
        refuse(element, fmt::format("its Draco data has no attribute {}", id));
    const int components = tinygltf::GetNumComponentsInType(static_cast<uint32_t>(accessor.type));
    if (components > 4 || attribute->num_components() != components)
        refuse(element, fmt::format("has {} components in its Draco data, {} in accessors[{}]",
                                    attribute->num_components(), components, like));
    if (mesh.num_points() > accessor.count)
        refuse(element, fmt::format("its Draco data has {} vertices, but accessors[{}] only {}",
                                    mesh.num_points(), like, accessor.count));
    const size_t size = element_layout(accessor.type, accessor.componentType).size();
    auto bytes = storage.allocate(mesh.num_points(), size, element);
    if (!convert(*attribute, mesh.num_points(), components, accessor.componentType, bytes.data()))
        refuse(element, "its Draco data does not fit its accessor's component type");
    return add_accessor(model, storage, accessor, mesh.num_points(), std::move(bytes));
}

Decoded decode(tinygltf::Model& model, Storage& storage, const Request& request,
               const std::string& element) {
    const auto& view = storage.views[static_cast<size_t>(request.view)];
    if (!view)
        refuse(element + ".bufferView",
               fmt::format("the buffer of bufferViews[{}] has no data", request.view));
    const DracoHeader header = read_draco_header(*view, element);
    check_header(header, request, model, element);
    const Loan working(storage.budget(), working_memory(header, request, model), 1, element);
    const auto mesh = decode_bytes(*view, element);

    Decoded decoded;
    decoded.indices = add_indices(model, storage, *mesh, element);
    for (const auto& [name, id, accessor] : request.attributes)
        decoded.attributes[name] =
            add_attribute(model, storage, *mesh, id, accessor, element + ".attributes." + name);
    return decoded;
}

} // namespace

void decode_draco(tinygltf::Model& model, Storage& storage) {
    std::map<Request, Decoded> known;
    for (size_t m = 0; m < model.meshes.size(); ++m)
        for (size_t p = 0; p < model.meshes[m].primitives.size(); ++p) {
            tinygltf::Primitive& primitive = model.meshes[m].primitives[p];
            if (!primitive.extensions.contains(kExtension))
                continue;
            const std::string element =
                fmt::format("meshes[{}].primitives[{}].extensions.{}", m, p, kExtension);
            const Request request = request_of(primitive, element);
            auto found = known.find(request);
            if (found == known.end())
                found = known.emplace(request, decode(model, storage, request, element)).first;
            primitive.indices = found->second.indices;
            for (const auto& [name, accessor] : found->second.attributes)
                primitive.attributes[name] = accessor;
            primitive.mode = TINYGLTF_MODE_TRIANGLES;
            primitive.extensions.erase(kExtension);
        }
}

} // namespace romascope::gltf
