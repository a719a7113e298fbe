// SPDX-License-Identifier: MIT
// Ray-aligned occupancy maps by shear: what the generation and the tracing compute, for the shaders
// and their CPU twin alike.
//
// The map of a direction keeps the base map's cells. Along the direction's dominant axis m they are
// cut into slices; p and q are the other two axes. Slice k is moved sideways by the whole number of
// cells that the direction has gone at its middle, so that column (i, j) holds, as bit k, the base
// cell i + offset_p(k) along p, j + offset_q(k) along q, k along m. Places are wrapped around at
// the border: each slice is permuted, so no cell is lost or doubled. Rays keep their column
// unwrapped; only slices count in which that column's own cell lies in the grid.
//
// Aligned coordinates (span.h) are u = p - slope_p m, v = q - slope_q m and w = m, in base cells.
// Slopes are whole numbers of 2^-kShearFractionBits, and all that decides about cells is done in
// integers.
#pragma once
#include "shaders/tracers/roma/walk.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

/// Products of two fractions of a cell fit a signed integer.
const int kShearFractionBits = 15;

/// What the maps of all directions share. Laid out for std140.
struct ShearGrid {
    vec4 origin;   ///< xyz: lower corner of the grid, metres; w: cells per metre
    vec4 inverse;  ///< xyz: 1 / columns; w: normal offset, cells
    ivec4 columns; ///< xyz: cells along x, y, z where those are columns, the guard's included; w:
                   ///< guard cells on each side, always empty
    ivec4 first_word; ///< xyz: of the base map's packing for slices along x, y, z; w: maps
    ivec4 row_words;  ///< xyz: words of a row in it; w: places of an axis in the table of them
};

/// The map of one direction. Laid out for std430.
struct ShearMap {
    ivec4 slope; ///< x, y: cells along p, q per slice, fixed point, -1 to 1; z: axis m; w: first
                 ///< texel
    vec4 scale;  ///< x, y: slices per cell along p, q, at most 1e9; z: slices per metre along the
                 ///< direction, w: metres per slice
    vec4 along;  ///< for rays; xyz: towards later slices, cells along x, y, z per slice; w unused
    ivec4 rays;  ///< x: where place 0 along p has its entry in the table of places; y: slices; z:
                 ///< axis m; w unused
};

/// Along p, q and m, of what is given along x, y and z; m by its number. p is z, as the bits of the
/// base map, unless m is.
SHARED_FN vec3 shear_turned(vec3 v, int m) {
    return vec3(m == 2 ? v.x : v.z, m == 1 ? v.x : v.y, m == 0 ? v.x : m == 1 ? v.y : v.z);
}
SHARED_FN ivec3 shear_turned(ivec3 v, int m) {
    return ivec3(m == 2 ? v.x : v.z, m == 1 ? v.x : v.y, m == 0 ? v.x : m == 1 ? v.y : v.z);
}

/// Columns along p and q, and slices.
SHARED_FN ivec3 shear_size(ShearGrid grid, int m) {
    ivec3 size = shear_turned(ivec3(grid.columns), m);
    size.z -= 2 * grid.columns.w;
    return size;
}

/// How far slice `slice` is moved along one axis: where the line through the middle of a column's
/// first face is at mid-slice.
SHARED_FN int shear_offset(int slope, int slice) {
    return (slope * (2 * slice + 1) + (1 << kShearFractionBits)) >> (kShearFractionBits + 1);
}

/// That line as it passes face `face`, the lower one of the slice of that number; fixed point.
SHARED_FN int shear_at_face(int slope, int face) {
    return slope * face + (1 << (kShearFractionBits - 1));
}

/// The cell between those at the entry and at the exit of a slice, where a line that changes both
/// of its coordinates in between passes one: relative to the column, as shear_offset.
SHARED_FN ivec2 shear_between(ivec2 slope, int slice) {
    ivec2 entry = ivec2(shear_at_face(slope.x, slice), shear_at_face(slope.y, slice));
    ivec2 leaving = entry + slope;
    ivec2 cell = entry >> kShearFractionBits;
    ivec2 turn = (leaving >> kShearFractionBits) - cell;
    if (turn.x == 0 || turn.y == 0)
        return cell;
    // How far to the border, as fractions of a cell; the first to be crossed takes less of a slice.
    ivec2 past = entry - cell * (1 << kShearFractionBits);
    ivec2 ahead = ivec2(turn.x > 0 ? (1 << kShearFractionBits) - past.x : past.x,
                        turn.y > 0 ? (1 << kShearFractionBits) - past.y : past.y);
    int first_x = ahead.x * abs(slope.y);
    int first_y = ahead.y * abs(slope.x);
    if (first_x < first_y)
        return cell + ivec2(turn.x, 0);
    if (first_y < first_x)
        return cell + ivec2(0, turn.y);
    return cell;
}

