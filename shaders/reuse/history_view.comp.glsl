// SPDX-License-Identifier: MIT
// How many frames each pixel's history has: black for one, white for the longest; blue where there is
// none, which is the background, or all of it without temporal accumulation.
//
// In:   the G-buffer, history: see temporal_accumulation.comp.glsl
// Out:  picture, RGBA32F, linear
// Host: has_history 0 or 1; longest: frames
#include "shaders/common/surface.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 5) uniform sampler2D history;
layout(rgba32f, binding = 0) writeonly uniform image2D picture;
uniform int has_history;
uniform float longest;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, picture_size)))
        return;
    vec3 color = vec3(0.02, 0.05, 0.2);
    if (has_history != 0 && texelFetch(gbuffer_depth, pixel, 0).x > 0.0)
        color = vec3((texelFetch(history, pixel, 0).w - 1.0) / max(longest - 1.0, 1.0));
    imageStore(picture, pixel, vec4(color, 1.0));
}
