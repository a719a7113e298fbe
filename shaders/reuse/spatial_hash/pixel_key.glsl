// SPDX-License-Identifier: MIT
// Which cells are right for a surface point.
//
// Host: size_ratio: wanted size over the smallest, per metre from the eye, 0 for a fixed size;
//       inverse_smallest, 1/m; normal_bins
#include "shaders/common/surface.glsl"
#include "shaders/reuse/spatial_hash/cell_key.h"

uniform float size_ratio;
uniform float inverse_smallest;
uniform float normal_bins;

/// Wanted size over the smallest. By the distance from the eye, not the depth: turning the camera
/// changes no cell.
float wanted_ratio(Surface surface) { return size_ratio * distance(eye, surface.position); }

/// `shift`: how far the point is moved for the lookup, in cells.
CellKey key_at(Surface surface, vec3 shift, int level) {
    float size = power_of_two(level) / inverse_smallest;
    return cell_key(surface.position + size * shift, surface.normal, level, inverse_smallest, normal_bins);
}
