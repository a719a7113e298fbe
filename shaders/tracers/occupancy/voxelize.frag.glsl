// SPDX-License-Identifier: MIT
// Marks the cell of the fragment as occupied (Zeng et al. 2023, section 6: three axes, joined).
//
// Out:  base_map R32UI, see base_map.glsl
// Host: uniforms grid_size (cells), axis; ALPHA_MASK 0 or 1: leave out what the mask leaves out
uniform ivec3 grid_size;
#include "shaders/tracers/occupancy/base_map.glsl" // before the choice: a file is taken once
#if ALPHA_MASK
#include "shaders/common/material.glsl"
flat in uint material_index;
in vec2 surface_uv;
in float surface_vertex_alpha;
#endif
layout(r32ui, binding = 0) uniform BASE_MAP_IMAGE base_map;
uniform int axis;
in float depth_in_cells;

void main() {
    // Where the rasteriser's own rounding, 1/128 of a cell, moves the depth by a cell or more, what
    // is hit is chance; another axis looks at this triangle from a better side.
    if (fwidth(depth_in_cells) > 128.0)
        discard;
#if ALPHA_MASK
    if (!surface_is_there(material_index, surface_uv, surface_vertex_alpha))
        discard;
#endif
    ivec2 across = ivec2(gl_FragCoord.xy);
    int depth = int(floor(depth_in_cells));
    ivec3 cell = axis == 0 ? ivec3(depth, across) : axis == 1 ? ivec3(across.y, depth, across.x) : ivec3(across, depth);
    cell = clamp(cell, ivec3(0), grid_size - 1); // interpolation may overshoot a steep triangle
    imageAtomicOr(base_map, place_in_base_map(cell), 1u << (cell.z & 31));
}
