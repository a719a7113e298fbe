// SPDX-License-Identifier: MIT
// The change volume against distances from points of its blocks to what moved.
#include "renderer/reuse/changes/change_volume.h"
#include "tests/gl/gl_test.h"
#include "tests/support/moving_scene.h"

#include <algorithm>
#include <cmath>

namespace romascope {
namespace {

class ChangeVolumeTest : public GlTest {
protected:
    static constexpr ChangeVolume::Reaches kReaches{1.0f, 1.3f, 1.9f, 3.0f};

    /// Scattered triangles, of which those from the tenth on may move.
    static Scene triangles(std::mt19937& random, int count, float size) {
        std::vector<glm::vec3> corners;
        std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
        const auto point = [&] { return glm::vec3(unit(random), unit(random), unit(random)); };
        for (int i = 0; i < count; ++i) {
            const glm::vec3 centre = glm::vec3(5.0f, 2.0f, 4.0f) * point();
            for (int corner = 0; corner < 3; ++corner)
                corners.push_back(centre + size * point());
        }
        return scene_of_triangles(corners);
    }

    static void move(GpuScene& gpu, Scene& scene) {
        glNamedBufferSubData(gpu.positions().id(), 0,
                             static_cast<GLsizeiptr>(scene.positions.size() * sizeof(glm::vec3)),
                             scene.positions.data());
        scene.bounds = {};
        for (const glm::vec3 position : scene.positions)
            scene.bounds.add(position);
        gpu.set_bounds(scene.bounds);
    }

    static float distance_to_triangle(glm::vec3 p, const glm::vec3* t) {
        // The nearest of a fine net of its points: within a hundredth of its size.
        constexpr int kSteps = 60;
        float nearest = std::numeric_limits<float>::infinity();
        for (int u = 0; u <= kSteps; ++u)
            for (int v = 0; u + v <= kSteps; ++v)
                nearest = std::min(nearest, glm::distance(p, t[0] + (float(u) * (t[1] - t[0]) +
                                                                     float(v) * (t[2] - t[0])) /
                                                                        float(kSteps)));
        return nearest;
    }

