// SPDX-License-Identifier: MIT
// Which cells of the occupancy grid a triangle occupies. Two coverages:
//
// - conservative: every cell that the triangle touches, by separating axes in the form of Schwarz
//   and Seidel 2010, "Fast parallel surface and solid voxelization on GPUs": the plane against the
//   cell, and the edges against its outline along each axis.
// - thin: every cell in which the triangle crosses one of three lines through the cell's centre,
//   along the axes and as long as the cell (Laine 2013, "A topological approach to voxelization").
//   That is 6-separating: no path from cell to cell through faces leads through a closed surface.
//   It is also what rasterising along the three axes aims at.
//
// Lengths are in cells; cell i reaches from i to i + 1. A triangle is looked at in the order
// (u, v, w) of axes, w being the one that it faces most: so a column along w meets few cells.
// Whether a cell is occupied is decided by `occupancy_of_cell` alone, from the triangle and the
// cell, by sums and products in one order: the same bits on every machine, whoever asks. The
// functions that say where to look give at least the cells that it takes.
#pragma once
#include "shaders/common/exact_math.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

/// Cells and lines are longer by this on either side, so that rounding opens no hole between
/// triangles that share an edge. Coordinates up to 256 are rounded to 1/65536, and products of
/// differences to less than a quarter of this, times the side.
const float kCellSlack = 1.0f / 4096.0f;
/// A component of the normal is wrong by less than this, times the longest extents of the two edges
/// that it is the product of.
const float kNormalError = 1.0f / 2097152.0f;
/// By how much more where to look is wider than what is taken.
const float kLookFurther = 0.01f;

// CellTriangle::kind
const int kCellsNone = 0; ///< none
const int kCellsBox = 1;  ///< every cell from first to last
const int kCellsTest = 2; ///< those that occupancy_of_cell takes, from first to last

struct CellTriangle {
    int kind;
    int axis; ///< w: 0 x, 1 y, 2 z
    vec3 a;   ///< corners along u, v, w; the longest edge is opposite of a
    vec3 b;
    vec3 c;
    vec3 normal;     ///< along u, v, w; twice the area long
    vec3 line_reach; ///< how far along the normal a cell's centre may be for lines along u, v, w;
                     ///< below 0: lines that are looked at by another axis from a better side
    float box_reach; ///< the same for the whole cell
    ivec3 first;     ///< cells along u, v, w that may be occupied, both included
    ivec3 last;
};

/// Consecutive cells, both included; none if last < first.
struct CellRange {
    int first;
    int last;
};

SHARED_FN vec3 yzx_of(vec3 p) { return vec3(p.y, p.z, p.x); }
SHARED_FN vec3 zxy_of(vec3 p) { return vec3(p.z, p.x, p.y); }

/// Components x, y, z in the order u, v, w. Where there is a choice, v is z, along which the cells
/// of a word lie.
SHARED_FN vec3 along_uvw(vec3 p, int axis) {
    return axis == 0 ? vec3(p.y, p.z, p.x) : axis == 1 ? vec3(p.x, p.z, p.y) : p;
}

/// The cell (x, y, z) from its places along u, v, w.
SHARED_FN ivec3 cell_xyz(ivec3 cell, int axis) {
    return axis == 0   ? ivec3(cell.z, cell.x, cell.y)
           : axis == 1 ? ivec3(cell.x, cell.z, cell.y)
                       : cell;
}

/// The corner, 0 to 2, that is opposite of the longest edge. Its edges give the best normal.
SHARED_FN int apex_of(vec3 p, vec3 q, vec3 r) {
    EXACT vec3 pq = q - p;
    EXACT vec3 qr = r - q;
    EXACT vec3 rp = p - r;
    EXACT float pq2 = pq.x * pq.x + pq.y * pq.y + pq.z * pq.z;
    EXACT float qr2 = qr.x * qr.x + qr.y * qr.y + qr.z * qr.z;
    EXACT float rp2 = rp.x * rp.x + rp.y * rp.y + rp.z * rp.z;
    return qr2 >= pq2 && qr2 >= rp2 ? 0 : rp2 >= pq2 ? 1 : 2;
}

SHARED_FN float largest_of(vec3 p) { return max(p.x, max(p.y, p.z)); }

