// SPDX-License-Identifier: MIT
// The scene's materials and textures, as GpuSurfaces::bind leaves them.
//
// In:   storage blocks 0: MaterialRecord per material; 1: the texels of all textures, RGBA8 with red
//       in the lowest byte, colour encoded as sRGB
#include "shaders/common/surface_texture.h"

layout(std430, binding = 0) readonly buffer Materials { MaterialRecord materials[]; };
layout(std430, binding = 1) readonly buffer Texels { uint texels[]; };

/// Whether the surface is there: its alpha at the finest level, not below the material's cutoff.
bool surface_is_there(MaterialRecord m, vec2 uv, float vertex_alpha) {
    float alpha = 255.0;
    if (texture_levels(m) > 0) {
        ivec2 size = texture_size(m);
        TexelSquare square = texel_square(uv, size, m.texture_rules);
        uint low = m.first_texel + uint(square.texels.y * size.x);
        uint high = m.first_texel + uint(square.texels.w * size.x);
        alpha = bilinear_alpha(vec4(texels[low + uint(square.texels.x)] >> 24, texels[low + uint(square.texels.z)] >> 24,
                                    texels[high + uint(square.texels.x)] >> 24, texels[high + uint(square.texels.z)] >> 24),
                               square.weight);
    }
    return passes_mask(alpha, m.base_color.w, vertex_alpha, m.emissive.w);
}

bool surface_is_there(uint material, vec2 uv, float vertex_alpha) {
    return surface_is_there(materials[material], uv, vertex_alpha);
}

vec3 linear_texel(uint index) {
    vec3 code = unpackUnorm4x8(texels[index]).rgb;
    return mix(code / 12.92, pow((code + 0.055) / 1.055, vec3(2.4)), greaterThan(code, vec3(0.04045)));
}

/// Linear colour of one level of the material's texture.
vec3 level_color(MaterialRecord m, vec2 uv, int level) {
    ivec2 size = texture_size(m);
    uint first = m.first_texel;
    for (int i = 0; i < level; ++i) {
        first += uint(size.x * size.y);
        size = level_size(size, 1);
    }
    TexelSquare square = texel_square(uv, size, m.texture_rules);
    uint low = first + uint(square.texels.y * size.x);
    uint high = first + uint(square.texels.w * size.x);
    return mix(mix(linear_texel(low + uint(square.texels.x)), linear_texel(low + uint(square.texels.z)), square.weight.x),
               mix(linear_texel(high + uint(square.texels.x)), linear_texel(high + uint(square.texels.z)), square.weight.x),
               square.weight.y);
}

/// Linear base colour with the texture, filtered over what a pixel sees of it: between the two
/// levels whose texels are as far apart as pixels are. `uv_dx`, `uv_dy`: change of uv to the
/// neighbouring pixels.
vec3 surface_color(uint material, vec2 uv, vec2 uv_dx, vec2 uv_dy) {
    MaterialRecord m = materials[material];
    int levels = texture_levels(m);
    if (levels == 0)
        return m.base_color.rgb;
    vec2 size = vec2(texture_size(m));
    vec2 dx = uv_dx * size;
    vec2 dy = uv_dy * size;
    float level = clamp(0.5 * log2(max(max(dot(dx, dx), dot(dy, dy)), 1e-20)), 0.0, float(levels - 1));
    int fine = int(level);
    vec3 color = level_color(m, uv, fine);
    if (float(fine) < level)
        color = mix(color, level_color(m, uv, fine + 1), level - float(fine));
    return m.base_color.rgb * color;
}
