// SPDX-License-Identifier: MIT
// Alignment by shear on the CPU: no cell is lost, columns are what a walk of their centre line
// finds, and rays hit what they would in the base map. The expectations are worked out in double
// precision, by code of their own; slopes are multiples of 2^-15, which doubles hold exactly.
#include "renderer/tracers/roma/shear_cpu.h"
#include "tests/support/random_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace romascope {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

glm::dvec3 any_direction(std::mt19937& random) {
    // One in four along an axis, in a plane of two axes or in a diagonal, where ties are.
    if (random() % 4 == 0) {
        std::uniform_int_distribution<int> step(-1, 1);
        const glm::dvec3 direction(step(random), step(random), step(random));
        return direction == glm::dvec3(0.0) ? glm::dvec3(0, 0, -1) : glm::normalize(direction);
    }
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
}

glm::ivec3 any_size(std::mt19937& random) {
    const auto side = [&] {
        switch (random() % 4) {
        case 0:
            return 1 + static_cast<int>(random() % 3); // flat
        case 1:
            return 32 * (1 + static_cast<int>(random() % 2));
        default:
            return 1 + static_cast<int>(random() % 70);
        }
    };
    return {side(), side(), side()};
}

/// A random map and what a reader needs to check it by.
struct Sample {
    OccupancyGrid grid;
    BitGrid base;
    glm::dvec3 direction;
    int taps, axis;
    ShearedMap sheared;
    glm::dvec2 slope; ///< cells along p and q per slice
    glm::ivec2 size;  ///< cells of the grid along p and q
    int slices;

    Sample(std::mt19937& random, int taps_wanted)
        : direction(any_direction(random)), taps(taps_wanted), axis(dominant_axis(direction)) {
        grid.size = any_size(random);
        grid.cell_size = 0.173f;
        grid.origin = {-3.7f, 1.1f, 20.0f};
        base = random_grid(grid.size, 0.02 + 0.2 * static_cast<double>(random() % 4), random);
        const glm::dvec3 directions[] = {direction};
        sheared = shear_on_cpu(base, shear_frame(directions, grid, taps, 1, 0.0), 0, taps);
        slope = glm::dvec2(sheared.map.slope) / 32768.0;
        const ShearAxes axes(axis);
        size = {grid.size[axes.p], grid.size[axes.q]};
        slices = grid.size[axes.m];
    }

    bool occupied(glm::ivec2 place, int slice) const {
        const ShearAxes axes(axis);
        glm::ivec3 cell;
        cell[axes.p] = place.x;
        cell[axes.q] = place.y;
        cell[axes.m] = slice;
        return base.get(cell); // false outside, so nothing is wrapped around
    }

    /// Where the centre line of an unwrapped column is at a height.
    glm::dvec2 line(glm::ivec2 column, double height) const {
        return glm::dvec2(column) + 0.5 + slope * height;
    }

    /// The cells of a slice that the taps stand for, from the line alone.
    std::vector<glm::ivec2> cells_of_line(glm::ivec2 column, int slice) const {
        const auto cell_at = [&](double height) {
            return glm::ivec2(glm::floor(line(column, height)));
        };
        if (taps == 1)
            return {cell_at(slice + 0.5)};
        std::vector<glm::ivec2> cells = {cell_at(slice), cell_at(slice + 1.0)};
        if (taps == 3) {
            // Everything in between: the middle of each part between two crossed borders.
            std::vector<double> heights = {double(slice), slice + 1.0};
            for (int axis_2d = 0; axis_2d < 2; ++axis_2d) {
                const double from = line(column, slice)[axis_2d];
                const double to = line(column, slice + 1)[axis_2d];
                for (double border = std::ceil(std::min(from, to)); border <= std::max(from, to);
                     ++border)
                    if (from != to)
                        heights.push_back(slice + (border - from) / (to - from));
            }
            std::ranges::sort(heights);
            for (size_t i = 0; i + 1 < heights.size(); ++i)
                if (heights[i + 1] - heights[i] > 1e-9)
                    cells.push_back(cell_at(0.5 * (heights[i] + heights[i + 1])));
        }
        return cells;
    }

    /// Whether a slice counts: the column's own cell lies in the grid or, with several taps,
    /// beside.
    bool counts(glm::ivec2 column, int slice) const {
        const int guard = taps > 1 ? 1 : 0;
        const glm::ivec2 own(glm::floor(line(column, slice + 0.5)));
        return own.x >= -guard && own.y >= -guard && own.x < size.x + guard &&
               own.y < size.y + guard;
    }