/// Corners in cells, x, y, z; `a` as apex_of says. `size`: of the grid.
SHARED_FN CellTriangle cell_triangle(vec3 a, vec3 b, vec3 c, ivec3 size, bool conservative) {
    CellTriangle t;
    EXACT vec3 low = min(a, min(b, c)) - kCellSlack;
    EXACT vec3 high = max(a, max(b, c)) + kCellSlack;
    vec3 low_cell = floor(low);
    vec3 high_cell = floor(high);
    vec3 end = vec3(size);
    vec3 first = clamp(low_cell, vec3(0.0f), end);
    vec3 last = clamp(high_cell, vec3(-1.0f), end - 1.0f);
    t.kind = first.x > last.x || first.y > last.y || first.z > last.z ? kCellsNone : kCellsTest;
    vec3 cells = high_cell - low_cell;
    int axes;
    if (conservative) {
        // A row of cells is touched from end to end.
        axes = (cells.x > 0.0f ? 1 : 0) + (cells.y > 0.0f ? 1 : 0) + (cells.z > 0.0f ? 1 : 0);
        t.kind = axes < 2 && t.kind == kCellsTest ? kCellsBox : t.kind;
    } else {
        // A line is where centres lie on two axes.
        EXACT vec3 low_centre = ceil(low - 0.5f);
        EXACT vec3 high_centre = floor(high - 0.5f);
        axes = (low_centre.x <= high_centre.x ? 1 : 0) + (low_centre.y <= high_centre.y ? 1 : 0) +
               (low_centre.z <= high_centre.z ? 1 : 0);
        t.kind = axes < 2 ? kCellsNone : t.kind;
    }
    EXACT vec3 ab = b - a;
    EXACT vec3 ac = c - a;
    EXACT vec3 normal = yzx_of(ab) * zxy_of(ac) - zxy_of(ab) * yzx_of(ac);
    vec3 steep = abs(normal);
    t.axis = steep.x > steep.y && steep.x > steep.z ? 0 : steep.y > steep.z ? 1 : 2;
    t.a = along_uvw(a, t.axis);
    t.b = along_uvw(b, t.axis);
    t.c = along_uvw(c, t.axis);
    t.normal = along_uvw(normal, t.axis);
    if (t.axis == 1) // two axes changed places
        t.normal = -t.normal;
    steep = abs(t.normal);
    EXACT vec3 extent = high - low;
    EXACT float unsure = kNormalError * largest_of(abs(ab)) * largest_of(abs(ac));
    // No line meets a triangle without area.
    t.kind = !conservative && steep.z <= unsure ? kCellsNone : t.kind;
    EXACT float error = unsure * (extent.x + extent.y + extent.z + 2.0f);
    EXACT vec3 line_reach = (0.5f + kCellSlack) * steep + error;
    EXACT float box_reach = (0.5f + kCellSlack) * (steep.x + steep.y + steep.z) + error;
    // Along a line that the triangle all but lies in, rounding is longer than a cell.
    EXACT float least = 2.0f * (kCellSlack * steep.z + error);
    line_reach.x = steep.x > least ? line_reach.x : -1.0f;
    line_reach.y = steep.y > least ? line_reach.y : -1.0f;
    t.line_reach = line_reach;
    t.box_reach = box_reach;
    t.first = ivec3(along_uvw(first, t.axis));
    t.last = ivec3(along_uvw(last, t.axis));
    return t;
}

/// For each axis, seen along it: how far inside of an edge a point is, times the edge's length;
/// `from` is the way there from the edge's start. Squares of half side `reach` around the point
/// count if any of them is inside.
SHARED_FN vec3 edge_margin(vec3 edge, vec3 from, vec3 sides, float reach) {
    EXACT vec3 area = yzx_of(edge) * zxy_of(from) - zxy_of(edge) * yzx_of(from);
    EXACT vec3 margin = area * sides + reach * (yzx_of(abs(edge)) + zxy_of(abs(edge)));
    return margin;
}

/// Which way round the triangle is seen along u, v, w.
SHARED_FN vec3 sides_of(CellTriangle t) {
    return vec3(t.normal.x < 0.0f ? -1.0f : 1.0f, t.normal.y < 0.0f ? -1.0f : 1.0f,
                t.normal.z < 0.0f ? -1.0f : 1.0f);
}

SHARED_FN vec3 centre_of_cell(ivec3 cell) {
    EXACT vec3 centre = vec3(cell) + 0.5f;
    return centre;
}

/// 0: the cell (u, v, w) is free. Conservative: 1 if the triangle touches it. Thin: the sum of 1,
/// 2, 4 for those of its lines, along u, v, w, that the triangle crosses.
SHARED_FN int occupancy_of_cell(CellTriangle t, ivec3 cell, bool conservative) {
    vec3 centre = centre_of_cell(cell);
    EXACT vec3 from_a = centre - t.a;
    EXACT float distance = t.normal.x * from_a.x + t.normal.y * from_a.y + t.normal.z * from_a.z;
    distance = abs(distance);
    if (distance > (conservative ? t.box_reach : t.line_reach.z))
        return 0;
    EXACT vec3 from_b = centre - t.b;
    EXACT vec3 from_c = centre - t.c;
    EXACT vec3 ab = t.b - t.a;
    EXACT vec3 bc = t.c - t.b;
    EXACT vec3 ca = t.a - t.c;
    vec3 sides = sides_of(t);
    float reach = conservative ? 0.5f + kCellSlack : kCellSlack;
    vec3 margin =
        min(edge_margin(ab, from_a, sides, reach),
            min(edge_margin(bc, from_b, sides, reach), edge_margin(ca, from_c, sides, reach)));
    if (conservative)
        return min(margin.x, min(margin.y, margin.z)) >= 0.0f ? 1 : 0;
    return (margin.x >= 0.0f && distance <= t.line_reach.x ? 1 : 0) +
           (margin.y >= 0.0f && distance <= t.line_reach.y ? 2 : 0) + (margin.z >= 0.0f ? 4 : 0);
}

