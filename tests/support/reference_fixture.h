// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/reference/ao_reference.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>
#include <unistd.h>
#include <vector>

namespace romascope {

namespace fs = std::filesystem;
inline constexpr float kInfinite = std::numeric_limits<float>::infinity();
inline const glm::vec3 kUp(0.0f, 1.0f, 0.0f);

/// Of a material that is seen from both sides.
inline void add_triangle(Scene& scene, const std::array<glm::vec3, 3>& corners,
                         const std::array<glm::vec3, 3>& normals) {
    if (scene.materials.empty())
        scene.materials.push_back({.double_sided = true});
    for (size_t i = 0; i < 3; ++i) {
        scene.indices.push_back(static_cast<uint32_t>(scene.positions.size()));
        scene.positions.push_back(corners[i]);
        scene.normals.push_back(normals[i]);
        scene.vertex_material.push_back(0);
        scene.bounds.add(corners[i]);
    }
}

/// A parallelogram of 2 k² triangles.
inline void add_quad(Scene& scene, glm::vec3 corner, glm::vec3 u, glm::vec3 v, int k = 1) {
    const glm::vec3 normal = glm::normalize(glm::cross(u, v));
    const auto at = [&](int i, int j) {
        return corner + u * (static_cast<float>(i) / static_cast<float>(k)) +
               v * (static_cast<float>(j) / static_cast<float>(k));
    };
    for (int j = 0; j < k; ++j)
        for (int i = 0; i < k; ++i) {
            add_triangle(scene, {at(i, j), at(i + 1, j), at(i + 1, j + 1)},
                         {normal, normal, normal});
            add_triangle(scene, {at(i, j), at(i + 1, j + 1), at(i, j + 1)},
                         {normal, normal, normal});
        }
}

/// A square floor at y = 0, and a camera's worth of room around it.
inline Scene floor_scene(float half) {
    Scene scene;
    add_quad(scene, {-half, 0.0f, half}, {2.0f * half, 0.0f, 0.0f}, {0.0f, 0.0f, -2.0f * half});
    return scene;
}

/// A disc of `sides` sides, parallel to the floor; 4096 sides miss the circle's area by 4e-7.
inline void add_disc(Scene& scene, glm::vec3 centre, float radius, int sides = 4096) {
    const auto rim = [&](int i) {
        const double angle = 2.0 * glm::pi<double>() * i / sides;
        return centre + radius * glm::vec3(std::cos(angle), 0.0, std::sin(angle));
    };
    for (int i = 0; i < sides; ++i)
        add_triangle(scene, {centre, rim(i), rim(i + 1)}, {kUp, kUp, kUp});
}

inline double tolerance(double p, double rays) {
    return 5.0 * std::sqrt(p * (1.0 - p) / rays) + 1e-4;
}

/// Its own cache folder for each test, so that they may run side by side and in any order.
class Reference : public testing::Test {
protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() /
                  (std::string("romascope_") + info->name() + std::to_string(getpid()));
        fs::create_directories(folder_);
        setenv("XDG_CACHE_HOME", folder_.c_str(), 1);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::vector<fs::path> cache_files() const {
        std::vector<fs::path> files;
        if (fs::exists(folder_ / "romascope" / "reference"))
            for (const auto& entry : fs::directory_iterator(folder_ / "romascope" / "reference"))
                files.push_back(entry.path());
        return files;
    }
    fs::path folder_;
};

/// A floor with a disc above it, looked at from between the two, horizon in the picture.
struct DiscView {
    Scene scene = floor_scene(20.0f);
    AoQuery query;

    DiscView() {
        add_disc(scene, {0.0f, 2.0f, 0.0f}, 1.0f);
        query.camera = look_at("view", {0.0f, 1.5f, 4.0f}, {0.0f, 0.3f, 0.0f}, 1.0f);
        query.size = {37, 23};
        query.samples = 16;
    }
};

/// Part of the sky that a disc of radius r at height h hides from a floor point at distance d from
/// below its centre (view factor from a small element to a parallel disc).
inline double disc_share(double r, double h, double d) {
    const double all = d * d + h * h + r * r;
    return 0.5 * (1.0 - (all - 2.0 * r * r) / std::sqrt(all * all - 4.0 * d * d * r * r));
}

} // namespace romascope
