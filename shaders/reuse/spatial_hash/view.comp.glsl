// SPDX-License-Identifier: MIT
// The table as seen from the camera: the cell that each pixel lies in, without jitter, or if there is
// none, that which the pixel used. Nothing is taken.
//
// In:   the G-buffer; the table of this frame, but for ages, which are shown before it
// Out:  picture RGBA32F, linear; the background is black, a surface without a cell dark red
// Host: see pixel_key.glsl and table.glsl; VIEW_HASH and VIEW_HASH_*; sample_cap; max_age
#include "shaders/reuse/spatial_hash/pixel_key.glsl"
#include "shaders/reuse/spatial_hash/table.glsl"

layout(local_size_x = 16, local_size_y = 8) in;
layout(rgba32f, binding = 0) writeonly uniform image2D picture;
uniform uint sample_cap;
uniform uint max_age;

/// From dark blue by green to yellow.
vec3 ramp(float x) {
    float t = clamp(x, 0.0, 1.0);
    return mix(mix(vec3(0.03, 0.02, 0.2), vec3(0.05, 0.45, 0.35), min(2.0 * t, 1.0)), vec3(1.0, 0.9, 0.2), max(2.0 * t - 1.0, 0.0));
}

/// The slot of the cell at a place, or kNoSlot.
uint slot_at(Surface surface, vec3 shift, int level) {
    CellKey key = key_at(surface, shift, level);
    return find_slot(home_hash(key), key_checksum(key));
}

/// The slot of the cell that the pixel uses in this frame, or else of the next larger one.
uint used_slot(ivec2 pixel, Surface surface) {
    vec3 shift = lookup_shift(pixel, surface);
    float ratio = wanted_ratio(surface);
    uint slot = slot_at(surface, shift, cell_level(ratio));
    if (slot == kNoSlot && larger_share(ratio) > 0.0)
        slot = slot_at(surface, shift, cell_level(ratio) + 1);
    return slot;
}

vec3 color_of(ivec2 pixel, Surface surface) {
#if VIEW_HASH == VIEW_HASH_FAILED
    return used_slot(pixel, surface) == kNoSlot ? vec3(1.0, 0.1, 0.05) : vec3(0.2);
#else
    uint slot = slot_at(surface, vec3(0.0), cell_level(wanted_ratio(surface)));
#if VIEW_HASH != VIEW_HASH_AGE
    if (slot == kNoSlot)
        slot = used_slot(pixel, surface);
#endif
    if (slot == kNoSlot)
        return vec3(0.25, 0.0, 0.02);
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
