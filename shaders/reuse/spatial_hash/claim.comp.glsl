// SPDX-License-Identifier: MIT
// Finds the cell of each pixel, and the next larger one where sizes blend, or takes a free slot for
// it. Where the cells have enough, the pixel shows what they have; the others are listed, to trace.
//
// In:   the G-buffer, the table
// Out:  visibility, R16, of all pixels but those that are listed; background is 1
//       the list of pixels (list_pixels.glsl), and their pixel_cells, RG32UI (pixel_cells.h)
//       the table; hash_counts
// Host: see pixel_key.glsl, table.glsl, list_pixels.glsl; sample_cap: cells with so many take no
//       more; adding_stride: one pixel in so many may add, each in its turn, so that no sum overflows; the
//       others trace all the same;
//       RENEWS 0 or 1: whether cells may be stale, then see stale_cells.glsl
#include "shaders/estimators/list_pixels.glsl"
#include "shaders/reuse/spatial_hash/pixel_key.glsl"
#include "shaders/reuse/spatial_hash/table.glsl"
#if RENEWS
#include "shaders/reuse/spatial_hash/stale_cells.glsl"
#endif

layout(local_size_x = 16, local_size_y = 16) in;
layout(r16, binding = 0) writeonly uniform image2D visibility;
layout(rg32ui, binding = 1) writeonly uniform uimage2D pixel_cells;
layout(std430, binding = 3) buffer HashCounts { uint hash_counts[]; };
uniform uint sample_cap;
uniform uint adding_stride;

// Of the work group. What many pixels have in common is not counted, as each atomic waits for the
// others at its place.
shared uint group_counts[kPixelCounts];
shared uint group_first; ///< place of its first pixel in the list

struct UsedCell {
    uint slot; ///< kNoSlot if the table has no room
    uvec2 sums;
    bool stale; ///< it will be emptied, and has no sums
};

UsedCell used_cell(Surface surface, vec3 shift, int level) {
    CellKey key = key_at(surface, shift, level);
    FoundSlot found = find_or_claim(home_hash(key), key_checksum(key));
    if (found.claimed)
        atomicAdd(group_counts[kCountInsertions], 1u);
    if (found.probes > 1 && uint(found.probes) > group_counts[kCountProbes])
        atomicMax(group_counts[kCountProbes], uint(found.probes));
    UsedCell cell = UsedCell(found.slot, uvec2(0u), false);
    if (found.slot != kNoSlot) {
#if RENEWS
        cell.sums = use_unless_stale(found.slot, key, cell.stale);
#else
        cell.sums = use_cell(found.slot);
#endif
    }
    return cell;
}

/// True if the pixel traces; `words` are its cells then. Else its visibility is known.
bool traces(ivec2 pixel, out uvec2 words) {
    words = uvec2(0u);
    Surface surface = surface_at(pixel);
    if (surface.background) {
        atomicAdd(group_counts[kCountBackground], 1u);
        imageStore(visibility, pixel, vec4(1.0));
        return false;
    }
    vec3 shift = lookup_shift(pixel, surface);
    float ratio = wanted_ratio(surface);
    int level = cell_level(ratio);
    float weight = larger_share(ratio);
    UsedCell cell = used_cell(surface, shift, level);
    UsedCell larger = UsedCell(kNoSlot, uvec2(0u), false);
    if (weight > 0.0)
        larger = used_cell(surface, shift, level + 1);
    if (cell.slot == kNoSlot && larger.slot == kNoSlot)
        atomicAdd(group_counts[kCountFailed], 1u);

    bool wants = cell.slot != kNoSlot && cell.sums.y < sample_cap;
    bool larger_wants = larger.slot != kNoSlot && larger.sums.y < sample_cap;
    if (!wants && !larger_wants && cell.sums.y + larger.sums.y > 0u) {
        imageStore(visibility, pixel, vec4(1.0 - blended_hits(vec2(cell.sums), vec2(larger.sums), weight)));
        return false;
    }
    bool may_add = (uint(pixel.y * picture_size.x + pixel.x) + frame) % adding_stride == 0u;
    uint flags = (wants && may_add ? kCellTakes : 0u) | (larger_wants && may_add ? kLargerTakes : 0u);
    flags |= (cell.stale ? kCellStale : 0u) | (larger.stale ? kLargerStale : 0u);
    words = uvec2(packed_slot(cell.slot) | flags, packed_larger(larger.slot, weight));
    return true;
}

void main() {
    int index = int(gl_LocalInvocationIndex);
    if (index < kPixelCounts)
        group_counts[index] = 0u;
    barrier();
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    bool listed = false;
    uvec2 words = uvec2(0u);
    uint place = 0u;
    if (all(lessThan(pixel, picture_size)))
        listed = traces(pixel, words);
    if (listed)
        place = atomicAdd(group_counts[kCountTraced], 1u);
    barrier();
    if (index < kPixelCounts && group_counts[index] != 0u) {
        if (index == kCountTraced)
            group_first = extend_list(group_counts[index]);
        if (index == kCountProbes)
            atomicMax(hash_counts[index], group_counts[index]);
        else
            atomicAdd(hash_counts[index], group_counts[index]);
    }
    barrier();
    if (listed) {
        list_pixel(group_first + place, pixel);
        imageStore(pixel_cells, pixel, uvec4(words, 0u, 0u));
    }
}
