// SPDX-License-Identifier: MIT
// The table of the spatial hash without a GPU: its model under every order of its accesses, and
// over many frames.
#include "renderer/reuse/spatial_hash/table_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace romascope {
namespace {

constexpr HashProbing kProbings[] = {HashProbing::linear, HashProbing::rehash, HashProbing::bucket};

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
