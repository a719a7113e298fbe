// SPDX-License-Identifier: MIT
// The spatial hash without a GPU: keys, probing, and what a cell becomes.
#include "renderer/reuse/spatial_hash/table_model.h"
#include "shaders/reuse/spatial_hash/cell_key.h"
#include "shaders/reuse/spatial_hash/pixel_cells.h"

#include <gtest/gtest.h>
#include <xxhash.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace romascope {
namespace {

using gpu::CellKey;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr HashProbing kProbings[] = {HashProbing::linear, HashProbing::rehash, HashProbing::bucket};

bool same(const CellKey& a, const CellKey& b) {
    return a.cell == b.cell && a.normal == b.normal && a.level == b.level;
}

TEST(CellSize, IsTheLargestPowerOfTwoBelowWhatIsWanted) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> exponent(-8.0f, 29.0f);
    for (int i = 0; i < 10000; ++i) {
        const float ratio = std::exp2(exponent(random));
        const float size = gpu::power_of_two(gpu::cell_level(ratio));
        if (ratio < 1.0f) {
            EXPECT_EQ(size, 1.0f) << "never below the smallest";
        } else {
            EXPECT_LE(size, ratio);
            EXPECT_GT(2.0f * size, ratio);
        }
    }
    for (const float odd : {0.0f, -1.0f, kNan, -kInfinity})
        EXPECT_EQ(gpu::cell_level(odd), 0) << odd;
    EXPECT_EQ(gpu::cell_level(kInfinity), gpu::kMaxCellLevel);
}

TEST(CellSize, GoesOverIntoTheNextWithoutAStep) {
    // The place of a ratio on the scale of sizes, level plus weight, never falls and never jumps.
    float last = 0.0f;
    for (float ratio = 0.5f; ratio < 1e6f; ratio *= 1.0001f) {
        const float weight = gpu::next_level_weight(ratio);
        ASSERT_GE(weight, 0.0f);
        ASSERT_LT(weight, 1.0f);
        const float place = static_cast<float>(gpu::cell_level(ratio)) + weight;
        ASSERT_GE(place, last);
        ASSERT_LT(place - last, 0.001f) << ratio;
        last = place;
    }
    EXPECT_EQ(gpu::next_level_weight(kNan), 0.0f);
    EXPECT_EQ(gpu::next_level_weight(kInfinity), 0.0f);
}

TEST(CellKeys, SurfacesOnBordersHoldStill) {
    // Planes at every multiple of the size along an axis, as far as a room goes, seen with the
    // rounding of positions and of packed normals (4e-5, shaders/common/octahedral.glsl).
    std::mt19937 random(2);
    std::uniform_real_distribution<float> noise(-1.0f, 1.0f);
    for (const float smallest : {0.07f, 0.25f, 1.0f}) {
        for (int axis = 0; axis < 3; ++axis) {
            for (int place = -40; place <= 40; ++place) {
                for (const int level : {0, 1, 5}) {
                    const float size = smallest * gpu::power_of_two(level);
                    for (const float side : {-1.0f, 1.0f}) {
                        std::set<int> cells;
                        for (int i = 0; i < 50; ++i) {
                            glm::vec3 position(0.3f * size), normal(0.0f);
                            position[axis] = static_cast<float>(place) * size;
                            position[axis] *= 1.0f + 1e-6f * noise(random);
                            position[axis] += 1e-5f * size * noise(random);
                            normal[axis] = side;
                            normal[(axis + 1) % 3] = 4e-5f * noise(random);
                            const CellKey key =
                                gpu::cell_key(position, normal, level, 1.0f / smallest, 3.0f);
                            cells.insert(key.cell[axis]);
                        }
                        ASSERT_EQ(cells.size(), 1u) << smallest << " " << place << " " << level;
                    }
                }
            }
        }
    }
}

