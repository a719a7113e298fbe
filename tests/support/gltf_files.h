// SPDX-License-Identifier: MIT
// glTF files made in memory, for tests of what of them becomes a scene.
#pragma once

#include "renderer/base/error.h"
#include "renderer/scene/gltf/import.h"
#include "tests/support/expect_error.h"
#include "tests/support/gltf_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace romascope {

using nlohmann::json;

inline Scene load(const GltfBuilder& file, size_t max_memory = size_t{1} << 28) {
    return import_gltf(file.glb(), "asset.glb", max_memory);
}

inline std::string refusal(const GltfBuilder& file, size_t max_memory = size_t{1} << 28) {
    try {
        load(file, max_memory);
    } catch (const Error& error) {
        EXPECT_EQ(error.exit_status(), kBadInput);
        return error.what();
    }
    return "was taken";
}

inline const std::vector<float> kTriangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};
inline const std::vector<float> kUp = {0, 0, 1, 0, 0, 1, 0, 0, 1};

/// One triangle in z = 0 with normals, as mesh 0 of node 0.
struct TriangleFile : GltfBuilder {
    TriangleFile() {
        add_mesh(
            {{"POSITION", add_accessor(kTriangle, "VEC3")}, {"NORMAL", add_accessor(kUp, "VEC3")}});
        add("nodes", {{"mesh", 0}});
    }
    json& primitive() { return root["meshes"][0]["primitives"][0]; }
    json& node() { return root["nodes"][0]; }
    void animate(size_t node, const char* path, const std::vector<float>& times,
                 const std::vector<float>& values, const char* type,
                 const char* interpolation = "LINEAR") {
        json sampler = {{"input", add_accessor(times, "SCALAR")},
                        {"output", add_accessor(values, type)},
                        {"interpolation", interpolation}};
        json channel = {{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}};
        if (!root.contains("animations"))
            root["animations"] = {{{"samplers", json::array()}, {"channels", json::array()}}};
        json& animation = root["animations"][0];
        channel["sampler"] = animation["samplers"].size();
        animation["samplers"].push_back(sampler);
        animation["channels"].push_back(channel);
    }
};

inline bool near(glm::vec3 a, glm::vec3 b, float tolerance = 1e-6f) {
    return glm::distance(a, b) <= tolerance;
}

inline bool has_notice(const Scene& scene, const std::string& part) {
    return std::ranges::any_of(scene.notices, [&](const std::string& line) {
        return line.find(part) != std::string::npos;
    });
}

} // namespace romascope
