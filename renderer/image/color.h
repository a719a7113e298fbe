// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

namespace romascope {

/// The sRGB transfer function (IEC 61966-2-1), one channel, exact in both directions. Nothing is
/// clamped: values above 1 follow the power, negative ones the straight piece.
float encode_srgb(float linear);
float decode_srgb(float encoded);

/// A linear value as the 8 bits that a PNG holds: clamped to [0, 1], encoded, rounded to nearest.
/// NaN gives 0.
uint8_t encode_srgb8(float linear);

/// For each of the 256 values the smallest linear one that encode_srgb8 gives it for, so that who
/// lacks an exact power function can encode to the same bit.
const std::array<float, 256>& srgb8_thresholds();

/// The linear value of 8 encoded bits; encode_srgb8 gives the same bits back.
float decode_srgb8(uint8_t encoded);

} // namespace romascope
