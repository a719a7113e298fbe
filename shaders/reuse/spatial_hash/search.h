// SPDX-License-Identifier: MIT
// Looking for a key in the table, or for a slot to put it in, one memory access at a time: the
// shaders and the CPU model of the table make the same accesses in the same order.
//
// Why a key gets one slot, however many ask for it at once: in the pass that claims, slots only go
// from free to taken. All who look for a key pass the same slots in the same order. If it was in
// the table before, all find it, as the whole sequence is looked at before anything is claimed. If
// not, two can claim only the first slot of the sequence that is free; who comes second sees the
// key there. Slots that were passed over were taken by other keys and stay so. What is only read
// may even be out of date: a slot taken since still looks free, and the exchange then shows who has
// it.
#pragma once
#include "shaders/common/cross.h"
#include "shaders/common/random.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

const uint kNoSlot = 0xFFFFFFFFu;

// As romascope::HashProbing.
const int kProbeLinear = 0;
const int kProbeRehash = 1;
const int kProbeBucket = 2;
/// Slots whose checksums share 32 bytes: what a GPU fetches at once.
const uint kBucketSlots = 8u;

/// The slot of the `probe`-th look, from 0, of a key with this hash, in a table of `mask` + 1
/// slots, a power of two of at least kBucketSlots. Linear: from the home slot on, around the
/// table's end; rehash: anew for each; bucket: around within the home slot's bucket, then in the
/// bucket of another hash.
SHARED_FN uint probe_slot(uint hash, int probe, int probing, uint mask) {
    uint step = uint(probe);
    if (probing == kProbeLinear)
        return (hash + step) & mask;
    if (probing == kProbeRehash)
        return (probe == 0 ? hash : pcg_hash(hash + step)) & mask;
    uint bucket = step / kBucketSlots;
    uint home = bucket == 0u ? hash : pcg_hash(hash + bucket);
    return ((home & ~(kBucketSlots - 1u)) | ((home + step) & (kBucketSlots - 1u))) & mask;
}

const int kSearchGoesOn = 0;
const int kSearchFound = 1;   ///< the slot of the last access has the key
const int kSearchClaimed = 2; ///< likewise, and has it from this search
const int kSearchFailed = 3;  ///< no slot

struct Search {
    int probe;      ///< of the next access
    int first_free; ///< the first probe that saw a free slot, or -1
    int claims;     ///< 1: accesses are exchanges of 0 with the key's checksum, else loads
    int state;
};

SHARED_FN Search search_begin() {
    Search search;
    search.probe = 0;
    search.first_free = -1;
    search.claims = 0;
    search.state = kSearchGoesOn;
    return search;
}

/// `seen`: the checksum that the access found in the slot. `count`: how many slots are looked at.
SHARED_FN Search search_next(Search search, uint seen, uint checksum, int count) {
    if (seen == checksum) {
        search.state = kSearchFound;
    } else if (search.claims == 1) {
        if (seen == 0u) {
            search.state = kSearchClaimed;
        } else {
            ++search.probe;
            if (search.probe == count)
                search.state = kSearchFailed;
        }
    } else {
        if (seen == 0u && search.first_free < 0)
            search.first_free = search.probe;
        ++search.probe;
        if (search.probe == count) {
            search.claims = 1;
            search.probe = search.first_free;
            if (search.first_free < 0)
                search.state = kSearchFailed;
        }
    }
    return search;
}

/// More accesses than any search makes.
SHARED_FN int search_limit(int count) { return 2 * count; }

#ifdef __cplusplus
} // namespace romascope::gpu
#endif
