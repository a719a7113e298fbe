// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/piece.h"

#include "renderer/scene/gltf/accessor.h"
#include "renderer/scene/gltf/numbers.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <numeric>

namespace romascope::gltf {
namespace {

/// Floats, and what KHR_mesh_quantization allows besides.
const std::vector<int> kVertexTypes = {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_BYTE,
                                       TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
                                       TINYGLTF_COMPONENT_TYPE_SHORT,
                                       TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT};

/// A strip's or fan's corners as separate triangles (glTF 2.0, 3.7.2.1).
std::vector<uint32_t> to_list(std::vector<uint32_t> corners, int mode, const std::string& element) {
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        if (corners.size() % 3 != 0)
            refuse(element, fmt::format("{} corners do not make triangles", corners.size()));
        return corners;
    }
    if (corners.size() < 3)
        refuse(element, fmt::format("{} corners do not make a triangle", corners.size()));
    std::vector<uint32_t> list;
    list.reserve(3 * (corners.size() - 2));
    for (size_t i = 0; i + 2 < corners.size(); ++i) {
        const bool fan = mode == TINYGLTF_MODE_TRIANGLE_FAN;
        const uint32_t a = fan ? corners[i + 1] : corners[i];
        const uint32_t b = fan ? corners[i + 2] : corners[i + 1 + i % 2];
        const uint32_t c = fan ? corners[0] : corners[i + 2 - i % 2];
        if (a != b && b != c && c != a)
            list.insert(list.end(), {a, b, c});
    }
    return list;
}

/// Keeps the vertices that corners use, in their order, and renumbers the corners: primitives may
/// share one large buffer, and a small file must not become a huge scene by it.
void keep_used(Piece& piece) {
    const auto [low, high] = std::ranges::minmax(piece.corners);
    const size_t range = size_t{high} - low + 1;
    if (range <= 4 * piece.corners.size()) {
        std::vector<uint32_t> place(range, 0);
        for (const uint32_t corner : piece.corners)
            place[corner - low] = 1;
        for (size_t i = 0; i < range; ++i)
            if (place[i] != 0) {
                place[i] = static_cast<uint32_t>(piece.sources.size());
                piece.sources.push_back(static_cast<uint32_t>(low + i));
            }
        for (uint32_t& corner : piece.corners)
            corner = place[corner - low];
        return;
    }
    piece.sources = piece.corners;
    std::ranges::sort(piece.sources);
    piece.sources.erase(std::unique(piece.sources.begin(), piece.sources.end()),
                        piece.sources.end());
    for (uint32_t& corner : piece.corners)
        corner = static_cast<uint32_t>(std::ranges::lower_bound(piece.sources, corner) -
                                       piece.sources.begin());
}

int attribute(const tinygltf::Primitive& primitive, const std::string& name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? -1 : found->second;
}

void expect_count(size_t count, size_t vertex_count, const std::string& element) {
    if (count != vertex_count)
        refuse(element, fmt::format("{} elements for {} vertices", count, vertex_count));
}

std::vector<glm::vec3> read_vectors(const Document& document, int accessor,
                                    const std::vector<uint32_t>& sources, size_t vertex_count,
                                    const std::string& element) {
    const AccessorReader reader(document, accessor, {TINYGLTF_TYPE_VEC3, kVertexTypes}, element);
    expect_count(reader.count(), vertex_count, element);
    std::vector<glm::vec3> values(sources.size());
    for (size_t i = 0; i < values.size(); ++i) {
        values[i] = reader.vec3(sources[i]);
        const glm::vec3 size = glm::abs(values[i]);
        if (std::max({size.x, size.y, size.z}) > kMaxCoordinate)
            refuse(element, fmt::format("element {} is beyond {}", sources[i], kMaxCoordinate));
    }
    return values;
}

/// Makes normals unit length. One that is zero becomes that of a triangle it belongs to.
void repair_normals(Piece& piece) {
    bool missing = false;
    for (glm::vec3& normal : piece.normals) {
        const double length = glm::length(glm::dvec3(normal));
        missing |= length == 0.0;
        normal = length > 0.0 ? glm::vec3(glm::dvec3(normal) / length) : glm::vec3(0.0f);
    }
    for (size_t i = 0; missing && i < piece.corners.size(); ++i) {
        glm::vec3& normal = piece.normals[piece.corners[i]];
        const auto at = [&](size_t k) { return piece.positions[piece.corners[i - i % 3 + k]]; };
        if (normal == glm::vec3(0.0f))
            normal = face_normal(at(0), at(1), at(2));
    }
}

void read_texcoords(const Document& document, const tinygltf::Primitive& primitive,
                    const TexcoordSource& source, Piece& piece, Notices& notices) {
    if (source.set < 0)
        return;
    const std::string name = fmt::format("TEXCOORD_{}", source.set);
    const int accessor = attribute(primitive, name);
    piece.texcoords.resize(piece.sources.size(), glm::vec2(0.0f));
    if (accessor < 0) {
        notices.add(piece.element, "has no texture coordinates for its texture");
        return;
    }
    const std::string element = fmt::format("{}.attributes.{}", piece.element, name);
    const AccessorReader reader(document, accessor, {TINYGLTF_TYPE_VEC2, kVertexTypes}, element);
    expect_count(reader.count(), piece.vertex_count, element);
    for (size_t i = 0; i < piece.sources.size(); ++i) {
        const glm::dvec3 moved =
            source.transform * glm::dvec3(glm::dvec2(reader.vec2(piece.sources[i])), 1.0);
        // Beyond this a float has no place left between two texels; glTF sets no bound.
        piece.texcoords[i] = glm::vec2(glm::clamp(glm::dvec2(moved), -1e6, 1e6));
    }
}

void read_colors(const Document& document, const tinygltf::Primitive& primitive, Piece& piece) {
    const int accessor = attribute(primitive, "COLOR_0");
    if (accessor < 0)
        return;
    const std::string element = piece.element + ".attributes.COLOR_0";
    const std::vector<int> types = {TINYGLTF_COMPONENT_TYPE_FLOAT,
                                    TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
                                    TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT};
    const bool alpha =
        document.model().accessors[static_cast<size_t>(accessor)].type == TINYGLTF_TYPE_VEC4;
    const AccessorReader reader(document, accessor,
                                {alpha ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3, types}, element);
    expect_count(reader.count(), piece.vertex_count, element);
    piece.colors.resize(piece.sources.size(), 0);
    for (size_t i = 0; i < piece.sources.size(); ++i)
        for (int c = 0; c < 4; ++c) {
            const float value = c < 3 || alpha ? reader.number(piece.sources[i], c) : 1.0f;
            const float byte = std::round(255.0f * std::clamp(value, 0.0f, 1.0f));
            piece.colors[i] |= static_cast<uint32_t>(byte) << (8 * c);
        }
}

std::vector<uint32_t> read_corners(const Document& document, const tinygltf::Primitive& primitive,
                                   const Piece& piece, MemoryBudget& budget) {
    std::vector<uint32_t> corners;
    if (primitive.indices >= 0) {
        const auto& accessor = document.model().accessors[static_cast<size_t>(primitive.indices)];
        budget.take(accessor.count, 4 * sizeof(uint32_t), piece.element + ".indices");
        corners = read_indices(document, primitive.indices, piece.vertex_count,
                               piece.element + ".indices");
        budget.give(accessor.count * 4 * sizeof(uint32_t));
    } else {
        if (piece.vertex_count > UINT32_MAX)
            refuse(piece.element, "too many vertices");
        budget.take(piece.vertex_count, 4 * sizeof(uint32_t), piece.element);
        corners.resize(piece.vertex_count);
        std::iota(corners.begin(), corners.end(), 0u);
        budget.give(piece.vertex_count * 4 * sizeof(uint32_t));
    }
    return to_list(std::move(corners), primitive.mode, piece.element);
}

} // namespace

