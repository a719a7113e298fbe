// SPDX-License-Identifier: MIT
// Views of structures made of cells: a plane of cells as squares, as large as fits, in the middle of
// the picture.
//
// Host: picture_size; slice: which plane, as a fraction of the planes there are
#include "shaders/common/letterbox.h"

uniform ivec2 picture_size;
uniform float slice;

/// What surrounds the cells; those are grey.
const vec3 kOutsideColor = vec3(0.02, 0.05, 0.2);

/// The cell of a plane of so many cells that this pixel shows, row 0 at the top; negative: none.
ivec2 cell_at(ivec2 pixel, ivec2 cells) {
    ivec2 size = letterbox_size(cells, picture_size);
    ivec2 place = pixel - letterbox_corner(size, picture_size);
    if (any(lessThan(place, ivec2(0))) || any(greaterThanEqual(place, size)))
        return ivec2(-1);
    return place * cells / size;
}

/// Which of `count` planes is shown.
int chosen_slice(int count) { return min(int(slice * float(count)), count - 1); }
