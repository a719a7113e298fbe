// SPDX-License-Identifier: MIT
// Temporal antialiasing of the picture: its history is fetched where the nearest surface of the 3 x 3
// pixels was in the previous frame, by a Catmull-Rom kernel, held to what the neighbourhood of the
// pixel has now (mean and deviations, in YCoCg of linear light), and mixed with the new picture.
//
// In:   the G-buffer, the previous frame's surfaces, picture: one channel or three; history: as left
// Out:  antialiased, RGBA32F: the colour, frames in it; with SINGLE_CHANNEL besides result, R32F
// Host: see previous_surface.glsl; has_history 0 or 1; longest: frames, at least 1; deviations: of the
//       neighbourhood that history may have; SINGLE_CHANNEL 0 or 1
#include "shaders/reuse/previous_surface.glsl"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 5) uniform sampler2D picture;
layout(binding = 6) uniform sampler2D history;
layout(rgba32f, binding = 0) writeonly uniform image2D antialiased;
#if SINGLE_CHANNEL
layout(r32f, binding = 1) writeonly uniform image2D result;
#endif
uniform int has_history;
uniform float longest;
uniform float deviations;

vec3 color_at(ivec2 pixel) {
    vec4 texel = texelFetch(picture, clamp(pixel, ivec2(0), picture_size - 1), 0);
#if SINGLE_CHANNEL
    return texel.xxx;
#else
    return texel.rgb;
#endif
}

vec3 to_ycocg(vec3 c) { return vec3(dot(c, vec3(0.25, 0.5, 0.25)), 0.5 * (c.r - c.b), 0.5 * c.g - 0.25 * (c.r + c.b)); }
vec3 from_ycocg(vec3 c) { return vec3(c.x + c.y - c.z, c.x + c.z, c.x - c.y - c.z); }

/// The pixel of the 3 x 3 whose surface is nearest, the background last: an edge moves with what is
/// in front.
ivec2 nearest_surface(ivec2 pixel) {
    ivec2 found = pixel;
    float largest = texelFetch(gbuffer_depth, pixel, 0).x;
    for (int i = 0; i < 9; ++i) {
        ivec2 other = clamp(pixel + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), picture_size - 1);
        float stored = texelFetch(gbuffer_depth, other, 0).x;
        if (stored > largest) {
            largest = stored;
            found = other;
        }
    }
    return found;
}

bool was_seen(Before b) {
    ivec2 nearest = ivec2(floor(b.place + 0.5));
    for (int i = 0; i < 9; ++i)
        if (showed(b, nearest + ivec2(i % 3 - 1, i / 3 - 1)))
            return true;
    return false;
}

vec4 catmull_rom(float t) {
    return vec4(((-0.5 * t + 1.0) * t - 0.5) * t, (1.5 * t - 2.5) * t * t + 1.0,
                ((-1.5 * t + 2.0) * t + 0.5) * t, (0.5 * t - 0.5) * t * t);
}

/// The colour, and the least of the frames in the four pixels about the place.
vec4 history_at(vec2 place) {
    ivec2 corner = ivec2(floor(place));
    vec2 share = place - vec2(corner);
    vec4 across = catmull_rom(share.x);
    vec4 down = catmull_rom(share.y);
    vec3 sum = vec3(0.0);
    float frames = longest;
    for (int i = 0; i < 16; ++i) {
        ivec2 step = ivec2(i & 3, i >> 2);
        float weight = across[step.x] * down[step.y];
        if (weight == 0.0)
            continue;
        vec4 texel = texelFetch(history, clamp(corner + step - 1, ivec2(0), picture_size - 1), 0);
        sum += weight * texel.rgb;
        if (step.x == 1 || step.x == 2)
            if (step.y == 1 || step.y == 2)
                frames = min(frames, texel.w);
    }
    return vec4(sum, frames);
}

/// Moved towards the middle of what the neighbourhood has until it is within.
vec3 held_to_neighbours(ivec2 pixel, vec3 color) {
    vec3 sum = vec3(0.0);
    vec3 squares = vec3(0.0);
    for (int i = 0; i < 9; ++i) {
        vec3 c = to_ycocg(color_at(pixel + ivec2(i % 3 - 1, i / 3 - 1)));
        sum += c;
        squares += c * c;
    }
    vec3 mean = sum / 9.0;
    vec3 allowed = deviations * sqrt(max(squares / 9.0 - mean * mean, 0.0)) + 1e-6;
    vec3 away = to_ycocg(color) - mean;
    vec3 parts = abs(away) / allowed;
    float most = max(max(parts.x, parts.y), max(parts.z, 1.0));
    return from_ycocg(mean + away / most);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, picture_size)))
        return;
    vec3 current = color_at(pixel);
    vec4 outcome = vec4(current, 1.0);
    ivec2 guide = nearest_surface(pixel);
    Before b = before(guide);
    if (has_history != 0 && b.seen && was_seen(b)) {
        vec2 place = b.place + vec2(pixel - guide);
        if (all(greaterThanEqual(place, vec2(-0.5))) && all(lessThanEqual(place, vec2(picture_size) - 0.5))) {
            vec4 old = history_at(place);
            float count = min(old.w + 1.0, longest);
            vec3 held = held_to_neighbours(pixel, old.rgb);
            outcome = vec4(max(held + (current - held) / count, 0.0), count);
        }
    }
    imageStore(antialiased, pixel, outcome);
#if SINGLE_CHANNEL
    imageStore(result, pixel, outcome);
#endif
}