    bool expected(glm::ivec2 column, int slice) const {
        return std::ranges::any_of(cells_of_line(column, slice),
                                   [&](glm::ivec2 cell) { return occupied(cell, slice); });
    }
};

TEST(Shear, OneTapIsABijectionOfTheCells) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 400; ++trial) {
        const Sample sample(random, 1);
        const ShearedMap& sheared = sample.sheared;
        ASSERT_EQ(glm::ivec2(sheared.size), sample.size);
        // Where each place of the map looks: all places of the slice, each once.
        for (int slice = 0; slice < sample.slices; ++slice) {
            std::set<std::pair<int, int>> seen;
            const glm::ivec2 offset = gpu::shear_tap(glm::ivec2(sheared.map.slope), slice, 0, 1);
            for (int j = 0; j < sample.size.y; ++j)
                for (int i = 0; i < sample.size.x; ++i) {
                    const glm::ivec2 cell = gpu::shear_wrapped_column(sheared.grid, sample.axis,
                                                                      glm::ivec2(i, j) + offset);
                    ASSERT_TRUE(cell.x >= 0 && cell.y >= 0 && cell.x < sample.size.x &&
                                cell.y < sample.size.y);
                    seen.insert({cell.x, cell.y});
                }
            ASSERT_EQ(seen.size(), static_cast<size_t>(sample.size.x) * sample.size.y);
        }
        size_t set = 0;
        for (const uint32_t word : sheared.words)
            set += static_cast<size_t>(std::popcount(word));
        ASSERT_EQ(set, sample.base.count());
    }
}

/// The slices that count, first and last.
glm::ivec2 interval_of(const ShearedMap& map, glm::ivec2 column) {
    const gpu::RomaSpan span = map.inside({column, 0, map.size.z - 1, 0});
    return {span.first, span.last};
}

TEST(Shear, ColumnsAreWhatTheirCentreLinesPass) {
    std::mt19937 random(2);
    size_t occupied = 0, outside = 0;
    for (int trial = 0; trial < 600; ++trial) {
        const Sample sample(random, 1 + trial % 3);
        std::uniform_int_distribution<int> i(-sample.slices - 2, sample.size.x + sample.slices + 2);
        std::uniform_int_distribution<int> j(-sample.slices - 2, sample.size.y + sample.slices + 2);
        for (int k = 0; k < 60; ++k) {
            const glm::ivec2 column(i(random), j(random));
            const glm::ivec2 interval = interval_of(sample.sheared, column);
            const auto words = sample.sheared.column(column);
            for (int slice = 0; slice < sample.slices; ++slice) {
                const bool counts = sample.counts(column, slice);
                ASSERT_EQ(slice >= interval.x && slice <= interval.y, counts)
                    << "column " << column.x << " " << column.y << " slice " << slice;
                const bool expected = sample.expected(column, slice);
                const bool found = (words[static_cast<size_t>(slice / 32)] >> slice % 32) & 1u;
                if (counts) {
                    ASSERT_EQ(found, expected) << "taps " << sample.taps;
                } else {
                    // Nothing is lost by leaving a slice out.
                    ASSERT_FALSE(expected) << "taps " << sample.taps;
                }
                occupied += counts && expected;
                outside += !counts;
            }
        }
    }
    EXPECT_GT(occupied, 10000u);
    EXPECT_GT(outside, 10000u);
}

TEST(Shear, NoColumnBeyondTheFarthestHoldsACell) {
    // shear_column brings those that are farther away to this distance.
    std::mt19937 random(3);
    for (int trial = 0; trial < 300; ++trial) {
        const Sample sample(random, 1 + trial % 3);
        for (const float far : {-1e30f, -1e4f, 1e4f, 1e30f, -kInfinity, kInfinity, kNan})
            for (const bool along_u : {true, false}) {
                const gpu::ShearGrid& grid = sample.sheared.grid;
                const glm::ivec2 column = gpu::shear_column(
                    grid, sample.sheared.map, {along_u ? far : 0.5f, along_u ? 0.5f : far, 0.0f});
                // Both have an entry in the table of places.
                for (const int place : {column.x, column.y}) {
                    const int entry = place + gpu::shear_farthest(sample.sheared.map.rays.y);
                    ASSERT_GE(entry, 0) << far;
                    ASSERT_LT(entry, grid.row_words.w) << far;
                }
                const glm::ivec2 interval = interval_of(sample.sheared, column);
                ASSERT_GT(interval.x, interval.y);
            }
    }
}

