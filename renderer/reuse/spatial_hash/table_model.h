// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/reuse/spatial_hash/hash_knobs.h"
#include "shaders/reuse/spatial_hash/cell_state.h"
#include "shaders/reuse/spatial_hash/search.h"

#include <cstdint>
#include <vector>

namespace romascope {

/// What finds a key in the table and tells it from others.
struct HashedKey {
    uint32_t hash = 0;
    uint32_t checksum = 0; ///< not 0
    friend bool operator==(const HashedKey&, const HashedKey&) = default;
};

/// CPU model of the table of the spatial hash: the accesses to memory that table.glsl makes, each
/// by itself, so that a test can put those of many invocations in any order.
class TableModel {
public:
    /// `capacity`: slots, a power of two of at least gpu::kBucketSlots.
    TableModel(uint32_t capacity, HashProbing probing, int search_count);

    uint32_t slot(const HashedKey& key, int probe) const;
    int search_count() const { return search_count_; }

    /// One access of a search. `load`: what a load sees, in place of the slot as it is: an
    /// invocation may see it as it was before the pass.
    gpu::Search step(const gpu::Search& search, const HashedKey& key);
    gpu::Search step(const gpu::Search& search, const HashedKey& key, uint32_t load) const;

    // What use_cell() stores, word by word, and the two accesses of add_to_cell().
    void flag(uint32_t slot) { cells_[slot].samples |= gpu::kInUse; }
    void take_time(uint32_t slot) { cells_[slot].hits &= gpu::kHitsMask; }
    void add_hits(uint32_t slot, uint32_t hits) { cells_[slot].hits += hits; }
    void add_samples(uint32_t slot, uint32_t samples) { cells_[slot].samples += samples; }

    /// Ends a frame, slot by slot.
    void settle(uint32_t frame, uint32_t max_age);

    /// A whole search without others in between: gpu::kNoSlot if there is no room.
    uint32_t find_or_claim(const HashedKey& key);

    std::vector<gpu::Cell>& cells() { return cells_; }
    const std::vector<gpu::Cell>& cells() const { return cells_; }

private:
    std::vector<gpu::Cell> cells_;
    int probing_;
    int search_count_;
};

} // namespace romascope
