// SPDX-License-Identifier: MIT
// Random numbers from (pixel, frame, seed), never from time.
#pragma once
#include "shaders/common/cross.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

/// PCG hash (Jarzynski and Olano, Hash Functions for GPU Rendering, 2020: pcg).
SHARED_FN uint pcg_hash(uint x) {
    uint state = x * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
    return (word >> 22) ^ word;
}

/// A hash of a pixel and a key, such as a hashed seed. Further numbers of the pixel: hash it again.
SHARED_FN uint pixel_hash(uvec2 pixel, uint key) {
    return pcg_hash(pixel.x + pcg_hash(pixel.y + key));
}

/// The upper 24 bits as a float in [0, 1).
SHARED_FN float unit_float(uint x) { return float(x >> 8) * (1.0f / 16777216.0f); }

/// Point `index` of the van der Corput sequence in base 2, shifted by `shift` with wrap-around
/// (Cranley-Patterson rotation), as a fraction of 2^32.
SHARED_FN uint van_der_corput(uint index, uint shift) { return bitfieldReverse(index) + shift; }

/// Point `index` of the two-dimensional R2 sequence (Roberts, The Unreasonable Effectiveness of
/// Quasirandom Sequences, 2018), shifted likewise.
SHARED_FN uvec2 r2_sequence(uint index, uvec2 shift) {
    return uvec2(3242174889u, 2447445414u) * index + shift;
}

#ifdef __cplusplus
} // namespace romascope::gpu
#endif
