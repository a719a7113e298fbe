// SPDX-License-Identifier: MIT
// Which cell of the spatial hash a surface point belongs to, in integers, and the two hashes of it:
// the same for the shaders and their CPU twin.
//
// The size of a cell is the smallest size times a power of two, its level. Coordinates and normal
// are rounded so that what scenes are full of lies in the middle of something: a surface that lies
// exactly between two cells (y = 0 is a border at every size) belongs to one of them, whatever the
// rounding of its points, as does a normal along an axis or half-way between two.
#pragma once
#include "shaders/common/cross.h"
#include "shaders/common/random.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

/// How far points are moved along their normal before they are rounded, in cells. The golden
/// section: no multiple of a fraction of small numbers, so planes at such places lie off borders.
const float kCellBias = 0.3819660f;
/// As kCellBias for the normal times its bins: a little off 1/2, so that 0 lies in the middle of a
/// bin and neither 1/2 nor sqrt(1/2) on a border with the bins that are in use.
const float kNormalBias = 0.5669873f;
const int kMaxCellLevel = 30;

struct CellKey {
    ivec3 cell;
    ivec3 normal;
    int level;
};

/// 2^exponent, for exponents of normal floats.
SHARED_FN float power_of_two(int exponent) { return uintBitsToFloat(uint(exponent + 127) << 23); }

/// The level of the largest cells that are no larger than wanted: floor(log2(ratio)), at least 0.
/// `ratio`: wanted size over the smallest. Any float, NaN included, gives a level.
SHARED_FN int cell_level(float ratio) {
    if (!(ratio >= 1.0f))
        return 0;
    int exponent = int((floatBitsToUint(ratio) >> 23) & 255u) - 127;
    return min(exponent, kMaxCellLevel);
}

/// How far the wanted size is from the cells of its level to those of the next: 0 to 1. Continuous
/// over levels: near 1 below a power of two, as those from there on have weight 0 in the next.
SHARED_FN float next_level_weight(float ratio) {
    if (!(ratio >= 1.0f) || ratio >= power_of_two(kMaxCellLevel))
        return 0.0f;
    return uintBitsToFloat((floatBitsToUint(ratio) & 0x7FFFFFu) | 0x3F800000u) - 1.0f;
}

/// floor(x) as an integer; far away, and for NaN, some integer.
SHARED_FN int floor_to_int(float x) {
    float bounded = x > -1.0e9f ? min(x, 1.0e9f) : -1.0e9f;
    return int(floor(bounded));
}

/// `inverse_smallest`: one over the smallest size, 1/m. `normal_bins`: bins of a component from 0
/// to 1.
SHARED_FN CellKey cell_key(vec3 position, vec3 normal, int level, float inverse_smallest,
                           float normal_bins) {
    EXACT float inverse_size = inverse_smallest * power_of_two(-level);
    EXACT vec3 scaled = position * inverse_size;
    EXACT vec3 shift = normal * kCellBias;
    EXACT vec3 cell = scaled + shift;
    EXACT vec3 bins = normal * normal_bins;
    bins = bins + vec3(kNormalBias);
    CellKey key;
    key.cell = ivec3(floor_to_int(cell.x), floor_to_int(cell.y), floor_to_int(cell.z));
    key.normal = ivec3(floor_to_int(bins.x), floor_to_int(bins.y), floor_to_int(bins.z));
    key.level = level;
    return key;
}

/// Normal and level in one word, a byte each: bins lie between -100 and 100.
SHARED_FN uint cell_kind(CellKey key) {
    return (uint(key.normal.x) & 255u) | ((uint(key.normal.y) & 255u) << 8) |
           ((uint(key.normal.z) & 255u) << 16) | (uint(key.level) << 24);
}

/// XXH32 (Collet, xxHash) of three words' twelve bytes, the lowest of each first.
SHARED_FN uint xx_hash(uvec3 words, uint seed) {
    uint h = seed + 374761393u + 12u;
    h = h + 3266489917u * words.x;
    h = 668265263u * ((h << 17) | (h >> 15));
    h = h + 3266489917u * words.y;
    h = 668265263u * ((h << 17) | (h >> 15));
    h = h + 3266489917u * words.z;
    h = 668265263u * ((h << 17) | (h >> 15));
    h = 2246822519u * (h ^ (h >> 15));
    h = 3266489917u * (h ^ (h >> 13));
    return h ^ (h >> 16);
}

/// Where to look for the cell: PCG, nested over the key's words.
SHARED_FN uint home_hash(CellKey key) {
    uint h = pcg_hash(cell_kind(key));
    h = pcg_hash(uint(key.cell.z) + h);
    h = pcg_hash(uint(key.cell.y) + h);
    return pcg_hash(uint(key.cell.x) + h);
}

/// What tells the cell from others: xxHash32 of its coordinates, with normal and level as seed; 0
/// is kept for free slots.
SHARED_FN uint key_checksum(CellKey key) {
    uvec3 words = uvec3(uint(key.cell.x), uint(key.cell.y), uint(key.cell.z));
    return max(xx_hash(words, cell_kind(key)), 1u);
}

#ifdef __cplusplus
} // namespace romascope::gpu
#endif
