// SPDX-License-Identifier: MIT
// Rays that keep their direction in an aligned map, against a walk of their own in double
// precision: all borders that the ray crosses, sorted, and the cell in the middle of each piece
// between them.
#include "renderer/tracers/roma/walk_cpu.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace romascope {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr double kCell = 0.25; ///< metres

glm::dvec3 any_direction(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
}

/// What is hit by a ray in aligned coordinates; pieces shorter than rounding may decide nothing.
struct Walk {
    std::optional<double> along; ///< metres from the start of the ray to where it enters the cell
    int columns = 0;             ///< that the ray was in
    bool ambiguous = false;
    bool corners = false; ///< it may have been in more columns, by less than rounding
};

/// `direction`: aligned, per metre. Cells count that are entered before `end`, metres from the
/// start.
Walk walk(glm::dvec3 start, glm::dvec3 direction, double end, glm::dvec3 low, glm::dvec3 high,
          int escape, const std::function<bool(glm::ivec3)>& occupied) {
    constexpr double kShort = 1e-3;
    Walk result;
    std::vector<double> borders = {0.0};
    for (int axis = 0; axis < 3; ++axis) {
        result.ambiguous |= std::abs(start[axis] - std::round(start[axis])) < kShort;
        for (double border = low[axis]; border <= high[axis]; ++border) {
            const double t = (border - start[axis]) / direction[axis];
            if (t > 0.0)
                borders.push_back(t);
        }
    }
    std::ranges::sort(borders);
    bool escaping = true;
    int skipped = 0;
    glm::ivec2 column(std::numeric_limits<int>::min());
    for (size_t i = 0; i + 1 < borders.size(); ++i) {
        const glm::dvec3 middle = start + direction * 0.5 * (borders[i] + borders[i + 1]);
        const glm::ivec3 cell(glm::floor(middle));
        const bool hit = occupied(cell);
        if (borders[i + 1] - borders[i] < kShort * kCell) {
            // On a corner, where rounding decides which of the cells about it the ray passes.
            for (int corner = 0; corner < 8; ++corner) {
                const glm::dvec3 side(corner & 1, corner / 2 & 1, corner / 4);
                const glm::dvec3 beside = middle + 2.0 * kShort * (2.0 * side - 1.0);
                result.ambiguous |= occupied(glm::ivec3(glm::floor(beside)));
            }
            result.corners = true;
            continue;
        }
        // The first piece is entered where the face of its cell lies, which may be behind the
        // start.
        result.ambiguous |= hit && std::abs(borders[i] - end) < kShort * kCell;
        if (borders[i] >= end)
            return result;
        result.columns += glm::ivec2(cell) != column;
        column = glm::ivec2(cell);
        escaping = escaping && hit && skipped < escape;
        if (hit && !escaping) {
            result.along = borders[i];
            return result;
        }
        skipped += hit;
    }
    return result;
}

struct Tally {
    size_t compared = 0, hits = 0, unfinished = 0, escaped = 0;
};