TEST(Shear, OneMapServesADirectionAndItsOpposite) {
    std::mt19937 random(4);
    OccupancyGrid grid;
    grid.size = {40, 30, 20};
    for (int trial = 0; trial < 1000; ++trial) {
        const glm::dvec3 direction = any_direction(random);
        const glm::dvec3 both[] = {direction, -direction};
        const ShearFrame frame = shear_frame(both, grid, 1, 1, 0.0);
        const gpu::ShearMap& map = frame.maps[0];
        ASSERT_EQ(glm::ivec3(map.slope), glm::ivec3(frame.maps[1].slope));
        ASSERT_EQ(map.scale, frame.maps[1].scale);
        ASSERT_NEAR(std::abs(glm::dot(frame.along(0), direction)), 1.0, 1e-8);
        // Ties of the sign are for slopes of exactly 0 alone, which no direction here has.
        const glm::vec3 towards(direction);
        ASSERT_NE(gpu::shear_is_forward(map, towards), gpu::shear_is_forward(map, -towards));
        ASSERT_EQ(gpu::shear_is_forward(map, towards), glm::dot(frame.along(0), direction) > 0);
    }
}

/// A ray snapped to the map's direction, walked in the base grid in double precision: nothing if
/// it meets no cell. `ambiguous` if rounding could decide.
struct Walk {
    std::optional<double> distance; ///< metres from the surface
    bool ambiguous = false;
};

Walk walk(const Sample& sample, bool forward, glm::dvec3 point, glm::dvec3 normal, double offset,
          double t_max, int escape) {
    const ShearAxes axes(sample.axis);
    const auto to_cells = [&](glm::dvec3 p) {
        return (p - glm::dvec3(sample.grid.origin)) / double(sample.grid.cell_size);
    };
    const auto near_border = [](double x) { return std::abs(x - std::round(x)) < 1e-3; };
    const glm::dvec3 start = to_cells(point + normal * offset);
    const double surface = to_cells(point)[axes.m];
    const double height = start[axes.m];
    const glm::dvec2 foot =
        glm::dvec2(start[axes.p], start[axes.q]) - sample.slope * height; // at slice face 0
    const glm::ivec2 column(glm::floor(foot));
    Walk result;
    result.ambiguous = near_border(foot.x) || near_border(foot.y) || near_border(height);
    const double stretch =
        sample.grid.cell_size * std::sqrt(1.0 + glm::dot(sample.slope, sample.slope));
    const int first = static_cast<int>(std::floor(height));
    bool escaping = true;
    int skipped = 0;
    for (int slice = first; forward ? slice < sample.slices : slice >= 0;
         slice += forward ? 1 : -1) {
        const double entry = (forward ? slice - surface : surface - (slice + 1)) * stretch;
        result.ambiguous |= std::abs(entry - t_max) < 1e-3 * stretch;
        if (entry >= t_max)
            return result;
        const bool hit = slice >= 0 && slice < sample.slices && sample.expected(column, slice);
        escaping = escaping && hit && skipped < escape;
        if (hit && !escaping) {
            result.distance = std::max(entry, 0.0);
            return result;
        }
        skipped += hit;
    }
    return result;
}

TEST(Shear, RaysHitWhatAWalkInDoublePrecisionMeets) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-0.4, 1.4), share(0.0, 1.0);
    size_t compared = 0, hits = 0, ended = 0, escaped = 0;
    for (int trial = 0; trial < 600; ++trial) {
        Sample sample(random, 1 + trial % 3);
        const double cells = 1.5 * static_cast<double>(trial % 2);
        const double offset = sample.grid.cell_size * cells;
        sample.sheared.grid.inverse.w = static_cast<float>(cells);
        const glm::dvec3 extent = double(sample.grid.cell_size) * glm::dvec3(sample.grid.size);
        for (int k = 0; k < 100; ++k) {
            const glm::vec3 point(glm::dvec3(sample.grid.origin) +
                                  glm::dvec3(place(random), place(random), place(random)) * extent);
            const glm::vec3 normal(any_direction(random));
            const bool forward = k % 2 == 0;
            const bool finite = k % 3 != 0;
            const int escape = k % 5;
            const float t_max =
                finite ? static_cast<float>(share(random) * share(random) * glm::length(extent))
                       : kInfinity;
            const Walk expected = walk(sample, forward, point, normal, offset, t_max, escape);
            if (expected.ambiguous)
                continue;
            const gpu::RomaRay ray = sample.sheared.ray(forward, point, normal, t_max);
            const auto found = closest_hit_on_cpu(sample.sheared, ray, escape);
            ASSERT_EQ(found.has_value(), expected.distance.has_value())
                << "trial " << trial << " ray " << k << " escape " << escape;
            ASSERT_EQ(any_hit_on_cpu(sample.sheared, ray, escape), found.has_value());
            if (found) {
                ASSERT_NEAR(*found * sample.sheared.map.scale.w, *expected.distance,
                            1e-3 * sample.grid.cell_size);
            }
            ++compared;
            hits += found.has_value();
            ended += finite && !found;
            escaped += escape > 0 && found != closest_hit_on_cpu(sample.sheared, ray, 0);
        }
    }
    EXPECT_GT(compared, 50000u);
    EXPECT_GT(hits, 5000u);
    EXPECT_GT(ended, 5000u);
    EXPECT_GT(escaped, 500u);
}

