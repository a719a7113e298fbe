// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/meshopt.h"

#include "renderer/scene/gltf/message.h"

#include <fmt/format.h>
#include <meshoptimizer.h>
#include <tiny_gltf.h>

namespace romascope::gltf {
namespace {

constexpr const char* kExtension = "EXT_meshopt_compression";

/// The extension's properties, which the schema has checked one by one.
struct Compressed {
    size_t buffer, offset, length, stride, count;
    std::string mode, filter;
};

Compressed properties(const tinygltf::Value& value) {
    const auto number = [&](const char* name) -> size_t {
        return value.Has(name) ? static_cast<size_t>(value.Get(name).GetNumberAsDouble()) : 0;
    };
    return {number("buffer"),
            number("byteOffset"),
            number("byteLength"),
            number("byteStride"),
            number("count"),
            value.Get("mode").Get<std::string>(),
            value.Has("filter") ? value.Get("filter").Get<std::string>() : "NONE"};
}

/// What the extension asks for, and what the library asserts.
void check_shape(const Compressed& from, const tinygltf::BufferView& view,
                 const std::string& element) {
    const auto stride = [&](bool good) {
        if (!good)
            refuse(element + ".byteStride", fmt::format("{} does not go with mode {}, filter {}",
                                                        from.stride, from.mode, from.filter));
    };
    if (from.mode == "ATTRIBUTES") {
        stride(from.stride % 4 == 0);
        if (from.filter == "OCTAHEDRAL")
            stride(from.stride == 4 || from.stride == 8);
        if (from.filter == "QUATERNION")
            stride(from.stride == 8);
    } else {
        stride(from.stride == 2 || from.stride == 4);
        if (from.filter != "NONE")
            refuse(element + ".filter",
                   fmt::format("{} does not go with mode {}", from.filter, from.mode));
        if (from.mode == "TRIANGLES" && from.count % 3 != 0)
            refuse(element + ".count", fmt::format("{} indices do not make triangles", from.count));
    }
    if (view.byteStride != 0 && view.byteStride != from.stride)
        refuse(element + ".byteStride",
               fmt::format("{}, but the view's is {}", from.stride, view.byteStride));
    if (from.count * from.stride != view.byteLength)
        refuse(element, fmt::format("{} elements of {} bytes are not the view's {} bytes",
                                    from.count, from.stride, view.byteLength));
}

int decode(const Compressed& from, std::span<const std::byte> source, std::byte* out) {
    const auto* data = reinterpret_cast<const unsigned char*>(source.data());
    if (from.mode == "TRIANGLES")
        return meshopt_decodeIndexBuffer(out, from.count, from.stride, data, source.size());
    if (from.mode == "INDICES")
        return meshopt_decodeIndexSequence(out, from.count, from.stride, data, source.size());
    const int error = meshopt_decodeVertexBuffer(out, from.count, from.stride, data, source.size());
    if (error != 0)
        return error;
    if (from.filter == "OCTAHEDRAL")
        meshopt_decodeFilterOct(out, from.count, from.stride);
    else if (from.filter == "QUATERNION")
        meshopt_decodeFilterQuat(out, from.count, from.stride);
    else if (from.filter == "EXPONENTIAL")
        meshopt_decodeFilterExp(out, from.count, from.stride);
    return 0;
}

} // namespace

int source_buffer(const tinygltf::Model& model, size_t index) {
    const tinygltf::BufferView& view = model.bufferViews[index];
    const auto found = view.extensions.find(kExtension);
    return found == view.extensions.end() ? view.buffer
                                          : static_cast<int>(properties(found->second).buffer);
}

void decode_meshopt(tinygltf::Model& model,
                    const std::vector<std::optional<std::span<const std::byte>>>& buffers,
                    Storage& storage) {
    for (size_t i = 0; i < model.bufferViews.size(); ++i) {
        tinygltf::BufferView& view = model.bufferViews[i];
        const auto found = view.extensions.find(kExtension);
        if (found == view.extensions.end())
            continue;
        const std::string element = fmt::format("bufferViews[{}].extensions.{}", i, kExtension);
        const Compressed from = properties(found->second);
        check_shape(from, view, element);
        const auto& buffer = buffers[from.buffer];
        if (!buffer)
            refuse(element + ".buffer", fmt::format("buffers[{}] has no data", from.buffer));
        if (from.offset > buffer->size() || from.length > buffer->size() - from.offset)
            refuse(element, fmt::format("{} bytes from byte {} reach beyond buffers[{}] of {} "
                                        "bytes",
                                        from.length, from.offset, from.buffer, buffer->size()));
        auto bytes = storage.allocate(from.count, from.stride, element);
        if (decode(from, buffer->subspan(from.offset, from.length), bytes.data()) != 0)
            refuse(element, "its data is broken");
        storage.views[i] = storage.keep(std::move(bytes));
        view.extensions.erase(kExtension);
    }
}

} // namespace romascope::gltf
