// SPDX-License-Identifier: MIT
// Ends a frame in the table: sums of cells that were used become what is kept, cells that were not
// used for long are freed. Each slot is one invocation's.
//
// Out:  the table; hash_counts
// Host: see table.glsl; frame; max_age: frames without use before a cell is freed
#include "shaders/reuse/spatial_hash/table.glsl"

layout(local_size_x = 256) in;
layout(std430, binding = 3) buffer HashCounts { uint hash_counts[]; };
uniform uint frame;
uniform uint max_age;

shared uint group_counts[kHashCounts];

void settle(uint slot) {
    if (hash_checksums[slot] == 0u)
        return;
    Cell before = load_cell(slot);
    Cell cell = settled_cell(before, frame, max_age);
    if (cell != before)
        store_cell(slot, cell);
    if (cell.checksum == 0u) {
        atomicAdd(group_counts[kCountEvictions], 1u);
        return;
    }
    atomicAdd(group_counts[kCountCells], 1u);
    atomicAdd(group_counts[kCountSamples + samples_bin(cell_samples(cell))], 1u);
    atomicAdd(group_counts[kCountAges + age_bin(cell_age(cell, frame))], 1u);
}

void main() {
    uint index = gl_LocalInvocationIndex;
    if (index < uint(kHashCounts))
        group_counts[index] = 0u;
    barrier();
    uint invocations = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    for (uint slot = gl_GlobalInvocationID.x; slot <= slot_mask; slot += invocations)
        settle(slot);
    barrier();
    if (index < uint(kHashCounts) && group_counts[index] != 0u)
        atomicAdd(hash_counts[index], group_counts[index]);
}
