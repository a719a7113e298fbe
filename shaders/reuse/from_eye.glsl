// SPDX-License-Identifier: MIT
// Visible surfaces by their place relative to the eye, where differences keep their precision
// however far from 0 the camera stands.
//
// In, host: as shaders/common/surface.glsl
#include "shaders/common/surface.glsl"

/// 0 at the background.
float depth_of(ivec2 pixel) {
    float stored = texelFetch(gbuffer_depth, pixel, 0).x;
    return stored > 0.0 ? near_plane / stored : 0.0;
}

vec3 normal_of(ivec2 pixel) { return decode_direction(texelFetch(gbuffer_normal, pixel, 0).x); }

bool is_in_picture(ivec2 pixel) {
    return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, picture_size));
}