TEST(RomaWalk, InAShearedMapMeetsWhatTheShearedCellsHold) {
    std::mt19937 random(167); // one ray leaves the grid within its run of cells and comes back
    std::uniform_real_distribution<double> unit(0.02, 0.98);
    Tally tally;
    for (int trial = 0; trial < 300; ++trial) {
        OccupancyGrid grid;
        grid.cell_size = static_cast<float>(kCell);
        grid.origin = {1.0f, -2.0f, 0.5f};
        for (int axis = 0; axis < 3; ++axis)
            grid.size[axis] = 3 + static_cast<int>(random() % 38);
        BitGrid base(grid.size);
        for (int i = 0; i < grid.size.x * grid.size.y * grid.size.z / 40 + 1; ++i)
            base.set({static_cast<int>(random() % unsigned(grid.size.x)),
                      static_cast<int>(random() % unsigned(grid.size.y)),
                      static_cast<int>(random() % unsigned(grid.size.z))});
        const glm::dvec3 candidate[] = {any_direction(random)};
        const ShearFrame frame = shear_frame(candidate, grid, 1, 1, 0.0);
        const ShearedMap map = shear_on_cpu(base, frame, 0, 1);
        const ShearAxes axes(map.map.slope.z);
        const glm::dvec2 slope = glm::dvec2(map.map.slope) / 32768.0;
        const auto aligned = [&](glm::dvec3 v) {
            return glm::dvec3(v[axes.p] - slope.x * v[axes.m], v[axes.q] - slope.y * v[axes.m],
                              v[axes.m]);
        };
        const auto occupied = [&](glm::ivec3 cell) {
            const glm::dvec2 moved = glm::floor(slope * (cell.z + 0.5) + 0.5);
            glm::ivec3 at;
            at[axes.p] = cell.x + static_cast<int>(moved.x);
            at[axes.q] = cell.y + static_cast<int>(moved.y);
            at[axes.m] = cell.z;
            return base.get(at);
        };
        for (int k = 0; k < 30; ++k) {
            const glm::dvec3 place(unit(random), unit(random), unit(random));
            const glm::vec3 point(glm::dvec3(grid.origin) + kCell * place * glm::dvec3(grid.size));
            const glm::vec3 direction(
                glm::normalize((k % 3 ? 1.5 : 0.0) * candidate[0] + any_direction(random)));
            const float t_max = k % 2 ? kInfinity : static_cast<float>(6.0 * unit(random));
            const int escape = k % 4;
            if (std::abs(aligned(direction).z) < 0.01)
                continue; // metres are far from what floats say, a slice being a hundred long
            const gpu::RomaWalk on_map =
                gpu::shear_walk(map.grid, map.map, point, {0, 0, 1}, direction, t_max);
            const Walk expected =
                walk(aligned((glm::dvec3(point) - glm::dvec3(grid.origin)) / kCell),
                     aligned(glm::dvec3(direction) / kCell), t_max, glm::dvec3(-90.0),
                     glm::dvec3(130.0), escape, occupied);
            if (expected.ambiguous)
                continue;
            const WalkResult many = walk_on_cpu(map, on_map, 1000, escape);
            ASSERT_FALSE(many.unfinished);
            ASSERT_EQ(many.distance >= 0.0f, expected.along.has_value());
            ++tally.compared;
            if (expected.along) {
                ASSERT_NEAR(many.distance, *expected.along, 1e-2 * kCell);
                ++tally.hits;
                if (expected.corners)
                    continue;
                // As many iterations as columns are enough, one less is not.
                const WalkResult enough = walk_on_cpu(map, on_map, expected.columns, escape);
                ASSERT_EQ(enough.distance, many.distance);
                ASSERT_FALSE(enough.unfinished);
                if (expected.columns > 1) {
                    ASSERT_TRUE(walk_on_cpu(map, on_map, expected.columns - 1, escape).unfinished);
                    ++tally.unfinished;
                }
            }
            tally.escaped +=
                escape > 0 && many.distance != walk_on_cpu(map, on_map, 1000, 0).distance;
        }
    }
    EXPECT_GT(tally.compared, 4000u);
    EXPECT_GT(tally.hits, 1500u);
    EXPECT_GT(tally.unfinished, 1000u);
    EXPECT_GT(tally.escaped, 20u);
}

