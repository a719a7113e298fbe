// SPDX-License-Identifier: MIT
// After triangles were marked: remembers where vertices are that have moved by more than the
// tolerance. Others keep what they had, so that slow moves add up.
//
// In, out, host: see followed_vertices.glsl; vertex_count: that move
#include "shaders/reuse/changes/change_grid.h"
#include "shaders/reuse/changes/followed_vertices.glsl"
#include "shaders/tracers/occupancy/work_list.h"

layout(local_size_x = 64) in;
uniform uint vertex_count;

void main() {
    uint index = gl_GlobalInvocationID.y * kTriangleRow + gl_GlobalInvocationID.x;
    if (index >= vertex_count)
        return;
    uint vertex = first_vertex + index;
    vec3 now = position_of(vertex);
    if (!has_moved(followed_position(vertex), now, tolerance))
        return;
    for (uint axis = 0u; axis < 3u; ++axis)
        followed[3u * index + axis] = now[axis];
}
