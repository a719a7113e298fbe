// SPDX-License-Identifier: MIT
// Which cells are right for a surface point.
//
// The lookup is moved at random in the tangent plane, anew each frame: a pixel then averages over
// neighbouring cells. Its rays are not moved.
//
// Host: size_ratio: wanted size over the smallest, per metre from the eye, 0 for a fixed size;
//       inverse_smallest, 1/m; normal_bins; frame; jitter_key: a hashed seed; jitter_scale, cells;
//       blend_sizes 0 or 1
#include "shaders/common/random.h"
#include "shaders/common/surface.glsl"
#include "shaders/common/tangent_frame.glsl"
#include "shaders/reuse/spatial_hash/cell_key.h"
#include "shaders/reuse/spatial_hash/pixel_cells.h"

uniform float size_ratio;
uniform float inverse_smallest;
uniform float normal_bins;
uniform uint frame;
uniform uint jitter_key;
uniform float jitter_scale;
uniform int blend_sizes;

/// Wanted size over the smallest. By the distance from the eye, not the depth: turning the camera
/// changes no cell.
float wanted_ratio(Surface surface) { return size_ratio * distance(eye, surface.position); }

/// How much a pixel shows of the next larger cell; 0: it has none.
float larger_share(float ratio) {
    return blend_sizes != 0 ? rounded_weight(next_level_weight(ratio)) : 0.0;
}

/// How far the pixel's lookup is moved in this frame, in cells.
vec3 lookup_shift(ivec2 pixel, Surface surface) {
    uint first = pixel_hash(uvec2(pixel), jitter_key);
    uvec2 u = r2_sequence(frame, uvec2(first, pcg_hash(first)));
    vec2 jitter = jitter_scale * (2.0 * vec2(unit_float(u.x), unit_float(u.y)) - 1.0);
    return tangent_frame(surface.normal) * jitter;
}

/// `shift`: how far the point is moved for the lookup, in cells.
CellKey key_at(Surface surface, vec3 shift, int level) {
    float size = power_of_two(level) / inverse_smallest;
    return cell_key(surface.position + size * shift, surface.normal, level, inverse_smallest, normal_bins);
}