/// Where tap `tap` of `taps` looks for the cells of column (0, 0) in a slice: one tap takes the
/// cell at mid-slice; two take those that the line enters and leaves the slice in; three take the
/// one between, too, which makes all that the line passes.
SHARED_FN ivec2 shear_tap(ivec2 slope, int slice, int tap, int taps) {
    if (taps == 1)
        return ivec2(shear_offset(slope.x, slice), shear_offset(slope.y, slice));
    if (tap == 2)
        return shear_between(slope, slice);
    return ivec2(shear_at_face(slope.x, slice + tap), shear_at_face(slope.y, slice + tap)) >>
           kShearFractionBits;
}

/// A place among `count` <= 512 that repeat, for any place within 4096 of them. `inverse`:
/// 1 / count. Half a place from where periods begin, rounding, which is below a thousandth of a
/// place, decides nothing.
SHARED_FN int shear_wrapped(int place, int count, float inverse) {
    return place - int(floor((float(place) + 0.5f) * inverse)) * count;
}

SHARED_FN ivec2 shear_wrapped_column(ShearGrid grid, int m, ivec2 column) {
    ivec3 size = shear_turned(ivec3(grid.columns), m);
    vec3 inverse = shear_turned(vec3(grid.inverse), m);
    return ivec2(shear_wrapped(column.x, size.x, inverse.x),
                 shear_wrapped(column.y, size.y, inverse.y));
}

/// The first slice that is moved by `cells` or more, or all of them, `count`. `strict`: 1 if a tie
/// at mid-slice still counts as the cell before, as it does where slopes fall, else 0.
/// `steepness`: size of the slope, fixed point; `inverse`: slices per cell.
SHARED_FN int shear_first_moved(int cells, int steepness, float inverse, int strict, int count) {
    if (cells <= 0)
        return 0;
    // Wanted: the first slice with steepness (2 slice + 1) >= least. The estimate is right or one
    // too small: float rounding is below 0.001 of a slice, and a tie that is strict moves by one.
    int least = (2 * cells - 1) * (1 << kShearFractionBits) + strict;
    EXACT float middle = (float(cells) - 0.5f) * inverse - 0.501f;
    int slice = int(ceil(clamp(middle, 0.0f, float(count))));
    if (steepness * (2 * slice + 1) < least)
        ++slice;
    return min(slice, count);
}

/// What rays need to know of the columns at one place along p or q, unwrapped.
struct ShearPlace {
    int first;   ///< the first slice in which their own cells lie in the grid or its guard
    int end;     ///< the one after the last; there is none if `first` is not before it
    int wrapped; ///< the place of those that are kept
};

/// `columns`: along the axis, with the guard; `slope` and `slices_per_cell` along it; `slices`:
/// all.
SHARED_FN ShearPlace shear_place(int place, int columns, int guard, int slope,
                                 float slices_per_cell, int slices) {
    ShearPlace found;
    found.wrapped = shear_wrapped(place, columns, 1.0f / float(columns));
    bool falls = slope < 0;
    int from = place + guard; // 0: the first cell of the guard
    if (falls)
        from = columns - 1 - from; // seen in a mirror, all slopes rise
    int strict = falls ? 1 : 0;
    found.first = shear_first_moved(-from, abs(slope), slices_per_cell, strict, slices);
    found.end = shear_first_moved(columns - from, abs(slope), slices_per_cell, strict, slices);
    return found;
}

SHARED_FN ShearPlace shear_place_along_p(ShearGrid grid, ShearMap map, int place) {
    ivec3 size = shear_size(grid, map.slope.z);
    return shear_place(place, size.x, grid.columns.w, map.slope.x, map.scale.x, size.z);
}
SHARED_FN ShearPlace shear_place_along_q(ShearGrid grid, ShearMap map, int place) {
    ivec3 size = shear_size(grid, map.slope.z);
    return shear_place(place, size.y, grid.columns.w, map.slope.y, map.scale.y, size.z);
}

/// Leaves those slices of a span in which its column's own cell lies in the grid or its guard, and
/// wraps the column.
SHARED_FN RomaSpan shear_inside(RomaSpan span, ShearPlace along_p, ShearPlace along_q) {
    span.first = max(span.first, max(along_p.first, along_q.first));
    span.last = min(span.last, min(along_p.end, along_q.end) - 1);
    span.column = ivec2(along_p.wrapped, along_q.wrapped);
    return span;
}

// Tracing looks places up in a table: for each map those along p, then those along q, from the one
// that is farthest below the grid on; grid.row_words.w of each.

/// Columns beyond this many from the grid hold no cell.
SHARED_FN int shear_farthest(int slices) { return slices + 4; }

