// SPDX-License-Identifier: MIT
// Ends a frame in the table: sums of cells that were used become what is kept, cells that were not
// used for long are freed. Each slot is one invocation's, which has kSettledEach of them.
//
// Out:  the table; hash_counts
// Host: see table.glsl; frame; max_age: frames without use before a cell is freed
#include "shaders/reuse/spatial_hash/table.glsl"

layout(local_size_x = 256) in;
layout(std430, binding = 3) buffer HashCounts { uint hash_counts[]; };
uniform uint frame;
uniform uint max_age;

// Most cells fall in the same bins. An invocation counts in its own words first, kBinBits for a bin,
// and neighbours then add at different places.
const uint kBinBits = 5u;
const uint kCopies = 16u;
shared uint group_counts[kCopies * uint(kHashCounts)];

struct Bins {
    uint samples;
    uint ages;
    uint evictions;
};

Bins settle(uint slot, Bins bins) {
    Cell before = load_cell(slot);
    Cell cell = settled_cell(before, frame, max_age);
    if (cell.hits != before.hits || cell.samples != before.samples)
        hash_sums[slot] = uvec2(cell.hits, cell.samples);
    if (cell.checksum == 0u) {
        hash_checksums[slot] = 0u;
        ++bins.evictions;
        return bins;
    }
    bins.samples += 1u << (kBinBits * uint(samples_bin(cell_samples(cell))));
    bins.ages += 1u << (kBinBits * uint(age_bin(cell_age(cell, frame))));
    return bins;
}

void count(int place, uint number) {
    if (number > 0u)
        atomicAdd(group_counts[(gl_LocalInvocationIndex % kCopies) * uint(kHashCounts) + uint(place)], number);
}

void main() {
    uint index = gl_LocalInvocationIndex;
    for (uint i = index; i < kCopies * uint(kHashCounts); i += gl_WorkGroupSize.x)
        group_counts[i] = 0u;
    barrier();
    uint first = gl_WorkGroupID.x * gl_WorkGroupSize.x * kSettledEach + index;
    // These loads all begin before the first is waited for.
    uint checksums[kSettledEach];
    for (uint i = 0u; i < kSettledEach; ++i)
        checksums[i] = hash_checksums[(first + i * gl_WorkGroupSize.x) & slot_mask];
    Bins bins = Bins(0u, 0u, 0u);
    for (uint i = 0u; i < kSettledEach; ++i) {
        uint slot = first + i * gl_WorkGroupSize.x;
        if (slot <= slot_mask && checksums[i] != 0u)
            bins = settle(slot, bins);
    }
    count(kCountEvictions, bins.evictions);
    if (bins.samples != 0u) {
        for (int bin = 0; bin < kHistogramBins; ++bin) {
            uint mask = (1u << kBinBits) - 1u;
            uint samples = (bins.samples >> (kBinBits * uint(bin))) & mask;
            count(kCountCells, samples);
            count(kCountSamples + bin, samples);
            count(kCountAges + bin, (bins.ages >> (kBinBits * uint(bin))) & mask);
        }
    }
    barrier();
    if (index < uint(kHashCounts)) {
        uint sum = 0u;
        for (uint copy = 0u; copy < kCopies; ++copy)
            sum += group_counts[copy * uint(kHashCounts) + index];
        if (sum != 0u)
            atomicAdd(hash_counts[index], sum);
    }
}
