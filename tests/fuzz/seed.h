// SPDX-License-Identifier: MIT
#pragma once

#include "tests/fuzz/gltf_parts.h"

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace romascope::fuzz {

using nlohmann::json;

/// Component types of accessors.
enum : int { kS8 = 5120, kU8 = 5121, kS16 = 5122, kU16 = 5123, kU32 = 5125, kF32 = 5126 };

/// A small glTF file in the making: a scene of one node with one mesh of one primitive, which has
/// what was added to it.
class Seed {
public:
    Seed();

    /// Bytes of numbers as they lie in a buffer.
    template <class T>
    static std::string bytes(const std::vector<T>& numbers) {
        return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T)};
    }

    /// Index of a new view of these bytes; `stride` 0: none is written.
    int view(std::string_view content, int stride = 0);
    /// Index of a new accessor.
    int accessor(int view, int component, const char* type, size_t count, bool normalized = false);
    /// The two together, from numbers without padding.
    template <class T>
    int numbers(const std::vector<T>& values, int component, const char* type, size_t per_element,
                bool normalized = false) {
        return accessor(view(bytes(values)), component, type, values.size() / per_element,
                        normalized);
    }

    /// Four corners of a square in the plane z = 0 as POSITION, and its two triangles.
    Seed& square();
    Seed& attribute(const char* name, int accessor);

    json& primitive() { return root["meshes"][0]["primitives"][0]; }
    json& node() { return root["nodes"][0]; }
    json& material();
    /// Declares an extension; its object at the top.
    json& use(const char* extension, bool required = true);
    /// An animation of node 0 with one channel.
    Seed& animate(const char* path, const char* interpolation, const std::vector<float>& times,
                  const std::vector<float>& values, const char* type, size_t per_element);

    /// Writes the file and says what is wrong, if anything is.
    void write(const std::filesystem::path& folder, const char* name, bool glb) const;

    json root;
    std::string bin;
};

} // namespace romascope::fuzz
