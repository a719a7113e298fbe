// SPDX-License-Identifier: MIT
// Blocks of the change volume without a GPU: where points lie, what counts as a move, what is older
// than a change.
#include "renderer/reuse/changes/change_volume.h"
#include "shaders/reuse/spatial_hash/cell_state.h"
#include "shaders/reuse/spatial_hash/stale_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace romascope {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Bounds random_bounds(std::mt19937& random) {
    std::uniform_real_distribution<float> exponent(-6.0f, 12.0f), unit(-1.0f, 1.0f);
    const glm::vec3 centre =
        std::exp2(exponent(random)) * glm::vec3(unit(random), unit(random), unit(random));
    const glm::vec3 half(std::exp2(exponent(random)), std::exp2(exponent(random)),
                         std::exp2(exponent(random)));
    return {centre - half, centre + half};
}

TEST(ChangeGrid, HoldsTheBoundsInFewBlocks) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> exponent(-8.0f, 8.0f), share(0.0f, 1.0f);
    for (int i = 0; i < 2000; ++i) {
        const Bounds bounds = random_bounds(random);
        const float reach = std::exp2(exponent(random));
        const gpu::ChangeGrid grid = change_grid(bounds, reach);
        ASSERT_LE(std::max({grid.size.x, grid.size.y, grid.size.z}), 64);
        ASSERT_LE(double(grid.size.x) * grid.size.y * grid.size.z, 1 << 16);
        const float block = 1.0f / grid.blocks_per_metre;
        ASSERT_GE(block, reach / 8.1f);
        ASSERT_LE(block, std::max(reach / 7.9f, glm::length(bounds.extent())));
        // No point of the bounds has to be brought back from beyond the last block.
        const glm::vec3 last = (bounds.max - grid.origin) * grid.blocks_per_metre;
        ASSERT_TRUE(glm::all(glm::lessThan(last, glm::vec3(grid.size))));
        for (int j = 0; j < 20; ++j) {
            const glm::vec3 point =
                bounds.min +
                bounds.extent() * glm::vec3(share(random), share(random), share(random));
            const glm::ivec3 found = gpu::block_of(point, grid);
            const glm::vec3 from = grid.origin + glm::vec3(found) * block;
            const glm::vec3 slack(1e-4f * block + 1e-5f * glm::length(bounds.min));
            ASSERT_TRUE(glm::all(glm::greaterThanEqual(point, from - slack)));
            ASSERT_TRUE(glm::all(glm::lessThanEqual(point, from + block + slack)));
            ASSERT_EQ(gpu::block_at(gpu::block_index(found, grid.size), grid.size), found);
        }
    }
}

TEST(ChangeGrid, BoxesAreAsFarAsTheirNearestFace) {
    for (int further = -5; further <= 5; ++further) {
        int nearest = 1 << 20;
        for (int box = 0; box < gpu::kMarks; ++box) {
            // From the centre of block 0, at kMarks / 2, to the ends of the box.
            const int first = gpu::kMarks * further + box - gpu::kMarks / 2;
            const int distance = std::max({first, -(first + 1), 0});
            EXPECT_EQ(gpu::square_to_box(further, box), distance * distance);
            nearest = std::min(nearest, distance * distance);
        }
        EXPECT_EQ(gpu::square_to_block(std::abs(further)), nearest);
    }
}

TEST(ChangeGrid, AnyPointHasABlock) {
    const gpu::ChangeGrid grid = change_grid({glm::vec3(-1.0f), glm::vec3(2.0f)}, 1.0f);
    for (const float odd : {kNan, kInfinity, -kInfinity, 3e38f, -3e38f}) {
        const glm::ivec3 found = gpu::block_of({odd, 0.0f, odd}, grid);
        EXPECT_TRUE(glm::all(glm::greaterThanEqual(found, glm::ivec3(0))) &&
                    glm::all(glm::lessThan(found, grid.size)))
            << odd;
    }
    EXPECT_EQ(gpu::block_of(glm::vec3(kInfinity), grid), grid.size - 1);
    EXPECT_EQ(gpu::block_of(glm::vec3(-9.0f), grid), glm::ivec3(0));
}

TEST(Moves, CountFromTheToleranceOn) {
    const glm::vec3 from(1.0f, -2.0f, 3.0f);
    EXPECT_FALSE(gpu::has_moved(from, from, 0.0f));
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 way(0.0f);
            way[axis] = side * 0.25f;
            EXPECT_FALSE(gpu::has_moved(from, from + way, 0.25f));
            EXPECT_TRUE(gpu::has_moved(from, from + 1.5f * way, 0.25f));
        }
    }
}

TEST(StaleCells, AreThoseLastUsedBeforeTheChange) {
    // A cell that keeps the last 16 bits of the frame of its last use, at any count of frames.
    for (const uint32_t now : {5u, 40000u, 0xFFFFu, 0x10000u, 0x10003u, 0xFFFFFFFFu, 0u, 2u}) {
        for (const uint32_t used_ago : {1u, 2u, 3u, 100u, 0x7FFFu, gpu::kMaxAge}) {
            for (const uint32_t changed_ago : {0u, 1u, 2u, 3u, 99u, 100u, 0x7FFEu}) {
                const gpu::Cell cell{1, ((now - used_ago) & 0xFFFFu) << 16, 7};
                ASSERT_EQ(gpu::changed_since(changed_ago, gpu::cell_age(cell, now)),
                          used_ago > changed_ago)
                    << now << " " << used_ago << " " << changed_ago;
            }
        }
    }
}

TEST(StaleCells, OldestUseIsBeforeAnyChange) {
    // Ages beyond kMaxAge are all told as a little more than it.
    for (const uint32_t changed_ago : {gpu::kMaxAge - 1, gpu::kMaxAge, 100000u, 0xFFFFFFFFu}) {
        EXPECT_TRUE(gpu::changed_since(changed_ago, gpu::kMaxAge));
        EXPECT_TRUE(gpu::changed_since(changed_ago, gpu::kMaxAge + 1));
        EXPECT_FALSE(gpu::changed_since(changed_ago, gpu::kMaxAge - 1));
    }
}

TEST(StaleCells, RadiusHoldsAllPointsOfACell) {
    // As claim.comp.glsl moves points: by up to `jitter` cells along each of two tangents.
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    float farthest = 0.0f;
    for (int i = 0; i < 200000; ++i) {
        const float jitter = 1.0f, inverse_smallest = 8.0f;
        const int level = i % 3;
        const float size = gpu::power_of_two(level) / inverse_smallest;
        const glm::vec3 normal =
            glm::normalize(glm::vec3(unit(random), unit(random), unit(random)) + 1e-6f);
        const glm::vec3 position = 3.0f * glm::vec3(unit(random), unit(random), unit(random));
        const glm::vec3 tangent = glm::normalize(glm::cross(
            normal, glm::abs(normal.x) > 0.5f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
        const auto corner = [&] { return unit(random) < 0.0f ? -jitter : jitter; };
        const glm::vec3 shift =
            size * (corner() * tangent + corner() * glm::cross(normal, tangent));
        const gpu::CellKey key =
            gpu::cell_key(position + shift, normal, level, inverse_smallest, 3.0f);
        const float distance =
            glm::distance(position, gpu::cell_centre(key, inverse_smallest)) / size;
        ASSERT_LE(distance, gpu::cell_radius(jitter) + 1e-3f);
        farthest = std::max(farthest, distance);
    }
    EXPECT_GT(farthest, 0.9f * gpu::cell_radius(1.0f));
}

} // namespace
} // namespace romascope
