// SPDX-License-Identifier: MIT
#include "renderer/image/color.h"

#include <array>
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

float decode_srgb8(uint8_t encoded) {
    static const std::array<float, 256> table = make_decode_table();
    return table[encoded];
}

} // namespace romascope
