// SPDX-License-Identifier: MIT
// Holds the long history to the fast one: by how much the long mean lags is the mean difference
// between the two over the 3 x 3 pixels of the same surface. Where that is more than noise explains,
// the long mean is moved by what is too much, and its frames count for less.
//
// In:   the G-buffer, accumulated: see temporal_accumulation.comp.glsl
// Out:  history, RGBA32F: the same, clamped; result, R16: its mean
// Host: CLAMPED 0 or 1; deviations: how many standard deviations are noise; fastest: frames;
//       plane_limit: metres for a surface one unit deep; normal_limit: a cosine
#include "shaders/reuse/edges.h"
#include "shaders/reuse/from_eye.glsl"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 5) uniform sampler2D accumulated;
layout(rgba32f, binding = 0) writeonly uniform image2D history;
layout(r16, binding = 1) writeonly uniform image2D result;
uniform float deviations;
uniform float fastest;
uniform float plane_limit;
uniform float normal_limit;

/// The share of noise that neighbours have in common, as they look at the same candidate
/// directions: on the hall's floor, a quarter of the deviation, so a sixteenth of the variance.
const float kCommonVariance = 1.0 / 16.0;

float variance_of(vec4 h) { return max(h.z - h.x * h.x, 0.0); }

vec4 clamped(ivec2 pixel, vec4 h) {
    float depth = depth_of(pixel);
    if (depth <= 0.0)
        return h;
    vec3 position = depth * view_ray(pixel);
    vec3 normal = normal_of(pixel);
    float lag = 0.0;
    float variance = 0.0;
    float count = 0.0;
    for (int i = 0; i < 9; ++i) {
        ivec2 other = pixel + ivec2(i % 3 - 1, i / 3 - 1);
        float other_depth = is_in_picture(other) ? depth_of(other) : 0.0;
        if (other_depth <= 0.0)
            continue;
        vec3 other_normal = normal_of(other);
        float distance = plane_distance(position, normal, other_depth * view_ray(other), other_normal);
        if (edge_weight(distance, plane_limit * depth, dot(normal, other_normal), normal_limit) <= 0.0)
            continue;
        vec4 o = texelFetch(accumulated, other, 0);
        lag += o.y - o.x;
        variance += variance_of(o);
        count += 1.0;
    }
    if (count == 0.0)
        return h; // a normal that is none
    lag /= count;
    variance /= count;
    // Of an exponential mean with this weight: weight / (2 - weight) of a frame's variance.
    float weight = 1.0 / min(h.w, fastest);
    float noise = sqrt((1.0 / count + kCommonVariance) * variance * weight / (2.0 - weight));
    float excess = abs(lag) - deviations * noise;
    if (!(excess > 0.0))
        return h;
    float kept = 1.0 - excess / abs(lag);
    float mean = clamp(h.x + sign(lag) * excess, 0.0, 1.0);
    float frames = min(h.w, max(fastest, h.w * kept * kept));
    return vec4(mean, h.y, mean * mean + kept * variance_of(h), frames);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, picture_size)))
        return;
    vec4 h = texelFetch(accumulated, pixel, 0);
#if CLAMPED
    h = clamped(pixel, h);
#endif
    imageStore(history, pixel, h);
    imageStore(result, pixel, vec4(h.x));
}
