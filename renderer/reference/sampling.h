// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace romascope {

/// Output permutation of the PCG generator (Jarzynski and Olano 2020, "Hash Functions for GPU
/// Rendering").
inline uint32_t hash(uint32_t x) {
    x = x * 747796405u + 2891336453u;
    x = ((x >> ((x >> 28) + 4)) ^ x) * 277803737u;
    return (x >> 22) ^ x;
}

/// 32 bits as a fraction in (0, 1), never 0 or 1.
inline float fraction(uint32_t bits) { return (static_cast<float>(bits >> 9) + 0.5f) * 0x1p-23f; }

/// Unit square to hemisphere about z, density cos / pi: concentric mapping (Shirley and Chiu 1997)
/// and projection (Malley). `u` in (0, 1); neighbours stay neighbours.
inline glm::vec3 cosine_direction(glm::vec2 u) {
    const float a = 2.0f * u.x - 1.0f;
    const float b = 2.0f * u.y - 1.0f;
    const bool wide = std::abs(a) > std::abs(b);
    const float radius = wide ? a : b;
    // Angle in [-pi/4, pi/4], where these series are exact to a rounding.
    const float angle = 0.785398163f * (wide ? b : a) / (radius == 0.0f ? 1.0f : radius);
    const float q = angle * angle;
    const float sine =
        angle * (1.0f + q * (-1.66666667e-1f +
                             q * (8.33333333e-3f + q * (-1.98412698e-4f + q * 2.75573192e-6f))));
    const float cosine =
        1.0f + q * (-0.5f + q * (4.16666667e-2f + q * (-1.38888889e-3f + q * 2.48015873e-5f)));
    const float x = radius * (wide ? cosine : sine);
    const float y = radius * (wide ? sine : cosine);
    return {x, y, std::sqrt(std::max(0.0f, 1.0f - radius * radius))};
}

/// Two unit vectors that make a right-handed frame with unit `n` (Duff et al. 2017).
inline glm::mat3 frame_about(glm::vec3 n) {
    const float sign = std::copysign(1.0f, n.z);
    const float a = -1.0f / (sign + n.z);
    const float b = n.x * n.y * a;
    return {
        {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

/// `samples` points of the unit square that fill it evenly (a Fibonacci lattice, with two further
/// dimensions by the R2 sequence), in the order of a Hilbert curve so that rays traced together
/// go similar ways. Shifted round the square by a random amount, each point is uniform, so any
/// mean over them is unbiased (Cranley and Patterson 1976).
class Lattice {
public:
    explicit Lattice(int samples);

    int size() const { return static_cast<int>(points_.size()); }
    /// Point i of the hemisphere, shifted by a hash of `seed`.
    glm::vec2 direction(int i, uint32_t seed) const {
        return shifted({points_[index(i)].x, points_[index(i)].y}, seed);
    }
    /// Point i of the pixel.
    glm::vec2 pixel(int i, uint32_t seed) const {
        return shifted({points_[index(i)].z, points_[index(i)].w}, seed ^ 0x9e3779b9u);
    }

private:
    static size_t index(int i) { return static_cast<size_t>(i); }
    static glm::vec2 shifted(glm::uvec2 point, uint32_t seed) {
        const uint32_t first = hash(seed); // wrapping sums are the shift round the square
        return {fraction(point.x + first), fraction(point.y + hash(first))};
    }

    std::vector<glm::uvec4> points_; ///< as fractions of 2^32
};

} // namespace romascope
