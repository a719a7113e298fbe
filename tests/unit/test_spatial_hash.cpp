// SPDX-License-Identifier: MIT
// The spatial hash without a GPU: keys, probing, what a cell becomes, and the table under every
// order of its accesses.
#include "renderer/reuse/spatial_hash/table_model.h"
#include "shaders/reuse/spatial_hash/cell_key.h"
#include "shaders/reuse/spatial_hash/pixel_cells.h"

#include <gtest/gtest.h>
#include <xxhash.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <set>

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
        const uint32_t word = random();
        EXPECT_EQ(gpu::xx_hash(word), XXH32(&word, sizeof word, 0));
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
        EXPECT_EQ(gpu::unpacked_slot(gpu::packed_slot(slot) | gpu::kTraceBit | gpu::kSeesSurface |
                                     gpu::kCellTakes | gpu::kLargerTakes),
                  slot);
        for (const float weight : {0.0f, 0.25f, 0.9999f, 1.0f}) {
            const uint32_t word = gpu::packed_larger(slot, weight);
            EXPECT_EQ(gpu::unpacked_slot(word), slot);
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

/// Every order of the accesses of a few invocations in the pass that claims, then every order of
/// those in the pass that adds. Loads may also see a slot as it was before the pass.
class Schedules {
public:
    Schedules(TableModel table, std::vector<HashedKey> keys)
        : before_(table), keys_(std::move(keys)) {
        State start{std::move(table), std::vector<Invocation>(keys_.size())};
        explore(start);
    }

    int ends() const { return ends_; }
    /// What each checksum holds at the end, hits and samples, in every order; and how many
    /// invocations found no slot.
    const std::set<std::map<uint32_t, std::pair<uint32_t, uint32_t>>>& sums() const {
        return sums_;
    }
    const std::set<int>& failures() const { return failures_; }

private:
    struct Invocation {
        gpu::Search search = gpu::search_begin();
        int step = 0; ///< 0: searching, 1: flag, 2: time, 3: at the barrier; 4, 5: adding; 6: done
        uint32_t slot = gpu::kNoSlot;
    };
    struct State {
        TableModel table;
        std::vector<Invocation> invocations;
    };

    static std::vector<uint32_t> code(const State& state) {
        std::vector<uint32_t> words;
        for (const gpu::Cell& cell : state.table.cells())
            words.insert(words.end(), {cell.checksum, cell.hits, cell.samples});
        for (const Invocation& one : state.invocations)
            for (const int value : {one.search.probe, one.search.first_free, one.search.claims,
                                    one.step, static_cast<int>(one.slot)})
                words.push_back(static_cast<uint32_t>(value));
        return words;
    }

    void explore(const State& state) {
        if (!seen_.insert(code(state)).second)
            return;
        const bool all_claimed =
            std::ranges::all_of(state.invocations, [](const auto& one) { return one.step >= 3; });
        bool any = false;
        for (size_t i = 0; i < keys_.size(); ++i) {
            const Invocation& one = state.invocations[i];
            if (one.step == 6 || (one.step == 3 && !all_claimed))
                continue;
            any = true;
            advance(state, i, {});
            if (one.step == 0 && one.search.claims == 0) {
                const uint32_t slot = state.table.slot(keys_[i], one.search.probe);
                const uint32_t old = before_.cells()[slot].checksum;
                if (old != state.table.cells()[slot].checksum)
                    advance(state, i, old);
            }
        }
        if (!any)
            end(state);
    }

    void advance(State state, size_t i, std::optional<uint32_t> old) {
        Invocation& one = state.invocations[i];
        const HashedKey& key = keys_[i];
        // Invocation i brings 1 + i rays, i of which hit.
        switch (one.step) {
        case 0: {
            const uint32_t at = state.table.slot(key, one.search.probe);
            one.search =
                old ? state.table.step(one.search, key, *old) : state.table.step(one.search, key);
            if (one.search.state == gpu::kSearchFailed)
                one.step = 3;
            else if (one.search.state != gpu::kSearchGoesOn) {
                one.slot = at;
                one.step = 1;
            }
            break;
        }
        case 1:
            state.table.flag(one.slot);
            one.step = 2;
            break;
        case 2:
            state.table.take_time(one.slot);
            one.step = 3;
            break;
        case 3:
            if (one.slot != gpu::kNoSlot)
                state.table.add_hits(one.slot, static_cast<uint32_t>(i));
            one.step = 5;
            break;
        case 5:
            if (one.slot != gpu::kNoSlot)
                state.table.add_samples(one.slot, 1 + static_cast<uint32_t>(i));
            one.step = 6;
            break;
        default:
            FAIL() << "no such step";
        }
        explore(state);
    }

    void end(State state) {
        ++ends_;
        state.table.settle(100, 20);
        std::map<uint32_t, std::pair<uint32_t, uint32_t>> sums;
        for (const gpu::Cell& cell : state.table.cells())
            if (cell.checksum != 0) {
                ASSERT_FALSE(sums.contains(cell.checksum)) << "a key has two cells";
                sums[cell.checksum] = {gpu::cell_hits(cell), gpu::cell_samples(cell)};
            }
        int failed = 0;
        for (size_t i = 0; i < keys_.size(); ++i) {
            const uint32_t slot = state.invocations[i].slot;
            failed += slot == gpu::kNoSlot;
            if (slot != gpu::kNoSlot) {
                ASSERT_EQ(state.table.cells()[slot].checksum, keys_[i].checksum);
            }
        }
        sums_.insert(sums);
        failures_.insert(failed);
    }

    TableModel before_;
    std::vector<HashedKey> keys_;
    std::set<std::vector<uint32_t>> seen_;
    int ends_ = 0;
    std::set<std::map<uint32_t, std::pair<uint32_t, uint32_t>>> sums_;
    std::set<int> failures_;
};

using Sums = std::map<uint32_t, std::pair<uint32_t, uint32_t>>;
constexpr HashedKey kA{3, 11}, kB{3, 22}, kC{4, 33}, kD{3, 44};

/// A table as frame 99 left it, with these cells, last used then.
TableModel table_with(HashProbing probing, int search,
                      std::vector<std::pair<int, HashedKey>> keys) {
    TableModel table(8, probing, search);
    for (const auto& [probe, key] : keys)
        table.cells()[table.slot(key, probe)] = {key.checksum, 2u | 99u << 16, 10u};
    return table;
}

TEST(EverySchedule, OneKeyGetsOneCell) {
    for (const HashProbing probing : kProbings) {
        const Schedules all(table_with(probing, 3, {}), {kA, kA, kA});
        EXPECT_EQ(all.sums(), (std::set<Sums>{{{11, {3, 6}}}}));
        EXPECT_EQ(all.failures(), std::set<int>{0});
    }
}

TEST(EverySchedule, KeysOfOneSlotComeApart) {
    for (const HashProbing probing : {HashProbing::linear, HashProbing::bucket}) {
        const Schedules all(table_with(probing, 3, {}), {kA, kB, kA, kC});
        EXPECT_EQ(all.sums(), (std::set<Sums>{{{11, {2, 4}}, {22, {1, 2}}, {33, {3, 4}}}}));
        EXPECT_EQ(all.failures(), std::set<int>{0});
        EXPECT_GT(all.ends(), 1) << "which key has which slot depends on the order";
    }
}

TEST(EverySchedule, AKeyBeyondAFreedSlotIsFound) {
    // The slots before it became free; taking one would make a second cell.
    for (const HashProbing probing : kProbings) {
        const Schedules all(table_with(probing, 4, {{3, kA}}), {kA, kB, kA});
        EXPECT_EQ(all.sums(), (std::set<Sums>{{{11, {2 + 2, 10 + 4}}, {22, {1, 2}}}}));
        EXPECT_EQ(all.failures(), std::set<int>{0});
    }
}

TEST(EverySchedule, AFullTableRefusesWithoutHarm) {
    // Room for one of A and B; D is there already, and stays as it was but for what is added.
    const Schedules all(table_with(HashProbing::linear, 2, {{0, kD}}), {kA, kB, kD, kB});
    const Sums with_a{{44, {2 + 2, 10 + 3}}, {11, {0, 1}}};
    const Sums with_b{{44, {2 + 2, 10 + 3}}, {22, {1 + 3, 2 + 4}}};
    EXPECT_EQ(all.sums(), (std::set<Sums>{with_a, with_b}));
    EXPECT_EQ(all.failures(), (std::set<int>{1, 2}));
}

TEST(TableModel, IsAMapWhateverTheOrderOfFrames) {
    // Against std::map over many frames of claims, sums and evictions.
    std::mt19937 random(6);
    for (const HashProbing probing : kProbings) {
        TableModel table(64, probing, 12);
        struct Entry {
            uint32_t hits = 0, samples = 0, used = 0;
        };
        std::map<uint32_t, Entry> expected;
        uint32_t frame = 0xFFFFFFC0u;
        int evicted = 0, failed = 0;
        for (int i = 0; i < 200; ++i, ++frame) {
            for (int k = 0; k < 20; ++k) {
                const uint32_t name = 1 + random() % 150;
                const HashedKey key{gpu::pcg_hash(name % 50), name}; // three to a home slot
                const uint32_t slot = table.find_or_claim(key);
                if (slot == gpu::kNoSlot) {
                    ++failed;
                    ASSERT_FALSE(expected.contains(name)) << "a key that is there is found";
                    continue;
                }
                table.flag(slot);
                table.take_time(slot);
                table.add_hits(slot, 1);
                table.add_samples(slot, 2);
                Entry& entry = expected[name];
                entry = {entry.hits + 1, entry.samples + 2, frame};
            }
            table.settle(frame, 5);
            evicted += static_cast<int>(
                std::erase_if(expected, [&](const auto& e) { return frame - e.second.used > 5; }));
            std::map<uint32_t, std::pair<uint32_t, uint32_t>> found, wanted;
            for (const gpu::Cell& cell : table.cells())
                if (cell.checksum != 0) {
                    ASSERT_FALSE(found.contains(cell.checksum));
                    found[cell.checksum] = {gpu::cell_hits(cell), gpu::cell_samples(cell)};
                }
            for (const auto& [name, entry] : expected)
                wanted[name] = {entry.hits, entry.samples};
            ASSERT_EQ(found, wanted) << "frame " << i;
        }
        EXPECT_GT(evicted, 50);
        EXPECT_GT(failed, 0);
    }
}

} // namespace
} // namespace romascope
