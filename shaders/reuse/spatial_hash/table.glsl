// SPDX-License-Identifier: MIT
// The table of the spatial hash on the GPU.
//
// Host: storage blocks 0 checksums, a word a slot, 1 sums, two words a slot: hits, samples
//       (cell_state.h). Checksums lie by themselves, as a search looks at many; sums are read at once.
//       HASH_PROBING and HASH_PROBING_*; slot_mask: slots - 1; search_count
#include "shaders/reuse/spatial_hash/cell_state.h"
#include "shaders/reuse/spatial_hash/search.h"

layout(std430, binding = 0) buffer HashChecksums { uint hash_checksums[]; };
layout(std430, binding = 1) buffer HashSums { uvec2 hash_sums[]; };
uniform uint slot_mask;
uniform int search_count;

Cell load_cell(uint slot) {
    uvec2 sums = hash_sums[slot];
    return Cell(hash_checksums[slot], sums.x, sums.y);
}

struct FoundSlot {
    uint slot; ///< kNoSlot if there is none
    bool claimed;
    int probes; ///< slots from the first to this one, or all
};

/// The slot with this key; a free one that is taken for it, if there is none.
FoundSlot find_or_claim(uint hash, uint checksum) {
    Search search = search_begin();
    uint slot = 0u;
    int limit = search_limit(search_count);
    for (int i = 0; i < limit; ++i) {
        slot = probe_slot(hash, search.probe, HASH_PROBING, slot_mask);
        uint seen = search.claims == 1 ? atomicCompSwap(hash_checksums[slot], 0u, checksum) : hash_checksums[slot];
        search = search_next(search, seen, checksum, search_count);
        if (search.state != kSearchGoesOn)
            break;
    }
    bool has_slot = search.state == kSearchFound || search.state == kSearchClaimed;
    return FoundSlot(has_slot ? slot : kNoSlot, search.state == kSearchClaimed,
                     has_slot ? search.probe + 1 : search_count);
}

/// The slot with this key, or kNoSlot.
uint find_slot(uint hash, uint checksum) {
    for (int probe = 0; probe < search_count; ++probe) {
        uint slot = probe_slot(hash, probe, HASH_PROBING, slot_mask);
        if (hash_checksums[slot] == checksum)
            return slot;
    }
    return kNoSlot;
}

/// Marks the cell as used in this frame; its sums before, hits and samples. Any number may do it at
/// once: in the pass that claims nothing else changes these words, so that all store the same.
uvec2 use_cell(uint slot) {
    uvec2 sums = hash_sums[slot];
    uvec2 used = used_sums(sums);
    if (used != sums)
        hash_sums[slot] = used;
    return uvec2(used.x, used.y & kSamplesMask);
}

/// Likewise, after emptying a cell that was not used in this frame. True for one of all who do it.
bool renew_cell(uint slot) {
    if ((hash_sums[slot].y & kInUse) != 0u)
        return false;
    bool first = (atomicExchange(hash_sums[slot].y, kInUse) & kInUse) == 0u;
    atomicAnd(hash_sums[slot].x, 0u);
    return first;
}

/// Adds to a cell that is in use.
void add_to_cell(uint slot, uint hits, uint samples) {
    if (hits > 0u)
        atomicAdd(hash_sums[slot].x, hits);
    atomicAdd(hash_sums[slot].y, samples);
}
