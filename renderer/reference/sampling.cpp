// SPDX-License-Identifier: MIT
#include "renderer/reference/sampling.h"

#include <utility>

namespace romascope {
namespace {

/// Place of a point, given in 16 bits per axis, along a Hilbert curve (Warren 2003, fig. 14-5,
/// in its table-free form).
uint32_t hilbert_index(uint32_t x, uint32_t y) {
    uint32_t place = 0;
    for (uint32_t side = 1u << 15; side > 0; side >>= 1) {
        const uint32_t right = (x & side) ? 1u : 0u;
        const uint32_t upper = (y & side) ? 1u : 0u;
        place += side * side * ((3 * right) ^ upper);
        if (upper == 0) {
            if (right == 1) {
                x = 0xffffu - x;
                y = 0xffffu - y;
            }
            std::swap(x, y);
        }
    }
    return place;
}

} // namespace

Lattice::Lattice(int samples) {
    // Fractions of 2^32: 1 / golden ratio, and 1 / plastic number and its square (Roberts 2018).
    constexpr uint32_t kGolden = 2654435769u;
    constexpr uint32_t kPlastic = 3242174889u;
    constexpr uint32_t kPlasticSquared = 2447445414u;
    const auto count = static_cast<uint32_t>(samples);
    std::vector<std::pair<uint32_t, glm::uvec4>> placed;
    placed.reserve(count);
    for (uint32_t i = 0; i < count; ++i) {
        const glm::uvec4 point(static_cast<uint32_t>((uint64_t{i} << 32) / count), i * kGolden,
                               i * kPlastic, i * kPlasticSquared);
        placed.emplace_back(hilbert_index(point.x >> 16, point.y >> 16), point);
    }
    std::ranges::stable_sort(placed, {}, [](const auto& each) { return each.first; });
    points_.reserve(count);
    for (const auto& [place, point] : placed)
        points_.push_back(point);
}

} // namespace romascope
