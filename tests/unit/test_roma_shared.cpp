// SPDX-License-Identifier: MIT
// The lines that CPU and GPU share: bit ranges, spans, the mapping of directions to strata.
#include "renderer/tracers/roma/directions.h"
#include "renderer/tracers/roma/roma_cpu.h"
#include "shaders/common/bits.h"
#include "shaders/common/exact_math.h"
#include "shaders/common/random.h"
#include "shaders/tracers/roma/concentric.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace romascope {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(Bits, RangeEqualsBitByBit) {
    for (int word = 0; word < 3; ++word) {
        for (int first = -40; first < 140; ++first) {
            for (int last = -40; last < 140; ++last) {
                uint32_t expected = 0;
                for (int bit = 0; bit < 32; ++bit)
                    if (32 * word + bit >= first && 32 * word + bit <= last)
                        expected |= 1u << bit;
                ASSERT_EQ(gpu::bits_in_range(word, first, last), expected)
                    << word << ": " << first << ".." << last;
            }
        }
    }
}

TEST(Bits, HalvesEqualRangesWithoutEnd) {
    for (int word = 0; word < 3; ++word)
        for (int cell = -40; cell < 140; ++cell) {
            ASSERT_EQ(gpu::bits_from(word, cell, false), gpu::bits_in_range(word, cell, 1000));
            ASSERT_EQ(gpu::bits_from(word, cell, true), gpu::bits_in_range(word, -1000, cell - 1));
        }
}

TEST(ExactMath, IsAccurate) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> exponent(-20.0f, 20.0f);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    for (int i = 0; i < 100000; ++i) {
        const float x = std::exp(exponent(random));
        EXPECT_NEAR(gpu::exact_reciprocal(x) * static_cast<double>(x), 1.0, 3e-7);
        EXPECT_NEAR(gpu::exact_sqrt(x) / std::sqrt(static_cast<double>(x)), 1.0, 3e-7);
        const float u = unit(random);
        EXPECT_NEAR(gpu::exact_atan_over_quarter_pi(u),
                    std::atan(static_cast<double>(u)) * 4 / std::numbers::pi, 3e-7);
    }
    EXPECT_EQ(gpu::exact_sqrt(0.0f), 0.0f);
    EXPECT_EQ(gpu::exact_atan_over_quarter_pi(0.0f), 0.0f);
    EXPECT_NEAR(gpu::exact_atan_over_quarter_pi(1.0f), 1.0f, 3e-7f);
}

TEST(Concentric, InvertsTheMappingOfTheSquare) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 100000; ++i) {
        const glm::dvec2 place(unit(random), unit(random));
        const glm::dvec3 direction = hemisphere_from_square(place);
        EXPECT_NEAR(glm::length(direction), 1.0, 1e-12);
        EXPECT_GE(direction.z, 0.0);
        const glm::vec2 back = gpu::square_from_hemisphere(glm::vec3(direction));
        // Next to the pole, float directions lose the radius: 1 - z has steps of 6e-8.
        const double radius =
            std::max({std::abs(2 * place.x - 1), std::abs(2 * place.y - 1), 1e-3});
        EXPECT_NEAR(back.x, 2 * place.x - 1, 1e-6 / radius);
        EXPECT_NEAR(back.y, 2 * place.y - 1, 1e-6 / radius);
    }
}

TEST(Concentric, StrataHaveEqualSolidAngles) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (const int side : {2, 4, 7, 16}) {
        const int strata = side * side;
        const int count = 4000 * strata;
        std::vector<int> hits(static_cast<size_t>(strata));
        for (int i = 0; i < count; ++i) {
            const glm::dvec3 d =
                glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
            ++hits[static_cast<size_t>(gpu::stratum_of_direction(glm::vec3(d), side))];
        }
        // Each count is binomial with mean 4000; five of its deviations.
        for (const int hit : hits)
            EXPECT_NEAR(hit, 4000, 5 * std::sqrt(4000.0));
    }
}

TEST(Concentric, ACandidateLiesInItsOwnStratum) {
    for (const int side : {2, 3, 4, 8, 16}) {
        int strays = 0;
        for (uint32_t frame = 0; frame < 200; ++frame) {
            const auto candidates = candidate_directions(side, true, 5, frame);
            ASSERT_EQ(candidates.size(), static_cast<size_t>(side * side));
            for (int i = 0; i < side * side; ++i) {
                const glm::vec3 direction(candidates[static_cast<size_t>(i)]);
                strays += gpu::stratum_of_direction(direction, side) != i;
                EXPECT_EQ(gpu::stratum_of_direction(-direction, side),
                          gpu::stratum_of_direction(direction, side));
            }
        }
        // Only those that rounding to float carries over a border.
        EXPECT_LE(strays, side * side * 200 / 10000 + 1);
    }
}

