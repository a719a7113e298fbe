// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace romascope {

/// A .glb put together from JSON and bytes.
inline std::string glb(std::string json, std::string bytes) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
    std::string file;
    const auto word = [&](size_t value) {
        const auto narrow = static_cast<uint32_t>(value);
        file.append(reinterpret_cast<const char*>(&narrow), sizeof(narrow));
    };
    file += "glTF";
    word(2);
    word(12 + 8 + json.size() + (bytes.empty() ? 0 : 8 + bytes.size()));
    word(json.size());
    file += "JSON" + json;
    if (!bytes.empty()) {
        word(bytes.size());
        file += std::string("BIN\0", 4) + bytes;
    }
    return file;
}

template <class T>
std::string bytes_of(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// Replaces the one place where `from` stands.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    EXPECT_EQ(text.find(from, at + 1), std::string::npos) << from << " is not unique";
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// Two triangles in the plane z = 0 that make the unit square, seen from +z; with normals, u16
/// indices, a material, a camera.
inline const std::string kSquare = R"({
"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
"nodes": [{"name": "square", "mesh": 0},
          {"name": "eye", "camera": 0, "translation": [0.5, 0.5, 3]}],
"cameras": [{"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2,
                            "material": 0}]}],
"materials": [{"name": "clay", "emissiveFactor": [0, 0.25, 1],
               "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 1, 1]}}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
              {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3"},
              {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}],
"bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48},
                {"buffer": 0, "byteOffset": 48, "byteLength": 48},
                {"buffer": 0, "byteOffset": 96, "byteLength": 12}],
"buffers": [{"byteLength": 108}]})";

inline const std::vector<float> kCorners = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
inline const std::vector<float> kNormals = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};

inline std::string square_bytes(const std::vector<float>& corners = kCorners,
                                const std::vector<float>& normals = kNormals,
                                const std::vector<uint16_t>& indices = {0, 1, 2, 0, 2, 3}) {
    return bytes_of(corners) + bytes_of(normals) + bytes_of(indices);
}

} // namespace romascope