    Settings settings_{all_knobs()};
};

TEST_F(ChangeVolumeTest, TellsBlocksWithinReachOfWhatMoved) {
    std::mt19937 random(5);
    for (const float size : {0.1f, 1.0f}) {
        Scene scene = triangles(random, 12, size);
        GpuScene gpu(scene);
        ChangeVolume volume;
        volume.begin(frame(gpu, settings_, 0, 7), 0, kReaches[0]);
        const Scene before = scene;
        // One triangle moves into the middle, the corner of another by less than the tolerance.
        const glm::vec3 way = -0.9f * scene.positions[0];
        ASSERT_GT(glm::length(way), 1.0f);
        for (size_t corner = 0; corner < 3; ++corner)
            scene.positions[corner] += way;
        scene.positions[9] += glm::vec3(0.001f);
        move(gpu, scene);
        ASSERT_TRUE(volume.covers(scene.bounds));
        volume.update(frame(gpu, settings_, 0, 9), kReaches, 0.01f);

        const gpu::ChangeGrid& grid = volume.grid();
        const float block = 1.0f / grid.blocks_per_metre;
        // Shorter than the distance by up to the diagonals of two blocks, never longer. The
        // distance to the triangle itself is measured to a net of its points, which is no shorter.
        const float error = 2.0f * 1.7321f * block + 0.03f * size;
        const std::vector<uint32_t> frames = volume.download();
        const auto blocks = static_cast<uint32_t>(grid.size.x * grid.size.y * grid.size.z);
        ASSERT_EQ(frames.size(), blocks * kReaches.size());
        std::uniform_int_distribution<uint32_t> any(0, blocks - 1);
        std::uniform_real_distribution<float> inside(0.001f, 0.999f);
        const auto share = [&] { return random() % 2 == 0 ? 0.001f : 0.999f; };
        size_t within = 0, barely = 0, beyond = 0;
        for (int i = 0; i < 3000; ++i) {
            const uint32_t index = any(random);
            // Corners of blocks, where distances between centres would be wrong most, and others.
            const glm::vec3 place = i % 4 == 0
                                        ? glm::vec3(inside(random), inside(random), inside(random))
                                        : glm::vec3(share(), share(), share());
            const glm::vec3 point =
                grid.origin + (glm::vec3(gpu::block_at(index, grid.size)) + place) * block;
            const float distance = std::min(distance_to_triangle(point, &before.positions[0]),
                                            distance_to_triangle(point, &scene.positions[0]));
            for (size_t reach = 0; reach < kReaches.size(); ++reach) {
                const uint32_t found = frames[reach * blocks + index];
                ASSERT_TRUE(found == 7 || found == 9);
                if (distance <= kReaches[reach]) {
                    ASSERT_EQ(found, 9u) << distance;
                    ++within;
                    barely += distance > kReaches[reach] - block;
                } else if (distance > kReaches[reach] + error) {
                    ASSERT_EQ(found, 7u) << distance;
                    ++beyond;
                }
            }
        }
        EXPECT_GT(within, 100u);
        EXPECT_GT(barely, 30u);
        EXPECT_GT(beyond, 3000u);
    }
}

TEST_F(ChangeVolumeTest, WhatStandsStillChangesNothing) {
    std::mt19937 random(6);
    Scene scene = triangles(random, 12, 0.5f);
    GpuScene gpu(scene);
    ChangeVolume volume;
    volume.begin(frame(gpu, settings_, 0, 0xFFFFFFFFu), 9, kReaches[0]);
    const auto changed = [&](uint32_t number) {
        volume.update(frame(gpu, settings_, 0, number), kReaches, 0.01f);
        return std::ranges::count(volume.download(), number);
    };
    EXPECT_EQ(changed(0), 0);
    scene.positions[8] += glm::vec3(0.2f); // not among those that move
    move(gpu, scene);
    EXPECT_EQ(changed(1), 0);
    scene.positions[9] += glm::vec3(0.2f);
    move(gpu, scene);
    EXPECT_GT(changed(2), 0);
    EXPECT_EQ(changed(3), 0) << "it stands there since";
    EXPECT_GT(std::ranges::count(volume.download(), 2u), 0);
    // A little at a time counts where it adds up to the tolerance.
    int times = 0;
    for (uint32_t number = 4; number < 12; ++number) {
        scene.positions[9] += glm::vec3(0.0f, 0.003f, 0.0f);
        move(gpu, scene);
        times += changed(number) > 0;
    }
    EXPECT_EQ(times, 2);
}

TEST_F(ChangeVolumeTest, TrianglesTooLargeToMarkChangeAll) {
    // Two sheets over half of a flat scene.
    std::vector<glm::vec3> corners;
    for (const float height : {0.0f, 0.05f})
        for (const glm::vec3 corner :
             {glm::vec3(-40, height, -40), glm::vec3(40, height, -40), glm::vec3(-40, height, 40)})
            corners.push_back(corner);
    Scene scene = scene_of_triangles(corners);
    GpuScene gpu(scene);
    ChangeVolume volume;
    volume.begin(frame(gpu, settings_, 0, 1), 0, 0.5f);
    for (size_t i = 0; i < 3; ++i)
        scene.positions[i].y += 0.02f;
    move(gpu, scene);
    volume.update(frame(gpu, settings_, 0, 2), {0.5f, 0.6f, 0.7f, 0.8f}, 0.01f);
    const gpu::ChangeGrid& grid = volume.grid();
    const std::vector<uint32_t> frames = volume.download();
    // All it touches is marked, be it by marking all.
    ASSERT_GT(std::min(grid.size.x, grid.size.z), 200) << "enough blocks to be large";
    for (int i = 1; i < 100; ++i) {
        const glm::vec3 point(-40.0f + 79.0f * static_cast<float>(i) / 100.0f, 0.0f, -40.0f);
        ASSERT_EQ(frames[gpu::block_index(gpu::block_of(point, grid), grid.size)], 2u);
    }
}

} // namespace
} // namespace romascope
