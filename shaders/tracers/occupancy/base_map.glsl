// SPDX-License-Identifier: MIT
// The base occupancy map for shaders that take it from a texture or from a buffer.
//
// Host: BASE_MAP_IN_BUFFER 0 or 1; grid_size, cells, before this
#include "shaders/tracers/occupancy/base_map.h"

#if BASE_MAP_IN_BUFFER
#define BASE_MAP_IMAGE uimageBuffer
#define BASE_MAP_SAMPLER usamplerBuffer
#define BASE_MAP_PLACE int
int place_in_base_map(ivec3 cell) { return base_place(grid_size, cell.x, cell.y, cell.z >> 5); }
#define FETCH_BASE_MAP(map, cell) texelFetch(map, place_in_base_map(cell)).x
#else
#define BASE_MAP_IMAGE uimage3D
#define BASE_MAP_SAMPLER usampler3D
#define BASE_MAP_PLACE ivec3
ivec3 place_in_base_map(ivec3 cell) { return ivec3(cell.xy, cell.z >> 5); }
#define FETCH_BASE_MAP(map, cell) texelFetch(map, place_in_base_map(cell), 0).x
#endif
