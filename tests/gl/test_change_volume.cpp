// SPDX-License-Identifier: MIT
// The change volume against distances from points of its blocks to what moved.
#include "renderer/reuse/changes/change_volume.h"
#include "tests/gl/gl_test.h"
#include "tests/support/moving_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace romascope {
namespace {

class ChangeVolumeTest : public GlTest {
protected:
    static constexpr ChangeVolume::Reaches kReaches{1.0f, 1.3f, 1.9f};

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

    /// What `expression` is for each point p.
    std::vector<uint32_t> ask(const ChangeVolume& volume, const std::vector<glm::vec4>& points,
                              const std::string& expression) {
        shaders_.add("ask.comp.glsl", fmt::format(R"(
#include "shaders/reuse/changes/changed.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Points {{ vec4 points[]; }};
layout(std430, binding = 1) writeonly buffer Answers {{ uint answers[]; }};
void main() {{
    uint id = gl_GlobalInvocationID.x;
    if (id >= uint(points.length()))
        return;
    vec4 p = points[id];
    answers[id] = {};
}}
)",
                                                  expression));
        const Program program(shaders_, {"ask", {{GL_COMPUTE_SHADER, "ask.comp.glsl"}}, {}, {}});
        const Buffer in = Buffer::from("points", std::span(points));
        const Buffer out("answers", points.size() * sizeof(uint32_t));
        program.use();
        volume.bind(program);
        in.bind(GL_SHADER_STORAGE_BUFFER, 0);
        out.bind(GL_SHADER_STORAGE_BUFFER, 1);
        program.dispatch_covering({static_cast<int>(points.size()), 1, 1});
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        return out.download<uint32_t>();
    }

    /// How many blocks have their centre within the longest reach of what moved last.
    static std::ptrdiff_t near_blocks(const ChangeVolume& volume) {
        const std::vector<uint32_t> changes = volume.download();
        const auto blocks = static_cast<std::ptrdiff_t>(changes.size() / (1 + gpu::kReaches));
        const float reach = kReaches.back() * volume.grid().blocks_per_metre * gpu::kMarks;
        return std::count_if(changes.begin(), changes.begin() + blocks, [&](uint32_t squared) {
            return static_cast<float>(squared) < reach * reach;
        });
    }

    Settings settings_{all_knobs()};
};