TEST(Concentric, EveryUnitDirectionHasAStratum) {
    for (const glm::vec3 d :
         {glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::vec3(1, 0, 0), glm::vec3(-1, 0, 0),
          glm::vec3(0, 1, 0), glm::vec3(0, -1, 0), glm::vec3(0.70710677f, 0.70710677f, 0)})
        for (const int side : {2, 5, 16}) {
            EXPECT_GE(gpu::stratum_of_direction(d, side), 0);
            EXPECT_LT(gpu::stratum_of_direction(d, side), side * side);
        }
}

TEST(Candidates, AreNewEveryFrameAndTheSameForTheSameSeed) {
    EXPECT_EQ(candidate_directions(4, true, 1, 2), candidate_directions(4, true, 1, 2));
    EXPECT_NE(candidate_directions(4, true, 1, 2), candidate_directions(4, true, 1, 3));
    EXPECT_NE(candidate_directions(4, true, 1, 2), candidate_directions(4, true, 2, 2));
    EXPECT_EQ(candidate_directions(4, false, 1, 2), candidate_directions(4, false, 7, 9));
}

TEST(AlignedBox, EnclosesTheSceneWhateverTheDirection) {
    std::mt19937 random(4);
    std::normal_distribution<double> normal;
    Bounds bounds;
    bounds.add({-3, 1, 10});
    bounds.add({5, 2, 17});
    for (int i = 0; i < 500; ++i) {
        const glm::dvec3 direction =
            glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
        const AlignedBox cube = AlignedBox::enclosing(bounds, 0.1, direction, 64);
        const AlignedBox fitting = AlignedBox::around(bounds, 0.1, direction, 64);
        for (const AlignedBox& box : {fitting, cube}) {
            EXPECT_NEAR(glm::determinant(box.axes), 1.0, 1e-9);
            EXPECT_NEAR(glm::dot(box.axes[2], direction), 1.0, 1e-12);
            for (int corner = 0; corner < 8; ++corner) {
                const glm::dvec3 p((corner & 1) ? 5.1 : -3.1, (corner & 2) ? 2.1 : 0.9,
                                   (corner & 4) ? 17.1 : 9.9);
                const glm::dvec3 in_cells = glm::transpose(box.axes) * (p - box.centre) / box.cell;
                for (int axis = 0; axis < 3; ++axis)
                    EXPECT_LE(std::abs(in_cells[axis]), 32.0 + 1e-9);
            }
        }
        // The same cells whatever the direction: the diagonal, 8.2 by 1.2 by 7.2 m.
        EXPECT_NEAR(cube.cell.x, std::sqrt(8.2 * 8.2 + 1.2 * 1.2 + 7.2 * 7.2) / 64, 1e-5);
        EXPECT_EQ(cube.cell, glm::dvec3(cube.cell.x));
        EXPECT_TRUE(glm::all(glm::lessThanEqual(fitting.cell, cube.cell + 1e-9)));
    }
}

// Spans: a map of 64 cells, the surface and the start at the same place unless said otherwise.

gpu::RomaSpan span(float z, float reach, bool forward) {
    return gpu::roma_span({10.5f, 20.5f, z}, z, reach, forward, 64);
}

TEST(Span, WithoutLimitGoesToTheEnd) {
    EXPECT_EQ(span(0.0f, kInfinity, true).first, 0);
    EXPECT_EQ(span(0.0f, kInfinity, true).last, 63);
    EXPECT_EQ(span(31.5f, kInfinity, true).first, 31);
    EXPECT_EQ(span(32.0f, kInfinity, true).first, 32);
    EXPECT_EQ(span(63.9f, kInfinity, false).first, 0);
    EXPECT_EQ(span(63.9f, kInfinity, false).last, 63);
    EXPECT_EQ(span(31.99f, kInfinity, false).last, 31);
    EXPECT_EQ(span(0.5f, kInfinity, false).last, 0);
}

TEST(Span, ACellCountsIfItIsEnteredBeforeTheEnd) {
    EXPECT_EQ(span(10.25f, 1.0f, true).last, 11);  // ends inside cell 11
    EXPECT_EQ(span(10.25f, 0.75f, true).last, 10); // ends as it would enter cell 11
    EXPECT_EQ(span(10.25f, 0.5f, true).last, 10);  // does not leave its own cell
    EXPECT_EQ(span(10.75f, 1.0f, false).first, 9);
    EXPECT_EQ(span(10.75f, 0.75f, false).first, 10);
    EXPECT_EQ(span(10.75f, 0.5f, false).first, 10);
}

TEST(Span, ReachCountsFromTheSurfaceNotFromTheStart) {
    // The start was moved three cells along the ray: a reach of two ends before it.
    const gpu::RomaSpan moved = gpu::roma_span({1, 1, 13.5f}, 10.5f, 2.0f, true, 64);
    EXPECT_GT(moved.first, moved.last);
    const gpu::RomaSpan longer = gpu::roma_span({1, 1, 13.5f}, 10.5f, 5.0f, true, 64);
    EXPECT_EQ(longer.first, 13);
    EXPECT_EQ(longer.last, 15);
}