TEST(Shear, AReachEndsAtTheFaceOfACell) {
    // Straight up through a column of one cell: no rounding between the slices' faces and metres.
    OccupancyGrid grid;
    grid.size = {1, 1, 64};
    grid.cell_size = 0.5f;
    BitGrid base(grid.size);
    base.set({0, 0, 40});
    const glm::dvec3 up[] = {{0, 0, 1}};
    const ShearedMap map = shear_on_cpu(base, shear_frame(up, grid, 1, 1, 0.0), 0, 1);
    const auto hit = [&](float height, bool forward, float t_max) {
        return closest_hit_on_cpu(map, map.ray(forward, {0.25f, 0.25f, height}, {0, 0, 1}, t_max));
    };
    EXPECT_EQ(hit(5.0f, true, kInfinity), 30.0f);
    EXPECT_EQ(hit(5.0f, true, 15.0f), std::nullopt); // ends as it would enter the cell
    EXPECT_EQ(hit(5.0f, true, 15.001f), 30.0f);
    EXPECT_EQ(hit(25.0f, false, kInfinity), 9.0f);
    EXPECT_EQ(hit(25.0f, false, 4.5f), std::nullopt);
    EXPECT_EQ(hit(25.0f, false, 4.501f), 9.0f);
    EXPECT_EQ(hit(20.25f, true, 0.001f), 0.0f); // starts in it
    EXPECT_EQ(hit(20.5f, true, kInfinity), std::nullopt);
    EXPECT_EQ(hit(20.0f, false, kInfinity), std::nullopt);
    EXPECT_EQ(hit(-5.0f, true, kInfinity), 50.0f);
    EXPECT_EQ(hit(-5.0f, false, kInfinity), std::nullopt);
    EXPECT_EQ(hit(50.0f, false, kInfinity), 59.0f);
}

TEST(Shear, ARowReadsOnWithoutABreakFromAnyPlace) {
    std::mt19937 random(6);
    for (int trial = 0; trial < 100; ++trial) {
        const glm::ivec3 size = any_size(random);
        const int guard = trial % 2;
        const BitGrid base = random_grid(size, 0.4, random);
        const ShearPackings packings = shear_packings(size, guard);
        const std::vector<uint32_t> words = pack_on_cpu(base, packings);
        for (int axis = 0; axis < 3; ++axis) {
            const ShearAxes axes(axis);
            const ShearPacking& packing = packings[static_cast<size_t>(axis)];
            for (int k = 0; k < 20; ++k) {
                const int q = static_cast<int>(random() % unsigned(packing.columns.y));
                const int slice = static_cast<int>(random() % unsigned(packing.slices));
                const int from = static_cast<int>(random() % unsigned(packing.columns.x));
                const auto word = [&](int w) {
                    return words[packing.first_word +
                                 static_cast<size_t>((q * packing.row_words + w) * packing.slices +
                                                     slice)];
                };
                ASSERT_LT(from / 32 + 1, packing.row_words);
                const uint64_t both = word(from / 32) | uint64_t(word(from / 32 + 1)) << 32;
                for (int bit = 0; bit < 32; ++bit) {
                    glm::ivec3 cell;
                    cell[axes.p] = (from + bit) % packing.columns.x;
                    cell[axes.q] = q;
                    cell[axes.m] = slice;
                    ASSERT_EQ((both >> (from % 32 + bit)) & 1u, base.get(cell) ? 1u : 0u);
                }
            }
        }
    }
}

} // namespace
} // namespace romascope
