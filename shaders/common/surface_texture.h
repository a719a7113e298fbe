// SPDX-License-Identifier: MIT
// What a material says of a surface's colour and alpha, and how its texture is looked up: one set
// of rules for every shader and for the reference, so that all take a masked-out spot for the same.
// Fetching texels is left to the reader: they lie in a buffer here, in vectors there.
#pragma once
#include "shaders/common/cross.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

// As romascope::TextureWrap.
const uint kWrapRepeat = 0u;
const uint kWrapMirror = 1u;
const uint kWrapClamp = 2u;

// Bits of MaterialRecord::texture_rules.
const uint kWrapUShift = 8u;
const uint kWrapVShift = 10u;
const uint kNearestBit = 4096u;

/// Laid out for std430. A texture's levels follow each other in the texel buffer, the largest
/// first, each level half as wide and high as the one before, rounded down, down to 1 x 1.
struct MaterialRecord {
    vec4 base_color; ///< linear; w: alpha
    vec4 emissive;   ///< w: alpha below this is not there; 0: no mask
    uint first_texel;
    uint texture_size;  ///< width | height << 16
    uint texture_rules; ///< levels (0: no texture), in 8 bits, and the bits above
    uint unused;
};

SHARED_FN ivec2 texture_size(MaterialRecord material) {
    return ivec2(int(material.texture_size & 0xFFFFu), int(material.texture_size >> 16));
}

SHARED_FN int texture_levels(MaterialRecord material) {
    return int(material.texture_rules & 0xFFu);
}

SHARED_FN ivec2 level_size(ivec2 size, int level) {
    return ivec2(max(size.x >> level, 1), max(size.y >> level, 1));
}

/// Two neighbouring texels along one axis and how far a point lies from the first to the second.
struct TexelPair {
    int low;
    int high;
    float weight; ///< in [0, 1)
};

/// The texels of a row of `size` around coordinate `u`, 0 at its start and 1 at its end. Any float
/// gives texels of the row.
SHARED_FN TexelPair texel_pair(float u, int size, uint wrap, bool nearest) {
    EXACT float t = wrap == kWrapClamp ? clamp(u, 0.0f, 1.0f) : u - floor(u);
    if (wrap == kWrapMirror) {
        EXACT float half_period = 2.0f * floor(0.5f * u);
        t = u - half_period;
        t = t > 1.0f ? 2.0f - t : t;
    }
    EXACT float x = t * float(size);
    x = nearest ? x : x - 0.5f;
    x = x > -1.0f ? min(x, float(size)) : -1.0f; // also if u was infinite or not a number
    float below = floor(x);
    TexelPair pair;
    pair.weight = nearest ? 0.0f : x - below;
    pair.low = int(below);
    pair.high = nearest ? pair.low : pair.low + 1;
    if (wrap == kWrapRepeat) {
        pair.low = pair.low < 0 ? size - 1 : pair.low >= size ? 0 : pair.low;
        pair.high = pair.high >= size ? 0 : pair.high;
    }
    pair.low = clamp(pair.low, 0, size - 1);
    pair.high = clamp(pair.high, 0, size - 1);
    return pair;
}

/// The four texels around a point: x and y of the first, x and y of the one across.
struct TexelSquare {
    ivec4 texels;
    vec2 weight;
};

SHARED_FN TexelSquare texel_square(vec2 uv, ivec2 size, uint rules) {
    bool nearest = (rules & kNearestBit) != 0u;
    TexelPair u = texel_pair(uv.x, size.x, (rules >> kWrapUShift) & 3u, nearest);
    TexelPair v = texel_pair(uv.y, size.y, (rules >> kWrapVShift) & 3u, nearest);
    TexelSquare square;
    square.texels = ivec4(u.low, v.low, u.high, v.high);
    square.weight = vec2(u.weight, v.weight);
    return square;
}

/// Between four alphas of 8 bits, in the order low row, high row: in [0, 255].
SHARED_FN float bilinear_alpha(vec4 alphas, vec2 weight) {
    EXACT float low = alphas.x + (alphas.y - alphas.x) * weight.x;
    EXACT float high = alphas.z + (alphas.w - alphas.z) * weight.x;
    EXACT float alpha = low + (high - low) * weight.y;
    return alpha;
}

/// Whether the mask of the material leaves the surface there. `texture_alpha` in [0, 255].
SHARED_FN bool passes_mask(float texture_alpha, float material_alpha, float vertex_alpha,
                           float cutoff) {
    EXACT float alpha = texture_alpha * (1.0f / 255.0f) * material_alpha * vertex_alpha;
    // A hair below counts: interpolating between vertices of alpha 1 need not give 1.
    EXACT float least = cutoff * (1.0f - 1.0f / 1048576.0f);
    return alpha >= least;
}

#ifdef __cplusplus
static_assert(sizeof(MaterialRecord) == 48 && offsetof(MaterialRecord, first_texel) == 32);
} // namespace romascope::gpu
#endif
