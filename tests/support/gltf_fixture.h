// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/scene/gltf/import.h"
#include "renderer/scene/scene.h"
#include "tests/support/expect_error.h"
#include "tests/support/gltf_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace romascope {

namespace fs = std::filesystem;

class Gltf : public testing::Test {
protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() /
                  (std::string("romascope_") + info->name() + std::to_string(getpid()));
        fs::create_directories(folder_ / "asset");
    }
    void TearDown() override { fs::remove_all(folder_); }

    Scene load(const std::string& content, const std::string& name = "thing.glb") const {
        write_file_atomically(folder_ / "asset" / name, content);
        return load_gltf(folder_ / "asset" / name);
    }
    Scene load_square(const std::string& from, const std::string& to) const {
        return load(glb(replaced(kSquare, from, to), square_bytes()));
    }
    /// The message without the file's name, which must come first.
    std::string refusal(const std::string& content, const std::string& name = "thing.glb") const {
        const std::string text = error_of([&] { load(content, name); });
        const std::string start = (folder_ / "asset" / name).string() + ": ";
        EXPECT_EQ(text.rfind(start, 0), 0u) << text;
        return text.substr(std::min(text.size(), start.size()));
    }
    fs::path folder_;
};

inline glm::vec3 face_normal(const Scene& scene, size_t triangle) {
    const auto at = [&](size_t i) { return scene.positions[scene.indices[3 * triangle + i]]; };
    return glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0)));
}

/// What holds for every scene that is let in.
inline void expect_sound(const Scene& scene) {
    EXPECT_FALSE(scene.indices.empty());
    EXPECT_EQ(scene.indices.size() % 3, 0u);
    EXPECT_EQ(scene.normals.size(), scene.positions.size());
    EXPECT_EQ(scene.vertex_material.size(), scene.positions.size());
    EXPECT_FALSE(scene.materials.empty());
    EXPECT_FALSE(scene.cameras.empty());
    for (const uint32_t index : scene.indices)
        ASSERT_LT(index, scene.positions.size());
    for (const uint32_t material : scene.vertex_material)
        ASSERT_LT(material, scene.materials.size());
    for (const glm::vec3& normal : scene.normals) {
        const float length = glm::length(normal);
        ASSERT_TRUE(length == 0.0f || std::abs(length - 1.0f) < 1e-5f)
            << length; // 0: its triangle's
    }
    for (const glm::vec3& position : scene.positions)
        ASSERT_LT(glm::length(position), 2e9f); // also false for NaN
    EXPECT_FALSE(scene.bounds.empty());
}

} // namespace romascope
