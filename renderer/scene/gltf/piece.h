// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/gltf/material.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace romascope::gltf {

/// The triangles of one primitive in the space of its mesh, with the vertices they use.
struct Piece {
    std::string element; ///< "meshes[m].primitives[p]"
    size_t mesh = 0, primitive = 0;
    int material = -1;                ///< of the file
    size_t vertex_count = 0;          ///< of the file's accessors
    std::vector<uint32_t> sources;    ///< per vertex: its number in the file's accessors
    std::vector<uint32_t> corners;    ///< three per triangle, counter-clockwise from outside
    std::vector<glm::vec3> positions; ///< per vertex
    std::vector<glm::vec3> normals;   ///< unit length or zero; empty: none given
    std::vector<glm::vec2> texcoords; ///< empty: the material has no texture
    std::vector<uint32_t> colors;     ///< RGBA8 linear; empty: white

    size_t bytes() const;
};

/// Reads a primitive; nothing for points, lines and primitives without triangles.
/// Triangles that only repeat a corner, as strips do to be joined, are left out.
/// Throws Error (kBadInput) naming the element at fault.
std::optional<Piece> read_piece(const Document& document, size_t mesh, size_t primitive,
                                const Materials& materials, MemoryBudget& budget, Notices& notices);

/// Unit normal of a triangle, zero if it has no area. In double, so that the products of small
/// edges do not underflow.
glm::vec3 face_normal(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c);

/// Morph targets: for each in turn, how far it moves each vertex of the piece.
std::vector<MorphDelta> read_deltas(const Document& document, const Piece& piece);

} // namespace romascope::gltf