TEST_F(ChangeVolumeTest, TellsPointsWithinReachOfWhatMoved) {
    std::mt19937 random(5);
    for (const float size : {0.1f, 1.0f}) {
        Scene scene = triangles(random, 12, size);
        GpuScene gpu(scene);
        ChangeVolume volume;
        volume.begin(frame(gpu, settings_, 0, 7), 0, kReaches[0]);
        // One triangle moves into the middle, the corner of another by less than the tolerance.
        const Scene before = scene;
        const glm::vec3 way = -0.9f * scene.positions[0];
        ASSERT_GT(glm::length(way), 1.0f);
        for (size_t corner = 0; corner < 3; ++corner)
            scene.positions[corner] += way;
        scene.positions[9] += glm::vec3(0.001f);
        move(gpu, scene);
        ASSERT_TRUE(volume.covers(scene.bounds));
        volume.update(frame(gpu, settings_, 0, 9), kReaches, 0.01f);
        const auto distance_to_moved = [&](glm::vec3 point) {
            return std::min(distance_to_triangle(point, &before.positions[0]),
                            distance_to_triangle(point, &scene.positions[0]));
        };

        const gpu::ChangeGrid& grid = volume.grid();
        const float block = 1.0f / grid.blocks_per_metre, box = block / gpu::kMarks;
        std::uniform_real_distribution<float> share(0.0f, 1.0f);
        std::vector<glm::vec4> points; // w: a reach, of half of them about the distance
        for (int i = 0; i < 3000; ++i) {
            const glm::vec3 point =
                grid.origin +
                block * (1.0f + glm::vec3(grid.size - 2) *
                                    glm::vec3(share(random), share(random), share(random)));
            points.emplace_back(point, kReaches.back() * share(random));
            const float distance = distance_to_moved(point);
            if (i % 2 == 0 && distance < kReaches.back())
                points.back().w = distance + block * (2.0f * share(random) - 1.5f);
        }
        // Shorter than the distance by up to the diagonal of a box, and by what the blocks around
        // leave open; never longer. The distance to the triangle itself is measured to a net of its
        // points, which is no shorter. Blocks at the border lack some of those around them.
        const float around = 0.4f * block, net = 0.03f * size;
        const float error = 1.7321f * box + around + net;
        std::vector<uint32_t> answers =
            ask(volume, points, "moved_last_within(p.xyz, p.w) ? 1u : 0u");
        size_t within = 0, barely = 0, beyond = 0, barely_beyond = 0;
        for (size_t i = 0; i < points.size(); ++i) {
            const float distance = distance_to_moved(points[i]);
            if (distance <= points[i].w) {
                ASSERT_EQ(answers[i], 1u) << distance << " " << points[i].w;
                ++within;
                barely += distance > points[i].w - box;
            } else if (distance > points[i].w + error) {
                ASSERT_EQ(answers[i], 0u) << distance << " " << points[i].w;
                ++beyond;
                barely_beyond += distance < points[i].w + error + box;
            }
        }
        EXPECT_GT(within, 100u);
        EXPECT_GT(barely, 20u);
        EXPECT_GT(beyond, 1000u);
        EXPECT_GT(barely_beyond, 20u);

        // Another moves: of the change before it, each block knows the frame.
        scene.positions[15] += glm::vec3(0.2f);
        move(gpu, scene);
        volume.update(frame(gpu, settings_, 0, 11), kReaches, 0.01f);
        for (size_t reach = 0; reach < kReaches.size(); ++reach) {
            const std::string last_used_in =
                fmt::format("(moved_before(p.xyz, {0}, 12u, 6u) ? 4u : 0u) | (moved_before(p.xyz, "
                            "{0}, 12u, 4u) ? 2u "
                            ": 0u) | (moved_before(p.xyz, {0}, 12u, 3u) ? 1u : 0u)",
                            reach);
            answers = ask(volume, points, last_used_in);
            within = beyond = 0;
            for (size_t i = 0; i < points.size(); ++i) {
                const float distance = distance_to_moved(points[i]);
                ASSERT_EQ(answers[i] & 1u, 0u) << "used in the frame of the change";
                ASSERT_EQ(answers[i] & 4u, 4u) << "used before all began";
                if (distance <= kReaches[reach]) {
                    ASSERT_EQ(answers[i] & 2u, 2u) << distance;
                    ++within;
                } else if (distance > kReaches[reach] + 1.7321f * (box + block) + net) {
                    ASSERT_EQ(answers[i] & 2u, 0u) << distance;
                    ++beyond;
                }
            }
            EXPECT_GT(within, 50u);
            EXPECT_GT(beyond, 1000u);
        }
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
        return near_blocks(volume);
    };
    EXPECT_EQ(changed(0), 0);
    scene.positions[8] += glm::vec3(0.2f); // not among those that move
    move(gpu, scene);
    EXPECT_EQ(changed(1), 0);
    scene.positions[9] += glm::vec3(0.2f);
    move(gpu, scene);
    EXPECT_GT(changed(2), 0);
    EXPECT_EQ(changed(3), 0) << "it stands there since";
    EXPECT_GT(std::ranges::count(volume.download(), 2u), 0) << "but moved then";
    // A little at a time counts where it adds up to the tolerance.
    int times = 0;
    for (uint32_t number = 4; number < 24; ++number) {
        scene.positions[9] += glm::vec3(0.0f, 0.003f, 0.0f);
        move(gpu, scene);
        times += changed(number) > 0;
    }
    EXPECT_EQ(times, 5);
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
    volume.update(frame(gpu, settings_, 0, 2), {0.5f, 0.6f, 0.7f}, 0.01f);
    // All it touches is marked, be it by marking all.
    const glm::ivec3 size = gpu::kMarks * volume.grid().size;
    ASSERT_GT(std::min(size.x, size.z), 200) << "enough boxes to be large";
    std::vector<glm::vec4> points;
    for (int i = 1; i < 100; ++i)
        points.emplace_back(-40.0f + 79.0f * static_cast<float>(i) / 100.0f, 0.0f, -40.0f, 0.1f);
    for (const uint32_t answer : ask(volume, points, "moved_last_within(p.xyz, p.w) ? 1u : 0u"))
        ASSERT_EQ(answer, 1u);
}

} // namespace
} // namespace romascope
