// SPDX-License-Identifier: MIT
// The table as seen from the camera: the cell that each pixel lies in, without jitter, or if there is
// none, that which the pixel used. Nothing is taken.
//
// In:   the G-buffer; the table; pixel_cells of this frame, but for ages, which are shown before it
// Out:  picture RGBA32F, linear; the background is black, a surface without a cell dark red
// Host: see pixel_key.glsl and table.glsl; VIEW_HASH and VIEW_HASH_*; frame; sample_cap; max_age
#include "shaders/reuse/spatial_hash/pixel_cells.h"
#include "shaders/reuse/spatial_hash/pixel_key.glsl"
#include "shaders/reuse/spatial_hash/table.glsl"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 2) uniform usampler2D pixel_cells;
layout(rgba32f, binding = 0) writeonly uniform image2D picture;
uniform uint frame;
uniform uint sample_cap;
uniform uint max_age;

/// From dark blue by green to yellow.
vec3 ramp(float x) {
    float t = clamp(x, 0.0, 1.0);
    return mix(mix(vec3(0.03, 0.02, 0.2), vec3(0.05, 0.45, 0.35), min(2.0 * t, 1.0)), vec3(1.0, 0.9, 0.2), max(2.0 * t - 1.0, 0.0));
}

vec3 color_of(ivec2 pixel, Surface surface) {
    const vec3 kNothing = vec3(0.25, 0.0, 0.02);
    uvec2 words = texelFetch(pixel_cells, pixel, 0).xy;
#if VIEW_HASH == VIEW_HASH_FAILED
    bool failed = (words.x & kSlotBits) == 0u && (words.y & kSlotBits) == 0u;
    return failed ? vec3(1.0, 0.1, 0.05) : vec3(0.2);
#else
    CellKey key = key_at(surface, vec3(0.0), cell_level(wanted_ratio(surface)));
    uint slot = find_slot(home_hash(key), key_checksum(key));
#if VIEW_HASH != VIEW_HASH_AGE
    if (slot == kNoSlot)
        slot = unpacked_slot((words.x & kSlotBits) != 0u ? words.x : words.y);
#endif
    if (slot == kNoSlot)
        return kNothing;
    Cell cell = load_cell(slot);
#if VIEW_HASH == VIEW_HASH_CELL
    uvec3 color = uvec3(cell.checksum, cell.checksum >> 8, cell.checksum >> 16) & 255u;
    return mix(vec3(0.1), vec3(1.0), vec3(color) / 255.0);
#elif VIEW_HASH == VIEW_HASH_SAMPLES
    return ramp(float(cell_samples(cell)) / float(sample_cap));
#else
    return ramp(float(cell_age(cell, frame)) / float(max_age));
#endif
#endif
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, picture_size)))
        return;
    Surface surface = surface_at(pixel);
    imageStore(picture, pixel, vec4(surface.background ? vec3(0.0) : color_of(pixel, surface), 1.0));
}
