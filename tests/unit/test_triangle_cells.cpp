// SPDX-License-Identifier: MIT
// Which cells a triangle occupies, against tests in double precision that share no code with it.
#include "shaders/tracers/occupancy/triangle_cells.h"
#include "tests/support/random_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace romascope {
namespace {

/// What rounding may change, in cells: twice what the cells are longer by.
constexpr double kTie = 1.0 / 2048.0;

struct ExactTriangle {
    std::array<glm::dvec3, 3> p;
    glm::dvec3 normal;
    double plane_tie; ///< how far rounding may move the plane, in cells
};

ExactTriangle exact(const CellCorners& corners) {
    ExactTriangle t;
    for (size_t i = 0; i < 3; ++i)
        t.p[i] = corners[i];
    t.normal = glm::cross(t.p[1] - t.p[0], t.p[2] - t.p[0]);
    double sides[3], reach = 0;
    for (size_t i = 0; i < 3; ++i)
        sides[i] = glm::length(t.p[(i + 1) % 3] - t.p[i]);
    std::sort(std::begin(sides), std::end(sides));
    reach = 2 * sides[2] + 2;
    // A needle's normal is a small difference: single precision, eight roundings.
    t.plane_tie =
        sides[0] * sides[1] * reach * std::ldexp(1.0, -20) / std::max(glm::length(t.normal), 1e-30);
    return t;
}

/// Separating axes: faces of the box, the triangle's plane, edges crossed with axes. `grow`: how
/// much longer the cell is on each side.
bool boxes_meet(const ExactTriangle& t, glm::dvec3 centre, double grow) {
    const auto parted = [&](glm::dvec3 axis, double more) {
        const double length = glm::length(axis);
        if (length < 1e-12)
            return false;
        axis /= length;
        double low = 1e300, high = -1e300;
        for (const glm::dvec3& p : t.p) {
            low = std::min(low, glm::dot(axis, p - centre));
            high = std::max(high, glm::dot(axis, p - centre));
        }
        const double half = (0.5 + grow) * (std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z));
        return low > half + more || high < -half - more;
    };
    if (parted(t.normal, grow > 0 ? t.plane_tie : 0.0))
        return false;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 unit(0.0);
        unit[axis] = 1.0;
        if (parted(unit, 0.0))
            return false;
        for (size_t i = 0; i < 3; ++i)
            if (parted(glm::cross(unit, t.p[(i + 1) % 3] - t.p[i]), 0.0))
                return false;
    }
    return true;
}

/// Whether the line of a cell along `w` meets the triangle: for sure, or perhaps.
struct LineMeets {
    bool sure = false, perhaps = false;
};

LineMeets line_meets(const ExactTriangle& t, glm::dvec3 centre, int w) {
    const int u = (w + 1) % 3, v = (w + 2) % 3;
    LineMeets meets{true, true};
    for (size_t i = 0; i < 3; ++i) {
        const glm::dvec3 from = t.p[i], to = t.p[(i + 1) % 3];
        const double length = std::hypot(to[u] - from[u], to[v] - from[v]);
        double inside =
            (to[u] - from[u]) * (centre[v] - from[v]) - (to[v] - from[v]) * (centre[u] - from[u]);
        inside *= t.normal[w] < 0 ? -1 : 1;
        meets.sure = meets.sure && inside > 0;
        meets.perhaps = meets.perhaps && inside >= -kTie * std::sqrt(2.0) * length;
    }
    const double steep = std::abs(t.normal[w]);
    const double distance = std::abs(glm::dot(t.normal, centre - t.p[0]));
    const double tie = t.plane_tie * glm::length(t.normal);
    meets.perhaps = meets.perhaps && distance <= (0.5 + kTie) * steep + 2 * tie;
    // A line that all but lies in the triangle is left to another axis.
    const double most =
        std::max({std::abs(t.normal.x), std::abs(t.normal.y), std::abs(t.normal.z)});
    meets.sure = meets.sure && distance <= 0.5 * steep && steep > 2 * kTie * most + 4 * tie;
    return meets;
}