TEST(CellKeys, NormalsThatScenesAreFullOfHoldStill) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> noise(-4e-5f, 4e-5f);
    for (const float bins : {1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 8.0f}) {
        for (const float component :
             {0.0f, 0.5f, 0.70710678f, 0.8660254f, 0.57735027f, 0.89442719f, 0.4472136f, 1.0f}) {
            for (const float side : {-1.0f, 1.0f}) {
                std::set<int> found;
                for (int i = 0; i < 200; ++i) {
                    const glm::vec3 normal(side * component + noise(random), 0.0f, 0.0f);
                    found.insert(gpu::cell_key({0, 0, 0}, normal, 0, 1.0f, bins).normal.x);
                }
                EXPECT_EQ(found.size(), 1u) << component << " of " << bins << " bins";
            }
        }
    }
}

TEST(CellKeys, AllCellsAreEquallyWide) {
    // Truncation would make the one at 0 twice as wide.
    std::map<int, int> counts;
    for (int i = -4000; i < 4000; ++i)
        ++counts[gpu::cell_key({(static_cast<float>(i) + 0.5f) / 1000.0f, 0, 0}, {0, 1, 0}, 0, 1.0f,
                               3.0f)
                     .cell.x];
    ASSERT_EQ(counts.size(), 8u);
    for (const auto& [cell, count] : counts)
        EXPECT_EQ(count, 1000) << cell;
}

TEST(CellKeys, AnyPointHasOne) {
    for (const float far : {1e9f, -1e9f, 1e30f, kInfinity, -kInfinity, kNan}) {
        const CellKey key = gpu::cell_key({far, 0, far}, {far, 1, 0}, 0, 1.0f / 0.07f, 3.0f);
        EXPECT_NE(gpu::key_checksum(key), 0u);
        for (const HashProbing probing : kProbings)
            for (int probe = 0; probe < 64; ++probe)
                EXPECT_LT(
                    gpu::probe_slot(gpu::home_hash(key), probe, static_cast<int>(probing), 1023u),
                    1024u);
    }
}

std::vector<CellKey> keys_of_a_room() {
    std::vector<CellKey> keys;
    for (int level = 0; level < 2; ++level)
        for (int x = -40; x < 40; ++x)
            for (int y = -20; y < 20; ++y)
                for (int z = -20; z < 20; ++z)
                    for (int side = -3; side <= 3; side += 6)
                        keys.push_back({{x, y, z}, {0, side, 0}, level});
    return keys;
}

TEST(KeyHashes, TheChecksumIsXxHash) {
    std::mt19937 random(4);
    for (int i = 0; i < 1000; ++i) {
        std::array<uint32_t, 3> words;
        for (uint32_t& word : words)
            word = static_cast<uint32_t>(random());
        const auto seed = static_cast<uint32_t>(random());
        EXPECT_EQ(gpu::xx_hash({words[0], words[1], words[2]}, seed),
                  XXH32(words.data(), sizeof words, seed));
    }
}

TEST(KeyHashes, SpreadOverSlotsLikeRandomNumbers) {
    const std::vector<CellKey> keys = keys_of_a_room();
    constexpr size_t kSlots = 4096;
    std::vector<double> slots(kSlots), checksums(kSlots);
    std::set<uint32_t> distinct;
    for (const CellKey& key : keys) {
        slots[gpu::home_hash(key) % kSlots] += 1;
        checksums[gpu::key_checksum(key) % kSlots] += 1;
        distinct.insert(gpu::key_checksum(key));
    }
    const double mean = static_cast<double>(keys.size()) / kSlots;
    for (const std::vector<double>* counts : {&slots, &checksums}) {
        double chi_squared = 0;
        for (const double count : *counts)
            chi_squared += (count - mean) * (count - mean) / mean;
        // Mean kSlots, standard deviation sqrt(2 kSlots): six of those.
        EXPECT_NEAR(chi_squared, kSlots, 6 * std::sqrt(2.0 * kSlots));
    }
    // n^2 / 2^33 pairs of equal checksums are expected: 8.
    EXPECT_GT(distinct.size(), keys.size() - 30);
}

