// SPDX-License-Identifier: MIT
#include "renderer/tracers/roma/directions.h"

#include "shaders/common/random.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>

namespace romascope {
namespace {

/// Place of a cell along the Hilbert curve over a square whose side is a power of two (Hilbert
/// 1891; the quadrants are visited in turn, the first and the last transposed).
unsigned hilbert_index(glm::uvec2 cell, unsigned square) {
    unsigned index = 0;
    for (unsigned half = square / 2; half > 0; half /= 2) {
        const unsigned right = (cell.x & half) ? 1u : 0u, upper = (cell.y & half) ? 1u : 0u;
        index += half * half * ((3u * right) ^ upper);
        if (!upper) {
            if (right)
                cell = glm::uvec2(square - 1) - cell;
            std::swap(cell.x, cell.y);
        }
    }
    return index;
}

} // namespace

glm::dvec3 hemisphere_from_square(glm::dvec2 square) {
    const glm::dvec2 p = 2.0 * square - 1.0;
    if (p.x == 0.0 && p.y == 0.0)
        return {0.0, 0.0, 1.0};
    const double quarter = std::numbers::pi / 4.0;
    double radius, angle;
    if (std::abs(p.x) >= std::abs(p.y)) {
        radius = p.x;
        angle = quarter * (p.y / p.x);
    } else {
        radius = p.y;
        angle = 2.0 * quarter - quarter * (p.x / p.y);
    }
    // The height falls with the square of the radius: equal areas of disc and hemisphere.
    const double z = 1.0 - radius * radius;
    const double across = radius * std::sqrt(2.0 - radius * radius);
    return {across * std::cos(angle), across * std::sin(angle), z};
}

std::vector<glm::dvec3> candidate_directions(int side, bool jitter, uint32_t seed, uint32_t frame) {
    std::vector<glm::dvec3> directions;
    directions.reserve(static_cast<size_t>(side) * side);
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            glm::dvec2 place(0.5);
            if (jitter) {
                // Apart from the numbers that pixels draw with the same seed.
                constexpr uint32_t kSalt = 0x726f6d61u;
                const auto index = static_cast<uint32_t>(directions.size());
                const uint32_t x = gpu::pixel_hash({index, frame}, gpu::pcg_hash(seed ^ kSalt));
                place = {gpu::unit_float(x), gpu::unit_float(gpu::pcg_hash(x))};
            }
            directions.push_back(
                hemisphere_from_square((glm::dvec2(column, row) + place) / double(side)));
        }
    }
    return directions;
}

std::vector<int> strata_along_curve(int side) {
    std::vector<int> order(static_cast<size_t>(side) * side);
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [side](int stratum) {
        return hilbert_index({stratum % side, stratum / side}, std::bit_ceil(unsigned(side)));
    });
    return order;
}

} // namespace romascope