glm::vec3 face_normal(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    return length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f);
}

size_t Piece::bytes() const {
    return (sources.size() + corners.size() + colors.size()) * sizeof(uint32_t) +
           (positions.size() + normals.size()) * sizeof(glm::vec3) +
           texcoords.size() * sizeof(glm::vec2);
}

std::optional<Piece> read_piece(const Document& document, size_t mesh, size_t primitive,
                                const Materials& materials, MemoryBudget& budget,
                                Notices& notices) {
    const tinygltf::Primitive& source = document.model().meshes[mesh].primitives[primitive];
    Piece piece;
    piece.element = fmt::format("meshes[{}].primitives[{}]", mesh, primitive);
    piece.mesh = mesh;
    piece.primitive = primitive;
    piece.material = source.material;
    if (source.mode < TINYGLTF_MODE_TRIANGLES) {
        notices.add(piece.element, "points and lines are left out");
        return std::nullopt;
    }
    const int position = attribute(source, "POSITION");
    if (position < 0) {
        notices.add(piece.element, "has no positions, and is left out");
        return std::nullopt;
    }
    piece.vertex_count = document.model().accessors[static_cast<size_t>(position)].count;
    // Without a view a few bytes of JSON stand for any number of points at 0; one shows them all.
    if (document.model().accessors[static_cast<size_t>(position)].bufferView < 0)
        piece.corners = {0, 0, 0};
    else
        piece.corners = read_corners(document, source, piece, budget);
    if (piece.corners.empty())
        return std::nullopt;
    budget.take(piece.corners.size(), 64, piece.element); // more than any vertex or index takes
    keep_used(piece);
    piece.positions = read_vectors(document, position, piece.sources, piece.vertex_count,
                                   piece.element + ".attributes.POSITION");
    if (const int normal = attribute(source, "NORMAL"); normal >= 0) {
        piece.normals = read_vectors(document, normal, piece.sources, piece.vertex_count,
                                     piece.element + ".attributes.NORMAL");
        repair_normals(piece);
    }
    read_texcoords(document, source, materials.texcoords(piece.material), piece, notices);
    read_colors(document, source, piece);
    budget.give(piece.corners.size() * 64);
    budget.take(piece.bytes(), 1, piece.element);
    return piece;
}

std::vector<MorphDelta> read_deltas(const Document& document, const Piece& piece) {
    const auto& targets = document.model().meshes[piece.mesh].primitives[piece.primitive].targets;
    std::vector<MorphDelta> deltas(targets.size() * piece.sources.size());
    for (size_t t = 0; t < targets.size(); ++t) {
        const size_t first = t * piece.sources.size();
        const auto read = [&](const char* name, glm::vec3 MorphDelta::*member) {
            const auto found = targets[t].find(name);
            if (found == targets[t].end())
                return;
            const auto values =
                read_vectors(document, found->second, piece.sources, piece.vertex_count,
                             fmt::format("{}.targets[{}].{}", piece.element, t, name));
            for (size_t i = 0; i < values.size(); ++i)
                deltas[first + i].*member = values[i];
        };
        read("POSITION", &MorphDelta::position);
        if (!piece.normals.empty())
            read("NORMAL", &MorphDelta::normal);
    }
    return deltas;
}

} // namespace romascope::gltf