TEST(KeyHashes, EveryNormalHasAKindOfItsOwn) {
    std::set<uint32_t> kinds;
    const auto bins = static_cast<float>(kHashNormalBins.maximum());
    for (int x = -20; x <= 20; ++x)
        for (int y = -20; y <= 20; ++y)
            for (int z = -20; z <= 20; ++z)
                for (const int level : {0, gpu::kMaxCellLevel + 1}) {
                    const glm::vec3 normal = glm::vec3(x, y, z) / 20.0f;
                    kinds.insert(gpu::cell_kind(gpu::cell_key({}, normal, level, 1.0f, bins)));
                }
    EXPECT_EQ(kinds.size(), 2u * 41 * 41 * 41);
}

TEST(KeyHashes, EveryIntegerOfTheKeyCounts) {
    const CellKey base{{1, 2, 3}, {0, 3, -1}, 2};
    std::vector<CellKey> others(7, base);
    for (int i = 0; i < 3; ++i) {
        ++others[static_cast<size_t>(i)].cell[i];
        ++others[static_cast<size_t>(3 + i)].normal[i];
    }
    ++others[6].level;
    for (const CellKey& other : others) {
        EXPECT_FALSE(same(base, other));
        EXPECT_NE(gpu::home_hash(base), gpu::home_hash(other));
        EXPECT_NE(gpu::key_checksum(base), gpu::key_checksum(other));
    }
}

TEST(Probing, LooksAtDifferentSlotsAndWraps) {
    for (uint32_t hash : {0u, 5u, 15u, 0xFFFFFFFFu}) {
        std::set<uint32_t> linear, bucket;
        for (int probe = 0; probe < 16; ++probe)
            linear.insert(gpu::probe_slot(hash, probe, gpu::kProbeLinear, 15u));
        EXPECT_EQ(linear.size(), 16u) << "the whole of a small table";
        for (int probe = 0; probe < 8; ++probe) {
            const uint32_t slot = gpu::probe_slot(hash, probe, gpu::kProbeBucket, 1023u);
            EXPECT_EQ(slot / 8, (hash & 1023u) / 8);
            bucket.insert(slot);
        }
        EXPECT_EQ(bucket.size(), 8u) << "the whole of a bucket";
        for (const HashProbing probing : kProbings)
            EXPECT_EQ(gpu::probe_slot(hash, 0, static_cast<int>(probing), 1023u), hash & 1023u);
    }
}

TEST(PixelCells, ComeBackAsTheyWerePacked) {
    for (const uint32_t slot : {0u, 1u, 12345u, (1u << 24) - 1, gpu::kNoSlot}) {
        EXPECT_EQ(gpu::unpacked_slot(gpu::packed_slot(slot) | gpu::kCellTakes | gpu::kLargerTakes),
                  slot);
        for (const float weight : {0.0f, 0.25f, 0.9999f, 1.0f}) {
            const uint32_t word = gpu::packed_larger(slot, weight);
            EXPECT_EQ(gpu::unpacked_slot(word), slot);
            EXPECT_EQ(gpu::larger_weight(word), gpu::rounded_weight(weight));
            EXPECT_NEAR(gpu::larger_weight(word), weight, 0.5f / gpu::kFullWeight + 1e-6f);
        }
    }
}

TEST(CellState, SumsOfAnyFrameSaturate) {
    // All pixels of a 4K picture with 64 rays each in one cell that was full before.
    const uint32_t frame_samples = 3840u * 2160u * 64u;
    ASSERT_LE(frame_samples, gpu::kMaxFrameSamples);
    std::mt19937 random(5);
    for (int i = 0; i < 2000; ++i) {
        const uint32_t before = random() % (gpu::kMaxSettled + 1);
        uint32_t samples = before + random() % frame_samples;
        if (i == 0)
            samples = gpu::kMaxSettled + gpu::kMaxFrameSamples;
        const uint32_t hits = random() % (samples + 1);
        const gpu::Cell cell =
            gpu::settled_cell({7u, hits, samples | gpu::kInUse}, 70000u + random() % 9, 20u);
        const uint32_t kept = gpu::cell_samples(cell), kept_hits = gpu::cell_hits(cell);
        ASSERT_LE(kept, gpu::kMaxSettled);
        ASSERT_LE(kept_hits, kept);
        if (samples <= gpu::kMaxSettled) {
            ASSERT_EQ(kept, samples) << "what fits is kept exactly";
            ASSERT_EQ(kept_hits, hits);
        } else {
            ASSERT_GE(kept, uint32_t{gpu::kMaxSampleCap});
            ASSERT_NEAR(double(kept_hits) / kept, double(hits) / samples, 1.5 / gpu::kMaxSampleCap);
        }
    }
}