TEST(Span, StartsOutside) {
    EXPECT_EQ(span(-5.0f, kInfinity, true).first, 0);
    EXPECT_EQ(span(-5.0f, kInfinity, true).last, 63);
    EXPECT_GT(span(-5.0f, kInfinity, false).first, span(-5.0f, kInfinity, false).last);
    EXPECT_EQ(span(70.0f, kInfinity, false).last, 63);
    EXPECT_EQ(span(70.0f, kInfinity, false).first, 0);
    EXPECT_GT(span(70.0f, kInfinity, true).first, span(70.0f, kInfinity, true).last);
    EXPECT_GT(span(64.0f, kInfinity, true).first, span(64.0f, kInfinity, true).last);
    EXPECT_GT(span(-5.0f, 3.0f, true).first, span(-5.0f, 3.0f, true).last); // ends before it
    for (const glm::vec3 beside :
         {glm::vec3(-0.1f, 5, 5), glm::vec3(64, 5, 5), glm::vec3(5, -0.1f, 5), glm::vec3(5, 64, 5),
          glm::vec3(-kInfinity, 5, 5), glm::vec3(5, 1e30f, 5)}) {
        const gpu::RomaSpan none = gpu::roma_span(beside, beside.z, kInfinity, true, 64);
        EXPECT_GT(none.first, none.last);
    }
}

TEST(Span, NoReachIsNoCell) {
    for (const bool forward : {true, false}) {
        // A cell counts only if the ray enters it before its end, and here both are the same face.
        const gpu::RomaSpan none = gpu::roma_span({5, 5, 10.0f}, 10.0f, 0.0f, forward, 64);
        EXPECT_GT(none.first, none.last) << forward;
    }
}

// Hits in a map whose column (0, 0) is given, of two words.

struct Column {
    AlignedMap map;
    explicit Column(uint32_t low, uint32_t high) {
        map.side = 64;
        map.words.resize(64 * 64 * 2);
        map.words[0] = low;
        map.words[1] = high;
    }
    std::optional<float> hit(float z, float reach, bool forward) const {
        const gpu::RomaRay ray{gpu::roma_span({0.5f, 0.5f, z}, z, reach, forward, 64), z, forward};
        const auto distance = closest_hit_on_cpu(map, ray);
        EXPECT_EQ(any_hit_on_cpu(map, ray), distance.has_value());
        return distance;
    }
};

TEST(Hit, FirstAndLastBitsOfWords) {
    for (const int bit : {0, 1, 31, 32, 33, 62, 63}) {
        const uint64_t word = uint64_t(1) << bit;
        const Column column(static_cast<uint32_t>(word), static_cast<uint32_t>(word >> 32));
        const float at = static_cast<float>(bit);
        EXPECT_EQ(column.hit(0.0f, kInfinity, true), at);
        EXPECT_EQ(column.hit(64.0f, kInfinity, false), 63.0f - at);
        EXPECT_EQ(column.hit(at + 0.5f, kInfinity, true), 0.0f); // starts in it
        EXPECT_EQ(column.hit(at + 0.5f, kInfinity, false), 0.0f);
        EXPECT_EQ(column.hit(at + 1.0f, kInfinity, true), std::nullopt); // has left it
        EXPECT_EQ(column.hit(at, kInfinity, false), std::nullopt);
        if (bit > 0) {
            EXPECT_EQ(column.hit(0.0f, at, true), std::nullopt); // ends at its face
            EXPECT_EQ(column.hit(0.0f, at + 0.01f, true), at);
        }
    }
}

TEST(Hit, TheNearestOfMany) {
    const Column column(0x80000001u, 0x00000003u); // cells 0, 31, 32, 33
    EXPECT_EQ(column.hit(1.5f, kInfinity, true), 29.5f);
    EXPECT_EQ(column.hit(32.5f, kInfinity, true), 0.0f);
    EXPECT_EQ(column.hit(63.5f, kInfinity, false), 29.5f);
    EXPECT_EQ(column.hit(30.5f, kInfinity, false), 29.5f);
    EXPECT_EQ(column.hit(34.5f, kInfinity, true), std::nullopt);
}

TEST(Random, HashesDiffer) {
    EXPECT_NE(gpu::pixel_hash({0, 0}, 0), gpu::pixel_hash({1, 0}, 0));
    EXPECT_NE(gpu::pixel_hash({0, 1}, 0), gpu::pixel_hash({1, 0}, 0));
    EXPECT_NE(gpu::pixel_hash({0, 0}, 1), gpu::pixel_hash({0, 0}, 0));
    EXPECT_LT(gpu::unit_float(0xFFFFFFFFu), 1.0f);
    EXPECT_EQ(gpu::unit_float(0), 0.0f);
}

TEST(Random, VanDerCorputFillsEveryInterval) {
    for (const uint32_t shift : {0u, 123456789u, 0x80000001u}) {
        std::vector<int> hits(16);
        for (uint32_t i = 32; i < 48; ++i) // any 16 that start at a multiple of 16
            ++hits[(gpu::van_der_corput(i, shift) - shift) >> 28];
        EXPECT_EQ(hits, std::vector<int>(16, 1));
    }
}

} // namespace
} // namespace romascope
