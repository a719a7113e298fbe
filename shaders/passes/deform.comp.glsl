// SPDX-License-Identifier: MIT
// Moves vertices from rest to a pose: morph targets, then the matrix of the node or the mean of the
// joints' matrices (glTF 2.0, 3.7.2.2 and 3.7.3). One invocation a vertex.
//
// In:   parts, in the order of their vertices; rest: of all moving vertices the positions, then the
//       normals (0: the triangle's own); influences of 6 words: joints as 4 times 16 bits, weights;
//       deltas of 6 floats: position, normal; palette: 3 rows a matrix; weights of morph targets
// Out:  positions, normals: those of moving vertices from `first_float` on
// Host: part_count, vertex_count, first_float
#include "shaders/passes/deform_shared.h"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Parts { DeformPart parts[]; };
layout(std430, binding = 1) readonly buffer Rest { float rest[]; };
layout(std430, binding = 2) readonly buffer Influences { uint influences[]; };
layout(std430, binding = 3) readonly buffer Deltas { float deltas[]; };
layout(std430, binding = 4) readonly buffer Palette { vec4 palette[]; };
layout(std430, binding = 5) readonly buffer Weights { float weights[]; };
layout(std430, binding = 6) writeonly buffer Positions { float positions[]; };
layout(std430, binding = 7) writeonly buffer Normals { float normals[]; };
uniform uint part_count;
uniform uint vertex_count;
uniform uint first_float;

/// The last part that does not begin after the vertex.
uint part_of(uint vertex) {
    uint part = 0u;
    for (int bit = findMSB(part_count); bit >= 0; --bit) {
        uint candidate = part + (1u << bit);
        if (candidate < part_count && parts[candidate].first_vertex <= vertex)
            part = candidate;
    }
    return part;
}

/// Rows of the matrix that a vertex of a part goes through.
mat3x4 rows_of(DeformPart part, uint place) {
    if (part.influence_sets == 0u) {
        uint at = 3u * part.first_matrix;
        return mat3x4(palette[at], palette[at + 1u], palette[at + 2u]);
    }
    mat3x4 rows = mat3x4(0.0);
    uint first = part.first_influence + place * part.influence_sets;
    for (uint i = 0u; i < 4u * part.influence_sets; ++i) {
        uint at = 6u * (first + i / 4u);
        uint pair = influences[at + (i % 4u) / 2u];
        uint joint = (i & 1u) == 0u ? pair & 0xffffu : pair >> 16;
        uint row = 3u * (part.first_matrix + joint);
        float weight = uintBitsToFloat(influences[at + 2u + i % 4u]);
        rows += weight * mat3x4(palette[row], palette[row + 1u], palette[row + 2u]);
    }
    return rows;
}

/// By the cofactors, which are the inverse transpose times the determinant. 0 if nothing is left.
vec3 moved_normal(mat3x4 rows, vec3 normal) {
    vec3 x = rows[0].xyz;
    vec3 y = rows[1].xyz;
    vec3 z = rows[2].xyz;
    vec3 sizes = max(max(abs(x), abs(y)), abs(z));
    float largest = max(max(sizes.x, sizes.y), sizes.z);
    if (!(largest > 0.0))
        return vec3(0.0);
    x /= largest; // products of three must not underflow
    y /= largest;
    z /= largest;
    vec3 turned = vec3(dot(cross(y, z), normal), dot(cross(z, x), normal), dot(cross(x, y), normal));
    float size = length(turned);
    return size > 0.0 ? (dot(x, cross(y, z)) < 0.0 ? -turned : turned) / size : vec3(0.0);
}

void main() {
    uint vertex = gl_GlobalInvocationID.y * kDeformRow + gl_GlobalInvocationID.x;
    if (vertex >= vertex_count)
        return;
    DeformPart part = parts[part_of(vertex)];
    uint place = vertex - part.first_vertex;

    uint at = 3u * vertex;
    vec3 position = vec3(rest[at], rest[at + 1u], rest[at + 2u]);
    at += 3u * vertex_count;
    vec3 normal = vec3(rest[at], rest[at + 1u], rest[at + 2u]);
    bool has_normal = normal != vec3(0.0);
    for (uint target = 0u; target < part.target_count; ++target) {
        float weight = weights[part.first_weight + target];
        uint delta = 6u * (part.first_delta + target * part.vertex_count + place);
        position += weight * vec3(deltas[delta], deltas[delta + 1u], deltas[delta + 2u]);
        normal += weight * vec3(deltas[delta + 3u], deltas[delta + 4u], deltas[delta + 5u]);
    }
    mat3x4 rows = rows_of(part, place);
    position = vec4(position, 1.0) * rows;
    normal = has_normal ? moved_normal(rows, normal) : vec3(0.0);

    at = first_float + 3u * vertex;
    for (uint axis = 0u; axis < 3u; ++axis) {
        positions[at + axis] = position[axis];
        normals[at + axis] = normal[axis];
    }
}
