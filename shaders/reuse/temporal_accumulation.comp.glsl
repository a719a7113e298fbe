// SPDX-License-Identifier: MIT
// Mean of a value over frames along the way of each surface: history is fetched where the surface was
// in the previous frame, from those of the four nearest pixels that showed it, else from those of
// nine that did.
//
// In:   the G-buffer, the previous frame's surfaces, value, history: as `accumulated` was left
// Out:  accumulated, RGBA32F: mean over at most `longest` frames, mean over at most `fastest`, mean
//       of squares over `longest`, frames in the mean
// Host: see previous_surface.glsl; has_history 0 or 1; longest, fastest: frames, at least 1
#include "shaders/reuse/previous_surface.glsl"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 5) uniform sampler2D value;
layout(binding = 6) uniform sampler2D history;
layout(rgba32f, binding = 0) writeonly uniform image2D accumulated;
uniform int has_history;
uniform float longest;
uniform float fastest;

vec4 history_of(Before b) {
    ivec2 corner = ivec2(floor(b.place));
    vec2 share = b.place - vec2(corner);
    vec4 sum = vec4(0.0);
    float total = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 step = ivec2(i & 1, i >> 1);
        vec2 sides = mix(1.0 - share, share, equal(step, ivec2(1)));
        float weight = sides.x * sides.y;
        if (weight > 0.0 && showed(b, corner + step)) {
            sum += weight * texelFetch(history, corner + step, 0);
            total += weight;
        }
    }
    if (total > 0.0)
        return sum / total;
    ivec2 nearest = ivec2(floor(b.place + 0.5));
    for (int i = 0; i < 9; ++i) {
        ivec2 pixel = nearest + ivec2(i % 3 - 1, i / 3 - 1);
        if (showed(b, pixel)) {
            sum += texelFetch(history, pixel, 0);
            total += 1.0;
        }
    }
    return total > 0.0 ? sum / total : vec4(0.0);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, picture_size)))
        return;
    float current = texelFetch(value, pixel, 0).x;
    Before b = before(pixel);
    vec4 old = has_history != 0 && b.seen ? history_of(b) : vec4(0.0);
    float count = min(old.w + 1.0, longest);
    vec3 counts = vec3(count, min(count, fastest), count);
    vec3 means = old.xyz + (vec3(current, current, current * current) - old.xyz) / counts;
    imageStore(accumulated, pixel, vec4(means, count));
}
