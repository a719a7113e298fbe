// SPDX-License-Identifier: MIT
// Triangles in cells, of the kinds that voxelisers get wrong.
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <random>

namespace romascope {

using CellCorners = std::array<glm::vec3, 3>;

enum class TriangleKind { small, middling, large, needle, strip, segment, point, flat, far };
constexpr int kTriangleKinds = 9;

/// A triangle of that kind in or near a grid of this size.
inline CellCorners random_triangle(TriangleKind kind, glm::vec3 size, std::mt19937& random) {
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    std::normal_distribution<float> normal;
    const auto place = [&] { return size * glm::vec3(unit(random), unit(random), unit(random)); };
    const auto step = [&] { return glm::vec3(normal(random), normal(random), normal(random)); };
    const glm::vec3 p = place();
    const auto around = [&](float reach) {
        return CellCorners{p + reach * step(), p + reach * step(), p + reach * step()};
    };
    switch (kind) {
    case TriangleKind::small:
        return around(0.7f);
    case TriangleKind::middling:
        return around(4.0f);
    case TriangleKind::large:
        return {p, place(), place()};
    case TriangleKind::needle: { // the third corner next to the middle of the opposite edge
        const glm::vec3 q = place();
        return {p, glm::mix(p, q, unit(random)) + 0.02f * step(), q};
    }
    case TriangleKind::strip: { // two corners next to each other
        const glm::vec3 q = place();
        return {p, q, q + 0.05f * step()};
    }
    case TriangleKind::segment: {
        const glm::vec3 q = place();
        return {p, q, unit(random) < 0.5f ? p : q};
    }
    case TriangleKind::point:
        return {p, p, p};
    case TriangleKind::flat: { // at right angles to an axis, at whole and half cells too
        CellCorners corners = around(6.0f);
        const int axis = static_cast<int>(3.0f * unit(random)) % 3;
        for (glm::vec3& corner : corners)
            corner[axis] = std::floor(2.0f * p[axis]) / 2.0f;
        return corners;
    }
    case TriangleKind::far:
        return {p + 2.0f * size * step(), p + 2.0f * size * step(), p + 2.0f * size * step()};
    }
    return {};
}

} // namespace romascope
