// SPDX-License-Identifier: MIT
// One iteration of an edge-avoiding a-trous wavelet transform (Dammertz et al. 2010): a 5 x 5 B-spline
// kernel with holes, over the pixels of the same surface.
//
// In:   the G-buffer, value
// Out:  filtered, R16
// Host: spacing: between the kernel's pixels; plane_limit: metres for a surface one unit deep;
//       normal_limit: a cosine
#include "shaders/reuse/edges.h"
#include "shaders/reuse/from_eye.glsl"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 5) uniform sampler2D value;
layout(r16, binding = 0) writeonly uniform image2D filtered;
uniform int spacing;
uniform float plane_limit;
uniform float normal_limit;

const float kSpline[3] = float[3](6.0 / 16.0, 4.0 / 16.0, 1.0 / 16.0);

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, picture_size)))
        return;
    float own = texelFetch(value, pixel, 0).x;
    float depth = depth_of(pixel);
    vec3 position = depth * view_ray(pixel);
    vec3 normal = normal_of(pixel);
    float total = kSpline[0] * kSpline[0];
    // Differences from its own value, so that what is constant stays so to the last bit.
    float sum = 0.0;
    for (int i = 0; i < 25; ++i) {
        ivec2 step = ivec2(i % 5 - 2, i / 5 - 2);
        ivec2 other = pixel + spacing * step;
        if (i == 12 || !is_in_picture(other))
            continue;
        float other_depth = depth_of(other);
        if (other_depth <= 0.0)
            continue;
        vec3 other_normal = normal_of(other);
        float distance = plane_distance(position, normal, other_depth * view_ray(other), other_normal);
        float weight = kSpline[abs(step.x)] * kSpline[abs(step.y)] *
                       edge_weight(distance, plane_limit * depth, dot(normal, other_normal), normal_limit);
        if (weight > 0.0) {
            sum += weight * (texelFetch(value, other, 0).x - own);
            total += weight;
        }
    }
    imageStore(filtered, pixel, vec4(own + sum / total));
}