struct Built {
    gpu::CellTriangle t;
    bool conservative;

    bool occupied(glm::ivec3 uvw) const {
        for (int axis = 0; axis < 3; ++axis)
            if (uvw[axis] < t.first[axis] || uvw[axis] > t.last[axis])
                return false;
        return t.kind == gpu::kCellsBox ||
               (t.kind == gpu::kCellsTest && gpu::occupancy_of_cell(t, uvw, conservative) != 0);
    }
};

Built build(const CellCorners& p, glm::ivec3 size, bool conservative) {
    const auto apex = static_cast<size_t>(gpu::apex_of(p[0], p[1], p[2]));
    return {gpu::cell_triangle(p[apex], p[(apex + 1) % 3], p[(apex + 2) % 3], size, conservative),
            conservative};
}

/// Calls `check(kind, corners, size)` on triangles of all kinds in grids of all shapes.
template <class Check>
void for_random_triangles(int count, Check&& check) {
    std::mt19937 random(11);
    std::uniform_int_distribution<int> side(1, 48);
    for (int i = 0; i < count; ++i) {
        const auto kind = static_cast<TriangleKind>(i % kTriangleKinds);
        const glm::ivec3 size(side(random), side(random), side(random));
        const CellCorners corners = random_triangle(kind, size, random);
        SCOPED_TRACE(testing::Message() << "triangle " << i << " of kind " << i % kTriangleKinds);
        check(kind, corners, size);
        if (testing::Test::HasFailure())
            return;
    }
}

template <class Visit>
void for_cells(glm::ivec3 size, Visit&& visit) {
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                visit(glm::ivec3(x, y, z));
}

glm::ivec3 uvw_of(glm::ivec3 cell, int axis) {
    return glm::ivec3(gpu::along_uvw(glm::vec3(cell), axis));
}

TEST(TriangleCells, ConservativeIsWhatTheTriangleTouches) {
    size_t occupied = 0, ties = 0;
    for_random_triangles(1800, [&](TriangleKind kind, const CellCorners& corners, glm::ivec3 size) {
        const Built built = build(corners, size, true);
        const ExactTriangle t = exact(corners);
        size_t missing = 0, extra = 0;
        for_cells(size, [&](glm::ivec3 cell) {
            const bool found = built.occupied(uvw_of(cell, built.t.axis));
            const glm::dvec3 centre = glm::dvec3(cell) + 0.5;
            occupied += found;
            if (found == boxes_meet(t, centre, 0.0))
                return;
            ++ties;
            // Coordinates far from the grid are themselves rounded.
            const double tie = kind == TriangleKind::far ? 8 * kTie : kTie;
            missing += !found && boxes_meet(t, centre, -1e-6);
            extra += found && !boxes_meet(t, centre, tie);
        });
        EXPECT_EQ(missing, 0u);
        EXPECT_EQ(extra, 0u);
    });
    EXPECT_GT(occupied, 50000u);
    EXPECT_LT(static_cast<double>(ties), 0.05 * static_cast<double>(occupied));
}

TEST(TriangleCells, ThinIsWhereLinesThroughCentresMeetTheTriangle) {
    size_t occupied = 0, sure = 0;
    for_random_triangles(1800, [&](TriangleKind kind, const CellCorners& corners, glm::ivec3 size) {
        if (kind == TriangleKind::far) // their coordinates are rounded to more than a tie
            return;
        const Built built = build(corners, size, false);
        const ExactTriangle t = exact(corners);
        size_t missing = 0, extra = 0;
        for_cells(size, [&](glm::ivec3 cell) {
            LineMeets any;
            for (int axis = 0; axis < 3; ++axis) {
                const LineMeets meets = line_meets(t, glm::dvec3(cell) + 0.5, axis);
                any.sure = any.sure || meets.sure;
                any.perhaps = any.perhaps || meets.perhaps;
            }
            const bool found = built.occupied(uvw_of(cell, built.t.axis));
            missing += any.sure && !found;
            extra += found && !any.perhaps;
            occupied += found;
            sure += any.sure;
        });
        EXPECT_EQ(missing, 0u);
        EXPECT_EQ(extra, 0u);
    });
    EXPECT_GT(occupied, 20000u);
    EXPECT_GT(static_cast<double>(sure), 0.9 * static_cast<double>(occupied));
}

