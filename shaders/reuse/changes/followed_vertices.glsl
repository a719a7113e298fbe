// SPDX-License-Identifier: MIT
// Vertices that move, as they are and as they were when they were last found to have moved.
//
// Host: storage blocks 0 positions, three floats a vertex of the scene, 1 followed, likewise from
//       first_vertex on; tolerance: metres
layout(std430, binding = 0) readonly buffer Positions { float positions[]; };
layout(std430, binding = 1) buffer Followed { float followed[]; };
uniform uint first_vertex;
uniform float tolerance;

vec3 position_of(uint vertex) {
    uint at = 3u * vertex;
    return vec3(positions[at], positions[at + 1u], positions[at + 2u]);
}

/// `vertex`: from first_vertex on.
vec3 followed_position(uint vertex) {
    uint at = 3u * (vertex - first_vertex);
    return vec3(followed[at], followed[at + 1u], followed[at + 2u]);
}
