// SPDX-License-Identifier: MIT
// Division, square root and arc tangent that have the same bits on every IEEE machine: an integer
// guess and Newton steps of sums and products alone. Relative error below 3e-7.
#pragma once
#include "shaders/common/cross.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

/// 1 / x for normal x > 0.
SHARED_FN float exact_reciprocal(float x) {
    EXACT float y = uintBitsToFloat(0x7EF311C7u - floatBitsToUint(x));
    y = y * (2.0f - x * y);
    y = y * (2.0f - x * y);
    y = y * (2.0f - x * y);
    return y;
}

/// Square root for x = 0 or normal x > 0.
SHARED_FN float exact_sqrt(float x) {
    EXACT float h = 0.5f * x;
    EXACT float y = uintBitsToFloat(0x5F375A86u - (floatBitsToUint(x) >> 1));
    y = y * (1.5f - h * y * y);
    y = y * (1.5f - h * y * y);
    y = y * (1.5f - h * y * y);
    EXACT float root = x * y;
    return root;
}

/// Arc tangent of x in [0, 1], in units of pi / 4: 0 to 1. Polynomial of Abramowitz and Stegun,
/// Handbook of Mathematical Functions, 4.4.49 (error below 2e-8 rad, before rounding).
SHARED_FN float exact_atan_over_quarter_pi(float x) {
    EXACT float s = x * x;
    EXACT float p = 0.0028662257f;
    p = p * s - 0.0161657367f;
    p = p * s + 0.0429096138f;
    p = p * s - 0.0752896400f;
    p = p * s + 0.1065626393f;
    p = p * s - 0.1420889944f;
    p = p * s + 0.1999355085f;
    p = p * s - 0.3333314528f;
    p = p * s + 1.0f;
    EXACT float angle = p * x * 1.2732395447f;
    return angle;
}

#ifdef __cplusplus
} // namespace romascope::gpu
#endif