TEST(TriangleCells, ThinCellsAreAmongTheTouchedOnes) {
    for_random_triangles(900, [&](TriangleKind, const CellCorners& corners, glm::ivec3 size) {
        if (exact(corners).plane_tie > 0.1) // lines then reach from end to end of its box
            return;
        const Built thin = build(corners, size, false), all = build(corners, size, true);
        size_t stray = 0;
        for_cells(size, [&](glm::ivec3 cell) {
            stray +=
                thin.occupied(uvw_of(cell, thin.t.axis)) && !all.occupied(uvw_of(cell, all.t.axis));
        });
        EXPECT_EQ(stray, 0u);
    });
}

TEST(TriangleCells, LookingOnlyWhereToLookMissesNothing) {
    for (const bool conservative : {false, true}) {
        size_t looked = 0, occupied = 0;
        for_random_triangles(1800, [&](TriangleKind, const CellCorners& corners, glm::ivec3 size) {
            const Built built = build(corners, size, conservative);
            const gpu::CellTriangle& t = built.t;
            if (t.kind == gpu::kCellsNone)
                return;
            size_t there = 0, found = 0;
            for (int u = t.first.x; u <= t.last.x; ++u) {
                for (int v = t.first.y; v <= t.last.y; ++v)
                    for (int w = t.first.z; w <= t.last.z; ++w)
                        there += built.occupied({u, v, w});
                const gpu::CellRange row = gpu::cells_of_row(t, u, t.first.y, t.last.y);
                for (int v = row.first; v <= row.last; ++v) {
                    const gpu::CellRange column = gpu::cells_of_column(t, u, v, conservative);
                    for (int w = column.first; w <= column.last; ++w, ++looked)
                        found += built.occupied({u, v, w});
                }
            }
            EXPECT_EQ(found, there);
            occupied += found;
        });
        EXPECT_GT(occupied, 20000u);
        EXPECT_LT(static_cast<double>(looked), 4.0 * static_cast<double>(occupied));
    }
}

TEST(TriangleCells, TrianglesWithoutAreaAreTouchedButNotMet) {
    std::mt19937 random(8);
    const glm::ivec3 size(30);
    for (int i = 0; i < 500; ++i) {
        const auto kind = i % 2 ? TriangleKind::segment : TriangleKind::point;
        const CellCorners corners = random_triangle(kind, size, random);
        EXPECT_EQ(build(corners, size, false).t.kind, gpu::kCellsNone);
        const Built touched = build(corners, size, true);
        for (const glm::vec3& corner : corners)
            EXPECT_TRUE(touched.occupied(uvw_of(glm::ivec3(corner), touched.t.axis)));
    }
}

TEST(TriangleCells, NothingOutsideOfTheGrid) {
    std::mt19937 random(5);
    const glm::ivec3 size(20, 7, 33);
    for (int i = 0; i < 3000; ++i) {
        CellCorners corners = random_triangle(TriangleKind::middling, size, random);
        glm::vec3 away(0.0f);
        away[i % 3] = (i & 1 ? 1e3f : -1e3f) * (1.0f + static_cast<float>(i));
        for (glm::vec3& corner : corners)
            corner += away;
        EXPECT_EQ(build(corners, size, i % 4 < 2).t.kind, gpu::kCellsNone);
    }
}

} // namespace
} // namespace romascope