/// Weights of the corners a, b, c, of sum 1, where the line through the cell's centre along an axis
/// (0 u, 1 v, 2 w) meets the triangle; beside it, those of a point on its edge.
SHARED_FN vec3 corner_weights(CellTriangle t, ivec3 cell, int axis) {
    vec3 centre = centre_of_cell(cell);
    EXACT vec3 ab = t.b - t.a;
    EXACT vec3 bc = t.c - t.b;
    EXACT vec3 ca = t.a - t.c;
    EXACT vec3 from_a = centre - t.a;
    EXACT vec3 from_b = centre - t.b;
    EXACT vec3 from_c = centre - t.c;
    vec3 sides = sides_of(t);
    EXACT vec3 weights = max(vec3(edge_margin(bc, from_b, sides, 0.0f)[axis],
                                  edge_margin(ca, from_c, sides, 0.0f)[axis],
                                  edge_margin(ab, from_a, sides, 0.0f)[axis]),
                             vec3(0.0f));
    EXACT float sum = weights.x + weights.y + weights.z;
    if (!(sum > 1e-30f))
        return vec3(1.0f, 0.0f, 0.0f);
    EXACT vec3 share = weights * exact_reciprocal(sum);
    return share;
}

/// What varies over the triangle, from its corners.
SHARED_FN vec3 blend_corners(vec3 at_a, vec3 at_b, vec3 at_c, vec3 weights) {
    EXACT vec3 blended = at_a * weights.x + at_b * weights.y + at_c * weights.z;
    return blended;
}

/// Where to look along w in column (u, v).
SHARED_FN CellRange cells_of_column(CellTriangle t, int u, int v, bool conservative) {
    CellRange range;
    range.first = t.first.z;
    range.last = t.last.z;
    float steep = abs(t.normal.z);
    if (t.kind == kCellsTest && steep > 1e-12f) {
        float centre = t.a.z - (t.normal.x * (float(u) + 0.5f - t.a.x) +
                                t.normal.y * (float(v) + 0.5f - t.a.y)) /
                                   t.normal.z;
        float reach = (conservative ? t.box_reach : t.line_reach.z) / steep + kLookFurther;
        range.first =
            int(clamp(ceil(centre - reach - 0.5f), float(t.first.z), float(t.last.z) + 1.0f));
        range.last =
            int(clamp(floor(centre + reach - 0.5f), float(t.first.z) - 1.0f, float(t.last.z)));
    }
    return range;
}

/// What one edge leaves of the range (first, last) of cells along v, seen along w in row u.
SHARED_FN vec2 cut_by_edge(vec2 range, vec3 corner, vec3 edge, float side, int u) {
    float slope = side * edge.x;
    float margin = (0.5f + kLookFurther) * (abs(edge.x) + abs(edge.y)) -
                   side * edge.y * (float(u) + 0.5f - corner.x);
    if (abs(slope) > 1e-12f) {
        float limit = corner.y - margin / slope - 0.5f;
        if (slope > 0.0f)
            range.x = max(range.x, ceil(limit - kLookFurther));
        else
            range.y = min(range.y, floor(limit + kLookFurther));
    }
    return range;
}

/// Where to look along v in row u, among cells `first` to `last`.
SHARED_FN CellRange cells_of_row(CellTriangle t, int u, int first, int last) {
    float side = t.normal.z < 0.0f ? -1.0f : 1.0f;
    vec2 range = vec2(float(first), float(last));
    if (t.kind == kCellsTest) {
        range = cut_by_edge(range, t.a, t.b - t.a, side, u);
        range = cut_by_edge(range, t.b, t.c - t.b, side, u);
        range = cut_by_edge(range, t.c, t.a - t.c, side, u);
    }
    CellRange cells;
    cells.first = int(clamp(range.x, float(first), float(last) + 1.0f));
    cells.last = int(clamp(range.y, float(first) - 1.0f, float(last)));
    return cells;
}

#ifdef __cplusplus
} // namespace romascope::gpu
#endif