TEST(CellState, AgesAreRightWhereverFramesWrap) {
    for (const uint32_t first :
         {0u, 65530u, (1u << 24) - 10u, 0x7FFFFFFAu, 0xFFFFFFF0u, 0xFFFFFFFFu}) {
        for (const uint32_t max_age : {1u, 20u, 10000u}) {
            gpu::Cell cell =
                gpu::settled_cell({9u, 3u, 5u | gpu::kInUse}, first, max_age); // last use
            for (uint32_t age = 1; age <= max_age; ++age) {
                cell = gpu::settled_cell(cell, first + age, max_age);
                ASSERT_EQ(gpu::cell_age(cell, first + age), age);
                ASSERT_EQ(cell.checksum, 9u);
                ASSERT_EQ(gpu::cell_hits(cell), 3u);
                ASSERT_EQ(gpu::cell_samples(cell), 5u);
            }
            cell = gpu::settled_cell(cell, first + max_age + 1, max_age);
            EXPECT_EQ(cell.checksum, 0u);
            EXPECT_EQ(cell.hits, 0u);
            EXPECT_EQ(cell.samples, 0u);
        }
        // Where nothing is evicted, an age stays at its end instead of starting over.
        gpu::Cell kept = gpu::settled_cell({9u, 3u, 5u | gpu::kInUse}, first, gpu::kMaxAge);
        for (uint32_t age = 1; age < 150000; ++age)
            kept = gpu::settled_cell(kept, first + age, gpu::kMaxAge);
        EXPECT_EQ(gpu::cell_age(kept, first + 149999), gpu::kMaxAge);
        EXPECT_EQ(gpu::cell_hits(kept), 3u);
    }
}

TEST(CellState, ANewCellBeginsWithWhatIsKnownAroundIt) {
    EXPECT_EQ(gpu::blended_hits({0, 0}, {0, 0}, 0.3f), -1.0f);
    EXPECT_EQ(gpu::blended_hits({1, 4}, {0, 0}, 0.3f), 0.25f);
    EXPECT_EQ(gpu::blended_hits({0, 0}, {30, 40}, 0.0f), 0.75f);
    EXPECT_NEAR(gpu::blended_hits({500, 1000}, {100, 1000}, 0.0f), 0.5f, 0.01f);
    EXPECT_NEAR(gpu::blended_hits({500, 1000}, {100, 1000}, 1.0f), 0.1f, 1e-6f);
    for (const float weight : {0.0f, 0.37f, 1.0f})
        EXPECT_EQ(gpu::blended_hits({0, 3}, {0, 9}, weight), 0.0f) << "open stays exactly open";
}

TEST(CellState, HistogramsPutEachInOneBin) {
    EXPECT_EQ(gpu::samples_bin(0u), 0);
    EXPECT_EQ(gpu::samples_bin(3u), 0);
    EXPECT_EQ(gpu::samples_bin(4u), 1);
    EXPECT_EQ(gpu::samples_bin(1023u), 4);
    EXPECT_EQ(gpu::samples_bin(1024u), 5);
    EXPECT_EQ(gpu::samples_bin(65535u), 5);
    EXPECT_EQ(gpu::age_bin(0u), 0);
    EXPECT_EQ(gpu::age_bin(1u), 1);
    EXPECT_EQ(gpu::age_bin(2u), 2);
    EXPECT_EQ(gpu::age_bin(15u), 4);
    EXPECT_EQ(gpu::age_bin(16u), 5);
    EXPECT_EQ(gpu::age_bin(30000u), 5);
}

} // namespace
} // namespace romascope
