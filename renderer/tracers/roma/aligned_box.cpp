// SPDX-License-Identifier: MIT
#include "renderer/tracers/roma/aligned_box.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace romascope {
namespace {

glm::ivec4 fixed_point(glm::dvec3 cells) {
    const double scale = 1 << gpu::kRomaFractionBits;
    return glm::ivec4(glm::ivec3(glm::floor(cells * scale + 0.5)), 0);
}

} // namespace

AlignedBox AlignedBox::around(const Bounds& bounds, double margin, glm::dvec3 direction, int side) {
    const glm::dvec3 extent = glm::dvec3(bounds.extent()) + 2.0 * margin;
    const auto length_along = [&](glm::dvec3 axis) { return glm::dot(glm::abs(axis), extent); };
    const glm::dvec3 helper =
        std::abs(direction.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(helper, direction));
    const glm::dvec3 up = glm::cross(direction, right);

    AlignedBox box;
    box.centre = glm::dvec3(bounds.centre());
    double smallest = std::numeric_limits<double>::infinity();
    constexpr int kTurns = 18; // of 5 degrees
    for (int turn = 0; turn < kTurns; ++turn) {
        const double angle = turn * std::numbers::pi / (2 * kTurns);
        const glm::dvec3 u = std::cos(angle) * right + std::sin(angle) * up;
        const glm::dvec3 v = glm::cross(direction, u);
        const glm::dvec3 size(length_along(u), length_along(v), length_along(direction));
        if (size.x * size.y < smallest) {
            smallest = size.x * size.y;
            box.axes = glm::dmat3(u, v, direction);
            box.cell = size / double(side);
        }
    }
    return box;
}

AlignedBox AlignedBox::enclosing(const Bounds& bounds, double margin, glm::dvec3 direction,
                                 int side) {
    AlignedBox box = around(bounds, margin, direction, side);
    box.cell = glm::dvec3(enclosing_cell(bounds, margin, side));
    return box;
}

double enclosing_cell(const Bounds& bounds, double margin, int side) {
    return glm::length(glm::dvec3(bounds.extent()) + 2.0 * margin) / side;
}

gpu::RomaDirection aligned_map(const AlignedBox& box, int side, const OccupancyGrid& grid,
                               double offset) {
    const auto row = [&](int axis, double extra) {
        return glm::vec4(glm::vec3(box.axes[axis] / box.cell[axis]), static_cast<float>(extra));
    };
    // From aligned cells to base cells.
    const glm::dvec3 centre = (box.centre - glm::dvec3(grid.origin)) / double(grid.cell_size);
    glm::dvec3 steps[3];
    glm::dvec3 first = centre;
    for (int axis = 0; axis < 3; ++axis) {
        steps[axis] = box.axes[axis] * (box.cell[axis] / grid.cell_size);
        first += steps[axis] * (0.5 - 0.5 * side);
    }
    return {row(0, 1.0 / box.cell.z), row(1, box.cell.z),    row(2, offset),
            fixed_point(first),       fixed_point(steps[0]), fixed_point(steps[1]),
            fixed_point(steps[2])};
}

} // namespace romascope
