// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/tracers/occupancy/bit_grid.h"
#include "shaders/tracers/roma/roma_shared.h"

namespace romascope {

/// The box of one aligned map: its third axis is the candidate direction; it encloses the scene as
/// tightly as boxes of that orientation can. Cut into side^3 cells, which need not be cubes.
struct AlignedBox {
    glm::dvec3 centre{0.0};
    glm::dmat3 axes{1.0}; ///< columns: unit axes u, v, w
    glm::dvec3 cell{1.0}; ///< metres along u, v, w

    /// For a scene within `bounds` whose occupied cells, of size `margin`, reach up to one cell
    /// beyond them. The turn about the direction is the one with the smallest cross section.
    static AlignedBox around(const Bounds& bounds, double margin, glm::dvec3 direction, int side);

    /// The cube around the scene whatever way it is turned, turned as the above.
    static AlignedBox enclosing(const Bounds& bounds, double margin, glm::dvec3 direction,
                                int side);
};

/// The cell that the normal offset is counted in, in metres: that of a cube which encloses the
/// scene whatever way it is turned, as published. No aligned box has a longer one, and rays of all
/// candidates start at the same point.
double enclosing_cell(const Bounds& bounds, double margin, int side);

/// What the shaders need to know of an aligned map. `offset`: how far rays start off their surface,
/// metres.
gpu::RomaDirection aligned_map(const AlignedBox& box, int side, const OccupancyGrid& grid,
                               double offset);

} // namespace romascope
