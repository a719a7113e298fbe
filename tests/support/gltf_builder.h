// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/gltf_text.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace romascope {

/// Puts a .glb together: the JSON is open to any change, the numbers go into one buffer, which
/// comes before those in the JSON.
struct GltfBuilder {
    nlohmann::json root = {{"asset", {{"version", "2.0"}}}};
    std::string bytes;

    /// Adds a value to the array `root[key]` and gives its index.
    size_t add(const char* key, nlohmann::json value) {
        root[key].push_back(std::move(value));
        return root[key].size() - 1;
    }

    size_t add_view(const std::string& content) {
        bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
        const size_t offset = bytes.size();
        bytes += content;
        return add("bufferViews",
                   {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", content.size()}});
    }

    /// An accessor of `values`, `type` as glTF writes it ("SCALAR", "VEC3", ...).
    template <class T>
    size_t add_accessor(const std::vector<T>& values, const char* type, bool normalized = false) {
        const std::string name = type;
        const size_t components = name == "SCALAR" ? 1
                                  : name == "MAT4" ? 16
                                                   : static_cast<size_t>(name[3] - '0');
        const int component = std::is_same_v<T, float>      ? 5126
                              : std::is_same_v<T, uint32_t> ? 5125
                              : std::is_same_v<T, uint16_t> ? 5123
                              : std::is_same_v<T, int16_t>  ? 5122
                              : std::is_same_v<T, uint8_t>  ? 5121
                                                            : 5120;
        std::string content(values.size() * sizeof(T), '\0');
        std::memcpy(content.data(), values.data(), content.size());
        nlohmann::json accessor = {{"bufferView", add_view(content)},
                                   {"componentType", component},
                                   {"count", values.size() / components},
                                   {"type", type}};
        if (normalized)
            accessor["normalized"] = true;
        return add("accessors", std::move(accessor));
    }

    /// A mesh of one primitive with these attributes; no indices.
    size_t add_mesh(nlohmann::json attributes) {
        return add("meshes", {{"primitives", {{{"attributes", std::move(attributes)}}}}});
    }

    /// The .glb. Without scenes all nodes are drawn.
    std::string glb() const {
        nlohmann::json finished = root;
        std::string binary = bytes;
        binary.resize((binary.size() + 3) / 4 * 4, '\0');
        if (!binary.empty()) {
            auto& buffers = finished["buffers"];
            if (buffers.is_null())
                buffers = nlohmann::json::array();
            const nlohmann::json first = {{"byteLength", binary.size()}};
            buffers.insert(buffers.begin(), first);
        }
        return romascope::glb(finished.dump(), binary);
    }
};

} // namespace romascope
