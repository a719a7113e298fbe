// SPDX-License-Identifier: MIT
// The table of the spatial hash on the GPU.
//
// Host: storage blocks 0 checksums, 1 hits, 2 samples, one word a slot each (cell_state.h);
//       HASH_PROBING and HASH_PROBING_*; slot_mask: slots - 1; search_count
#include "shaders/reuse/spatial_hash/cell_state.h"
#include "shaders/reuse/spatial_hash/search.h"

layout(std430, binding = 0) buffer HashChecksums { uint hash_checksums[]; };
layout(std430, binding = 1) buffer HashHits { uint hash_hits[]; };
layout(std430, binding = 2) buffer HashSamples { uint hash_samples[]; };
uniform uint slot_mask;
uniform int search_count;

Cell load_cell(uint slot) { return Cell(hash_checksums[slot], hash_hits[slot], hash_samples[slot]); }

void store_cell(uint slot, Cell cell) {
    hash_checksums[slot] = cell.checksum;
    hash_hits[slot] = cell.hits;
    hash_samples[slot] = cell.samples;
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

/// Marks the cell as used in this frame. Any number may do it at once: both changes are the same
/// again.
void use_cell(uint slot) {
    if ((hash_samples[slot] & kInUse) == 0u) {
        atomicOr(hash_samples[slot], kInUse);
        atomicAnd(hash_hits[slot], kHitsMask);
    }
}

/// Adds to a cell that is in use.
void add_to_cell(uint slot, uint hits, uint samples) {
    if (hits > 0u)
        atomicAdd(hash_hits[slot], hits);
    atomicAdd(hash_samples[slot], samples);
}