TEST(RomaWalk, InARotatedMapMeetsWhatItsCellsHold) {
    std::mt19937 random(38); // one ray passes a corner where three cells meet
    std::uniform_real_distribution<double> unit(0.05, 0.95);
    Tally tally;
    Bounds bounds;
    bounds.add({0, 0, 0});
    bounds.add({8, 5, 6});
    OccupancyGrid grid = OccupancyGrid::fit(bounds, 33, glm::vec3(0.0f));
    for (int trial = 0; trial < 200; ++trial) {
        const int side = 20 + static_cast<int>(random() % 20);
        const glm::dvec3 candidate = any_direction(random);
        const AlignedBox box = AlignedBox::around(bounds, grid.cell_size, candidate, side);
        AlignedMap map{aligned_map(box, side, grid, 0.3), side, {}};
        map.words.resize(static_cast<size_t>(side) * side * map.words_per_column());
        for (int i = 0; i < side * side * side / 60; ++i) {
            const auto k = static_cast<uint32_t>(random() % unsigned(side));
            const size_t column = random() % (unsigned(side) * unsigned(side));
            map.words[column * static_cast<size_t>(map.words_per_column()) + k / 32] |= 1u
                                                                                        << k % 32;
        }
        const auto occupied = [&](glm::ivec3 cell) {
            if (glm::any(glm::lessThan(cell, glm::ivec3(0))) ||
                glm::any(glm::greaterThanEqual(cell, glm::ivec3(side))))
                return false;
            return ((map.column(glm::ivec2(cell))[cell.z / 32] >> cell.z % 32) & 1u) != 0;
        };
        for (int k = 0; k < 30; ++k) {
            const glm::vec3 point(glm::dvec3(unit(random), unit(random), unit(random)) *
                                  glm::dvec3(8, 5, 6));
            const glm::vec3 normal(any_direction(random));
            const glm::vec3 direction(
                glm::normalize((k % 3 ? -1.5 : 0.0) * candidate + any_direction(random)));
            const auto to_box = [&](glm::dvec3 v) {
                return glm::transpose(box.axes) * v / box.cell;
            };
            const glm::dvec3 relative = glm::dvec3(point) - box.centre;
            const glm::dvec3 start = to_box(relative + 0.3 * glm::dvec3(normal)) + 0.5 * side;
            const glm::dvec3 turned = to_box(direction);
            const double surface = to_box(relative).z + 0.5 * side;
            // From the surface to the start, along the ray by way of slices.
            const double to_start = (start.z - surface) / turned.z;
            const float t_max = k % 2 ? kInfinity : static_cast<float>(12.0 * unit(random));
            if (std::abs(turned.z) < 0.1)
                continue; // where to_start is far from what floats say
            const gpu::RomaWalk on_map = gpu::roma_walk_in_box(map.direction, glm::vec3(relative),
                                                               normal, direction, t_max, side);
            const Walk expected = walk(start, turned, t_max - to_start, glm::dvec3(-5.0),
                                       glm::dvec3(side + 5.0), k % 4, occupied);
            if (expected.ambiguous)
                continue;
            const WalkResult many = walk_on_cpu(map, on_map, 1000, k % 4);
            ASSERT_EQ(many.distance >= 0.0f, expected.along.has_value());
            ASSERT_FALSE(many.unfinished);
            if (expected.along && *expected.along > 0.0) {
                ASSERT_NEAR(many.distance, std::max(*expected.along + to_start, 0.0), 1e-2 * kCell);
            }
            ++tally.compared;
            tally.hits += expected.along.has_value();
        }
    }
    EXPECT_GT(tally.compared, 2000u);
    EXPECT_GT(tally.hits, 1000u);
}

TEST(RomaWalk, OneIterationIsASnappedRay) {
    // In the column of its start all the way, whatever its own direction.
    OccupancyGrid grid;
    grid.size = {40, 40, 40};
    grid.cell_size = 1.0f;
    BitGrid base(grid.size);
    base.set({20, 20, 30});
    const glm::dvec3 up[] = {{0, 0, 1}};
    const ShearedMap map = shear_on_cpu(base, shear_frame(up, grid, 1, 1, 0.0), 0, 1);
    const glm::vec3 point(20.5f, 20.5f, 5.5f), slanted(0.28734788f, 0.0f, 0.95782628f); // 3 : 10
    const auto trace = [&](int iterations, float t_max) {
        return walk_on_cpu(map,
                           gpu::shear_walk(map.grid, map.map, point, {0, 0, 1}, slanted, t_max),
                           iterations, 0);
    };
    EXPECT_NEAR(trace(1, kInfinity).distance, 24.5f * std::sqrt(1.09f), 1e-3f);
    EXPECT_TRUE(trace(1, kInfinity).unfinished);
    EXPECT_LT(trace(1, 20.0f).distance, 0.0f); // its reach ends before
    EXPECT_LT(trace(64, kInfinity).distance, 0.0f);
    EXPECT_FALSE(trace(64, kInfinity).unfinished);
    // It changes over 10.35 columns before it leaves.
    EXPECT_TRUE(trace(11, kInfinity).unfinished);
    EXPECT_FALSE(trace(13, kInfinity).unfinished); // a slice more, as the grid has a margin
    EXPECT_FALSE(trace(1, 1.0f).unfinished);       // ends in its first column
}

} // namespace
} // namespace romascope
