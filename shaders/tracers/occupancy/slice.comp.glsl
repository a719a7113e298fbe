// SPDX-License-Identifier: MIT
// View: a slice of the base occupancy map, at right angles to an axis of the world. White: occupied,
// black: empty, blue: outside the map. Seen along the axis: x to the right and y up for z, z to the
// right and y up for x, x to the right and z down for y.
//
// In:   base_map R32UI, see base_map.glsl
// Out:  picture RGBA32F
// Host: grid_size, cells; axis: 0 x, 1 y, 2 z; picture_size, slice
#include "shaders/tracers/cells.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(rgba32f, binding = 0) writeonly uniform image2D picture;
uniform ivec3 grid_size;
#include "shaders/tracers/occupancy/base_map.glsl"
layout(binding = 0) uniform BASE_MAP_SAMPLER base_map;
uniform int axis;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, picture_size)))
        return;
    ivec2 plane = axis == 0 ? grid_size.zy : axis == 1 ? grid_size.xz : grid_size.xy;
    ivec2 place = cell_at(pixel, plane);
    vec3 color = kOutsideColor;
    if (place.x >= 0) {
        int depth = chosen_slice(grid_size[axis]);
        int up = plane.y - 1 - place.y;
        ivec3 cell = axis == 0   ? ivec3(depth, up, place.x)
                     : axis == 1 ? ivec3(place.x, depth, place.y)
                                 : ivec3(place.x, up, depth);
        uint word = FETCH_BASE_MAP(base_map, cell);
        color = vec3(float((word >> (cell.z & 31)) & 1u));
    }
    imageStore(picture, pixel, vec4(color, 1.0));
}
