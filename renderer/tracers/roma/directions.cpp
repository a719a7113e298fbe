// SPDX-License-Identifier: MIT
#include "renderer/tracers/roma/directions.h"

#include "shaders/common/random.h"

#include <cmath>
#include <numbers>

namespace romascope {
namespace {

glm::ivec4 fixed_point(glm::dvec3 cells) {
    const double scale = 1 << gpu::kRomaFractionBits;
    return glm::ivec4(glm::ivec3(glm::floor(cells * scale + 0.5)), 0);
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
                const auto index = static_cast<uint32_t>(directions.size());
                const uint32_t x = gpu::pixel_hash({index, frame}, seed, 0x726f6d61u);
                place = {gpu::unit_float(x), gpu::unit_float(gpu::pcg_hash(x))};
            }
            directions.push_back(
                hemisphere_from_square((glm::dvec2(column, row) + place) / double(side)));
        }
    }
    return directions;
}

AlignedCube AlignedCube::around(const Bounds& bounds, double base_cell, int side) {
    AlignedCube cube;
    cube.centre = bounds.centre();
    cube.cell_size = (glm::length(glm::dvec3(bounds.extent())) + 2.0 * base_cell) / side;
    cube.side = side;
    return cube;
}

gpu::RomaDirection aligned_map(const AlignedCube& cube, glm::dvec3 direction,
                               const OccupancyGrid& grid) {
    const glm::dvec3 helper =
        std::abs(direction.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(helper, direction));
    const glm::dvec3 v = glm::cross(direction, u);
    const double half = 0.5 * cube.side;
    const auto row = [&](glm::dvec3 axis) {
        return glm::vec4(glm::vec3(axis / cube.cell_size), static_cast<float>(half));
    };
    // From aligned cells to base cells: both grids are cubic.
    const double ratio = cube.cell_size / grid.cell_size;
    const glm::dvec3 centre =
        (glm::dvec3(cube.centre) - glm::dvec3(grid.origin)) / double(grid.cell_size);
    const glm::dvec3 first = centre + (u + v + direction) * ratio * (0.5 - half);
    return {row(u),
            row(v),
            row(direction),
            fixed_point(first),
            fixed_point(u * ratio),
            fixed_point(v * ratio),
            fixed_point(direction * ratio)};
}

} // namespace romascope
