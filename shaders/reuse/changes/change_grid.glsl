// SPDX-License-Identifier: MIT
// The grid of blocks as the host sets it.
//
// Host: grid_origin, metres; blocks_per_metre; grid_size, blocks
#include "shaders/reuse/changes/change_grid.h"

uniform vec3 grid_origin;
uniform float blocks_per_metre;
uniform ivec3 grid_size;

ChangeGrid change_grid() { return ChangeGrid(grid_origin, blocks_per_metre, grid_size); }
