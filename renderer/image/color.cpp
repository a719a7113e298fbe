// SPDX-License-Identifier: MIT
#include "renderer/image/color.h"

#include <bit>
#include <cmath>

namespace romascope {
namespace {

double decode(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::array<float, 256> make_decode_table() {
    std::array<float, 256> table{};
    for (size_t i = 0; i < table.size(); ++i)
        table[i] = static_cast<float>(decode(static_cast<double>(i) / 255));
    return table;
}

/// By halving: positive floats are ordered as their bits are, and encoding keeps the order.
float smallest_encoded_as(uint8_t code) {
    uint32_t below = 0, from = std::bit_cast<uint32_t>(1.0f);
    while (from - below > 1) {
        const uint32_t middle = below + (from - below) / 2;
        (encode_srgb8(std::bit_cast<float>(middle)) < code ? below : from) = middle;
    }
    return std::bit_cast<float>(from);
}

std::array<float, 256> make_thresholds() {
    std::array<float, 256> thresholds{}; // the first is 0
    for (size_t code = 1; code < thresholds.size(); ++code)
        thresholds[code] = smallest_encoded_as(static_cast<uint8_t>(code));
    return thresholds;
}

} // namespace

float encode_srgb(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

float decode_srgb(float encoded) { return static_cast<float>(decode(encoded)); }

uint8_t encode_srgb8(float linear) {
    if (!(linear > 0)) // NaN too
        return 0;
    if (linear >= 1)
        return 255;
    return static_cast<uint8_t>(encode_srgb(linear) * 255 + 0.5f);
}

const std::array<float, 256>& srgb8_thresholds() {
    static const std::array<float, 256> thresholds = make_thresholds();
    return thresholds;
}

float decode_srgb8(uint8_t encoded) {
    static const std::array<float, 256> table = make_decode_table();
    return table[encoded];
}

} // namespace romascope
