// SPDX-License-Identifier: MIT
// Finds the cell of each pixel, and the next larger one where sizes blend, or takes a free slot for
// it; decides whether the pixel's rays are needed.
//
// The lookup is moved at random in the tangent plane, anew each frame: a pixel then averages over
// neighbouring cells. Its rays are not moved.
//
// In:   the G-buffer, the table
// Out:  pixel_cells, RG32UI (pixel_cells.h); the table; hash_counts
// Host: see pixel_key.glsl and table.glsl; frame; jitter_key: a hashed seed; jitter_scale, cells;
//       blend_sizes 0 or 1; sample_cap: cells with so many take no more; adding_stride: one pixel in
//       so many may add, each in its turn, so that no sum overflows
#include "shaders/common/random.h"
#include "shaders/common/tangent_frame.glsl"
#include "shaders/reuse/spatial_hash/pixel_cells.h"
#include "shaders/reuse/spatial_hash/pixel_key.glsl"
#include "shaders/reuse/spatial_hash/table.glsl"

layout(local_size_x = 16, local_size_y = 8) in;
layout(rg32ui, binding = 0) writeonly uniform uimage2D pixel_cells;
layout(std430, binding = 3) buffer HashCounts { uint hash_counts[]; };
uniform uint frame;
uniform uint jitter_key;
uniform float jitter_scale;
uniform int blend_sizes;
uniform uint sample_cap;
uniform uint adding_stride;

shared uint group_counts[kPixelCounts];

/// Slot of a level, in use from now on; kNoSlot if the table has no room.
uint claimed_slot(Surface surface, vec3 shift, int level) {
    CellKey key = key_at(surface, shift, level);
    FoundSlot found = find_or_claim(home_hash(key), key_checksum(key));
    if (found.slot != kNoSlot)
        use_cell(found.slot);
    if (found.claimed)
        atomicAdd(group_counts[kCountInsertions], 1u);
    atomicMax(group_counts[kCountProbes], uint(found.probes));
    return found.slot;
}

uvec2 cells_of(ivec2 pixel) {
    Surface surface = surface_at(pixel);
    if (surface.background)
        return uvec2(0u);
    uint first = pixel_hash(uvec2(pixel), jitter_key);
    uvec2 u = r2_sequence(frame, uvec2(first, pcg_hash(first)));
    vec2 jitter = jitter_scale * (2.0 * vec2(unit_float(u.x), unit_float(u.y)) - 1.0);
    vec3 shift = tangent_frame(surface.normal) * jitter;

    float ratio = wanted_ratio(surface);
    int level = cell_level(ratio);
    uint slot = claimed_slot(surface, shift, level);
    uint larger_slot = kNoSlot;
    float weight = blend_sizes != 0 ? next_level_weight(ratio) : 0.0;
    if (packed_larger(kNoSlot, weight) != 0u)
        larger_slot = claimed_slot(surface, shift, level + 1);

    uint samples = slot == kNoSlot ? 0u : hash_samples[slot] & kSamplesMask;
    uint larger_samples = larger_slot == kNoSlot ? 0u : hash_samples[larger_slot] & kSamplesMask;
    bool may_add = (uint(pixel.y * picture_size.x + pixel.x) + frame) % adding_stride == 0u;
    bool takes = may_add && slot != kNoSlot && samples < sample_cap;
    bool larger_takes = may_add && larger_slot != kNoSlot && larger_samples < sample_cap;
    bool traces = takes || larger_takes || samples + larger_samples == 0u;

    atomicAdd(group_counts[kCountSurfaces], 1u);
    if (traces)
        atomicAdd(group_counts[kCountTraced], 1u);
    if (slot == kNoSlot && larger_slot == kNoSlot)
        atomicAdd(group_counts[kCountFailed], 1u);
    uint flags = kSeesSurface | (traces ? kTraceBit : 0u) | (takes ? kCellTakes : 0u) | (larger_takes ? kLargerTakes : 0u);
    return uvec2(packed_slot(slot) | flags, packed_larger(larger_slot, weight));
}

void main() {
    int index = int(gl_LocalInvocationIndex);
    if (index < kPixelCounts)
        group_counts[index] = 0u;
    barrier();
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(pixel, picture_size)))
        imageStore(pixel_cells, pixel, uvec4(cells_of(pixel), 0u, 0u));
    barrier();
    if (index < kPixelCounts && group_counts[index] != 0u) {
        if (index == kCountProbes)
            atomicMax(hash_counts[index], group_counts[index]);
        else
            atomicAdd(hash_counts[index], group_counts[index]);
    }
}