/// The entry of place 0 along p. That along q comes as many entries later as an axis has.
SHARED_FN int shear_first_entry(ShearGrid grid, int map, int slices) {
    return 2 * map * grid.row_words.w + shear_farthest(slices);
}

/// The place that an entry of the table is for.
SHARED_FN int shear_place_of_entry(int entry, int slices) { return entry - shear_farthest(slices); }

/// An entry: the interval, and what the place adds to that of the column's first texel. `texels`:
/// from a place to the next; `first_texel`: of the map, along one of the axes.
SHARED_FN uvec2 shear_packed(ShearPlace place, int texels, int first_texel) {
    return uvec2(uint(place.first) | uint(place.end) << 16,
                 uint(first_texel + place.wrapped * texels));
}

/// Leaves those slices of a span that both entries have; the column is then the first texel of it
/// in x.
SHARED_FN RomaSpan shear_cut(RomaSpan span, uvec2 along_p, uvec2 along_q) {
    span.first = max(span.first, int(max(along_p.x & 0xFFFFu, along_q.x & 0xFFFFu)));
    span.last = min(span.last, int(min(along_p.x >> 16, along_q.x >> 16)) - 1);
    span.column = ivec2(int(along_p.y + along_q.y), 0);
    return span;
}

/// A point in cells of the grid.
SHARED_FN vec3 shear_cells(ShearGrid grid, vec3 point) {
    EXACT vec3 cells = (point - vec3(grid.origin)) * grid.origin.w;
    return cells;
}

/// Aligned coordinates of what is given in cells along x, y and z; a point or a direction.
SHARED_FN vec3 shear_aligned(ShearMap map, vec3 cells) {
    int m = map.rays.z;
    float w = m == 0 ? cells.x : m == 1 ? cells.y : cells.z;
    EXACT vec3 foot = cells - vec3(map.along) * w;
    vec3 turned = shear_turned(foot, m);
    return vec3(turned.x, turned.y, w);
}

/// The column, unwrapped, that a place lies in, if the table has it. For places beyond those of the
/// table, which hold no cell, the first or last; for NaN the first.
SHARED_FN ivec2 shear_column(ShearGrid grid, ShearMap map, vec3 aligned) {
    float least = -float(shear_farthest(map.rays.y));
    float most = least + float(grid.row_words.w - 1);
    return ivec2(int(floor(roma_within(aligned.x, least, most))),
                 int(floor(roma_within(aligned.y, least, most))));
}

/// A snapped ray, not yet cut by shear_inside. `point`: the surface point, metres; `normal`: unit.
/// `t_max`: metres from the surface point, infinity allowed.
SHARED_FN RomaRay shear_ray(ShearGrid grid, ShearMap map, bool forward, vec3 point, vec3 normal,
                            float t_max) {
    int m = map.rays.z;
    vec3 surface = shear_cells(grid, point);
    EXACT vec3 moved = surface + normal * grid.inverse.w;
    vec3 start = shear_aligned(map, moved);
    EXACT float reach = t_max < kRomaUnbounded ? t_max * map.scale.z : t_max;
    RomaRay ray;
    ray.surface = m == 0 ? surface.x : m == 1 ? surface.y : surface.z;
    ray.forward = forward;
    ray.span = roma_slices(start.z, ray.surface, reach, forward, map.rays.y);
    ray.span.column = shear_column(grid, map, start);
    return ray;
}

/// A ray that keeps its direction; the others as for shear_ray.
SHARED_FN RomaWalk shear_walk(ShearGrid grid, ShearMap map, vec3 point, vec3 normal, vec3 direction,
                              float t_max) {
    int m = map.slope.z;
    vec3 surface = shear_cells(grid, point);
    EXACT vec3 moved = surface + normal * grid.inverse.w;
    EXACT vec3 scaled = direction * grid.origin.w;
    vec3 turned = shear_turned(scaled, m);
    EXACT vec3 step = turned * abs(roma_reciprocal(turned.z));
    vec2 inside = roma_way_inside(shear_turned(moved, m), step, vec3(shear_size(grid, m)));
    return roma_walk(shear_aligned(map, moved), shear_turned(surface, m).z,
                     shear_aligned(map, scaled), inside, t_max);
}

/// Whether a direction points to the candidate's side, rather than to its opposite's.
SHARED_FN bool shear_is_forward(ShearMap map, vec3 direction) {
    EXACT float cosine =
        direction.x * map.along.x + direction.y * map.along.y + direction.z * map.along.z;
    return cosine >= 0.0f;
}

/// Place of the texel of a wrapped column; `part` of `parts`.
SHARED_FN int shear_texel(ShearMap map, int columns_along_p, ivec2 column, int part, int parts) {
    return map.slope.w + (column.y * columns_along_p + column.x) * parts + part;
}

#ifdef __cplusplus
} // namespace romascope::gpu
#endif
