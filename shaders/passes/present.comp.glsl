// SPDX-License-Identifier: MIT
// A linear picture as the 8 bits that a PNG of it holds: clamped to [0, 1], sRGB, rounded to
// nearest, to the same bit as encode_srgb8 on the CPU. A pixel with NaN becomes magenta.
//
// In:   linear, one channel or four, of which alpha is left out; storage block 0: for each code the
//       smallest linear value that is encoded by it
// Out:  picture RGBA8, alpha 1
// Host: grey 0 or 1: one channel; picture_size
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform sampler2D linear;
layout(rgba8, binding = 0) writeonly uniform image2D picture;
layout(std430, binding = 0) readonly buffer Thresholds { float thresholds[256]; };
uniform int grey;
uniform ivec2 picture_size;

const vec3 kMagenta = vec3(1.0, 0.0, 1.0);

/// By its bits, as a compiler may take it that there is none.
bool is_nan(float x) { return (floatBitsToUint(x) & 0x7FFFFFFFu) > 0x7F800000u; }

/// pow is not rounded alike everywhere, so its result is a guess, off by at most one code.
float encoded(float x) {
    float bounded = clamp(x, 0.0, 1.0);
    float curve = bounded <= 0.0031308 ? 12.92 * bounded : 1.055 * pow(bounded, 1.0 / 2.4) - 0.055;
    int code = clamp(int(curve * 255.0 + 0.5), 0, 255);
    if (code < 255 && x >= thresholds[code + 1])
        ++code;
    else if (code > 0 && x < thresholds[code])
        --code;
    return float(code) / 255.0;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, picture_size)))
        return;
    vec3 color = texelFetch(linear, pixel, 0).rgb;
    vec3 shown;
    if (grey != 0)
        shown = is_nan(color.r) ? kMagenta : vec3(encoded(color.r));
    else if (is_nan(color.r) || is_nan(color.g) || is_nan(color.b))
        shown = kMagenta;
    else
        shown = vec3(encoded(color.r), encoded(color.g), encoded(color.b));
    imageStore(picture, pixel, vec4(shown, 1.0));
}
