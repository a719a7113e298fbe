// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/draco_header.h"
#include "tests/support/gltf_builder.h"
#include "tests/support/opened_gltf.h"

#include <draco/compression/expert_encode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

namespace romascope::gltf {
namespace {

using nlohmann::json;

struct Corner {
    std::array<float, 3> position;
    std::array<float, 2> texcoord;
    std::array<uint16_t, 4> joints;
    auto operator<=>(const Corner&) const = default;
};
using Triangle = std::array<Corner, 3>;

/// Starts at the least corner, so that turning makes no difference.
Triangle turned(Triangle triangle) {
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                triangle.end());
    return triangle;
}

/// A grid of `size` times `size` squares, bent; with a seam of texture coordinates in the middle.
struct Grid {
    explicit Grid(uint32_t size) {
        for (uint32_t row = 0; row <= size; ++row)
            for (uint32_t i = 0; i <= size; ++i) {
                const auto x = static_cast<float>(i), y = static_cast<float>(row);
                corners.push_back(
                    {{x, y, std::sin(x) * std::cos(0.5f * y)},
                     {x / 7.0f, y / 3.0f},
                     {static_cast<uint16_t>(i), static_cast<uint16_t>(row), 3, 65535}});
            }
        const auto at = [&](uint32_t row, uint32_t i) { return row * (size + 1) + i; };
        for (uint32_t row = 0; row < size; ++row)
            for (uint32_t i = 0; i < size; ++i) {
                faces.push_back({at(row, i), at(row, i + 1), at(row + 1, i)});
                faces.push_back({at(row, i + 1), at(row + 1, i + 1), at(row + 1, i)});
            }
        // The right half gets vertices of its own with other texture coordinates.
        for (auto& face : faces)
            for (uint32_t& corner : face)
                if (corners[corner].position[0] >= static_cast<float>(size / 2) &&
                    corners[face[0]].position[0] + corners[face[1]].position[0] +
                            corners[face[2]].position[0] >
                        1.5f * static_cast<float>(size)) {
                    Corner other = corners[corner];
                    other.texcoord[0] += 100.0f;
                    corners.push_back(other);
                    corner = static_cast<uint32_t>(corners.size() - 1);
                }
    }
    std::vector<Triangle> triangles() const {
        std::vector<Triangle> list;
        for (const auto& face : faces)
            list.push_back(turned({corners[face[0]], corners[face[1]], corners[face[2]]}));
        std::ranges::sort(list);
        return list;
    }
    std::vector<Corner> corners;
    std::vector<std::array<uint32_t, 3>> faces;
};

struct Encoded {
    std::string bytes;
    size_t points = 0, faces = 0;
};

/// Attributes 0: position, 1: texture coordinates, 2: joints.
Encoded encode(const Grid& grid, int method, int speed, int quantization = 0) {
    draco::Mesh mesh;
    const auto points = static_cast<uint32_t>(grid.corners.size());
    mesh.set_num_points(points);
    const auto add = [&](draco::GeometryAttribute::Type type, int8_t components,
                         draco::DataType number, size_t size, const auto& value) {
        draco::GeometryAttribute attribute;
        attribute.Init(type, nullptr, components, number, false,
                       static_cast<int64_t>(size) * components, 0);
        const int id = mesh.AddAttribute(attribute, true, points);
        for (uint32_t i = 0; i < points; ++i)
            mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i),
                                                  value(grid.corners[i]));
    };
    add(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32, 4,
        [](const Corner& corner) { return corner.position.data(); });
    add(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32, 4,
        [](const Corner& corner) { return corner.texcoord.data(); });
    add(draco::GeometryAttribute::GENERIC, 4, draco::DT_UINT16, 2,
        [](const Corner& corner) { return corner.joints.data(); });
    for (const auto& face : grid.faces)
        mesh.AddFace(
            {draco::PointIndex(face[0]), draco::PointIndex(face[1]), draco::PointIndex(face[2])});
    mesh.DeduplicateAttributeValues();
    mesh.DeduplicatePointIds();
    draco::ExpertEncoder encoder(mesh);
    encoder.SetEncodingMethod(method);
    encoder.SetSpeedOptions(speed, speed);
    encoder.SetTrackEncodedProperties(true);
    if (quantization)
        encoder.SetAttributeQuantization(0, quantization);
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeToBuffer(&buffer).ok());
    return {std::string(buffer.data(), buffer.size()), encoder.num_encoded_points(),
            encoder.num_encoded_faces()};
}

GltfBuilder draco_file(const Encoded& encoded) {
    GltfBuilder file;
    const size_t view = file.add_view(encoded.bytes);
    const auto add = [&](const char* type, int component, size_t count) {
        return file.add("accessors",
                        {{"componentType", component}, {"count", count}, {"type", type}});
    };
    const size_t position = add("VEC3", 5126, encoded.points);
    const size_t texcoord = add("VEC2", 5126, encoded.points);
    const size_t joints = add("VEC4", 5123, encoded.points);
    const size_t indices = add("SCALAR", 5123, 3 * encoded.faces);
    const json extension = {{"bufferView", view},
                            {"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}, {"JOINTS_0", 2}}}};
    file.add_mesh({{"POSITION", position}, {"TEXCOORD_0", texcoord}, {"JOINTS_0", joints}});
    json& primitive = file.root["meshes"][0]["primitives"][0];
    primitive["indices"] = indices;
    primitive["extensions"]["KHR_draco_mesh_compression"] = extension;
    file.root["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    return file;
}

std::vector<Triangle> decoded_triangles(const OpenedGltf& opened, size_t which = 0) {
    const auto& primitive = opened.document.model().meshes[0].primitives[which];
    const auto reader = [&](const char* name) {
        return opened.reader(static_cast<size_t>(primitive.attributes.at(name)));
    };
    const AccessorReader positions = reader("POSITION");
    const AccessorReader texcoords = reader("TEXCOORD_0");
    const AccessorReader joints = reader("JOINTS_0");
    const auto indices =
        read_indices(opened.document, primitive.indices, positions.count(), "user");
    std::vector<Triangle> list;
    for (size_t i = 0; i < indices.size(); i += 3) {
        Triangle triangle;
        for (size_t c = 0; c < 3; ++c) {
            const uint32_t vertex = indices[i + c];
            for (int k = 0; k < 3; ++k)
                triangle[c].position[static_cast<size_t>(k)] = positions.number(vertex, k);
            for (int k = 0; k < 2; ++k)
                triangle[c].texcoord[static_cast<size_t>(k)] = texcoords.number(vertex, k);
            for (int k = 0; k < 4; ++k)
                triangle[c].joints[static_cast<size_t>(k)] =
                    static_cast<uint16_t>(joints.integer(vertex, k));
        }
        list.push_back(turned(triangle));
    }
    std::ranges::sort(list);
    return list;
}

constexpr int kSequential = draco::MESH_SEQUENTIAL_ENCODING;
constexpr int kEdgebreaker = draco::MESH_EDGEBREAKER_ENCODING;

TEST(Draco, every_method_and_speed_gives_the_triangles_back) {
    for (const uint32_t size : {2u, 3u, 15u, 60u})
        for (const int method : {kSequential, kEdgebreaker})
            for (const int speed : {0, 3, 5, 8, 10}) {
                const Grid grid(size);
                const OpenedGltf opened(draco_file(encode(grid, method, speed)).glb());
                EXPECT_EQ(decoded_triangles(opened), grid.triangles())
                    << size << " " << method << " " << speed;
                const auto& primitive = opened.document.model().meshes[0].primitives[0];
                EXPECT_TRUE(primitive.extensions.empty());
            }
}

TEST(Draco, quantised_positions_are_near) {
    const Grid grid(20);
    const OpenedGltf opened(draco_file(encode(grid, kEdgebreaker, 0, 12)).glb());
    const auto& primitive = opened.document.model().meshes[0].primitives[0];
    const auto reader = [&](const char* name) {
        return opened.reader(static_cast<size_t>(primitive.attributes.at(name)));
    };
    const AccessorReader positions = reader("POSITION");
    const AccessorReader joints = reader("JOINTS_0");
    for (size_t i = 0; i < positions.count(); ++i) {
        // Joints tell which vertex it was. One step is 20 / 4095.
        EXPECT_NEAR(positions.number(i, 0), static_cast<float>(joints.integer(i, 0)), 0.003f);
        EXPECT_NEAR(positions.number(i, 1), static_cast<float>(joints.integer(i, 1)), 0.003f);
    }
}

TEST(Draco, header_tells_what_comes) {
    const Grid grid(15);
    for (const int method : {kSequential, kEdgebreaker}) {
        const Encoded encoded = encode(grid, method, 5);
        const DracoHeader header =
            read_draco_header(std::as_bytes(std::span(encoded.bytes)), "here");
        EXPECT_EQ(header.faces, encoded.faces);
        EXPECT_LE(header.vertices, encoded.points);
        EXPECT_GE(header.vertices, 16u * 16u);
    }
}

TEST(Draco, primitives_that_share_data_share_what_is_decoded) {
    const Grid grid(10);
    GltfBuilder file = draco_file(encode(grid, kEdgebreaker, 5));
    json& primitives = file.root["meshes"][0]["primitives"];
    for (int i = 0; i < 50; ++i)
        primitives.push_back(primitives[0]);
    const OpenedGltf opened(file.glb());
    const auto& model = opened.document.model();
    EXPECT_EQ(model.accessors.size(), 8u);
    EXPECT_EQ(decoded_triangles(opened, 50), grid.triangles());
}

TEST(Draco, data_that_is_not_what_the_accessors_announce_is_refused) {
    const Encoded encoded = encode(Grid(10), kEdgebreaker, 5);
    const std::string element = "meshes[0].primitives[0].extensions.KHR_draco_mesh_compression";
    const auto with = [&](const std::function<void(json&)>& change) {
        GltfBuilder file = draco_file(encoded);
        change(file.root);
        return refusal_of(file.glb());
    };
    const auto extension = [](json& root) -> json& {
        return root["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"];
    };
    EXPECT_EQ(with([](json&) {}), "");
    EXPECT_CONTAINS(with([](json& root) { root["accessors"][3]["count"] = 597; }),
                    element + ": its Draco data has 200 triangles, but accessors[3] only 597");
    EXPECT_CONTAINS(with([](json& root) { root["accessors"][0]["count"] = 50; }),
                    element + ": its Draco data has 121 vertices, but accessors[0] only 50");
    EXPECT_CONTAINS(with([&](json& root) { root["accessors"][1]["count"] = encoded.points - 1; }),
                    element + ".attributes.TEXCOORD_0: its Draco data has");
    EXPECT_CONTAINS(with([](json& root) { root["accessors"][0]["type"] = "VEC4"; }),
                    element + ".attributes.POSITION: has 3 components in its Draco data, 4 in");
    EXPECT_CONTAINS(with([](json& root) { root["accessors"][2]["componentType"] = 5120; }),
                    element + ".attributes.JOINTS_0: its Draco data does not fit");
    EXPECT_CONTAINS(with([&](json& root) { extension(root)["attributes"]["POSITION"] = 7; }),
                    element + ".attributes.POSITION: its Draco data has no attribute 7");
    EXPECT_CONTAINS(with([&](json& root) { extension(root)["attributes"]["NORMAL"] = 1; }),
                    element + ".attributes.NORMAL: the primitive has no such attribute");
    EXPECT_CONTAINS(with([&](json& root) { extension(root)["bufferView"] = 1; }),
                    element + ".bufferView: 1 does not exist");
    EXPECT_CONTAINS(with([&](json& root) { extension(root).erase("attributes"); }),
                    element + ".attributes: is missing");
    EXPECT_CONTAINS(with([](json& root) { root["meshes"][0]["primitives"][0]["mode"] = 1; }),
                    element + ": does not go with mode 1");
    EXPECT_CONTAINS(with([](json& root) { root["bufferViews"][0]["byteLength"] = 60; }),
                    element + ": its Draco data is broken");
}

TEST(Draco, headers_that_ask_for_absurd_memory_are_refused) {
    const auto refused = [](const std::string& bytes) {
        return error_of([&] { read_draco_header(std::as_bytes(std::span(bytes)), "here"); });
    };
    const auto start = [](char major, char minor, char type, char method, std::string rest) {
        return std::string("DRACO") + major + minor + type + method + std::string(2, '\0') + rest;
    };
    EXPECT_CONTAINS(refused(""), "here: its Draco data is cut off");
    EXPECT_CONTAINS(refused("DRACO\2\2"), "cut off");
    EXPECT_CONTAINS(refused("draco\2\2\1\1\1\1\1\1\1"), "here: is not Draco data");
    EXPECT_CONTAINS(refused(start(3, 0, 1, 0, "\1\1\1\1")), "bitstream 3.0 is not supported");
    EXPECT_CONTAINS(refused(start(2, 2, 0, 0, "\1\1\1\1")), "not a triangle mesh");
    EXPECT_CONTAINS(refused(start(2, 2, 1, 0, "\xff\xff\xff\xff\x7f\1")), "too large");
    // 4 vertices, 1 face; 1 vertex, 1 face, 2 symbols; 1 vertex, 1 face, 1 symbol, 2 splits.
    EXPECT_CONTAINS(refused(start(2, 2, 1, 1, std::string("\0\4\1\0\1\0", 6))), "contradict");
    EXPECT_CONTAINS(refused(start(2, 2, 1, 1, std::string("\0\1\1\0\2\0", 6))), "contradict");
    EXPECT_CONTAINS(refused(start(2, 2, 1, 1, std::string("\0\1\1\0\1\2", 6))), "contradict");

    // 2^28 faces in a few bytes, with accessors that agree.
    const std::string absurd = start(2, 2, 1, 1,
                                     std::string("\0\xff\xff\xff\x7f\x80\x80\x80\x80\1", 10) +
                                         std::string("\0\xff\xff\xff\x7f\0", 6));
    EXPECT_CONTAINS(refusal_of(draco_file({absurd, 4000000000, 268435456}).glb()),
                    "meshes[0].primitives[0].extensions.KHR_draco_mesh_compression: needs");
}

TEST(Draco, metadata_is_skipped) {
    const Encoded plain = encode(Grid(3), kSequential, 5);
    // One attribute with an entry and a sub-tree that has one, then an empty tree for the mesh.
    const std::string metadata = std::string("\1\0", 2) + "\1\4name\3abc" + "\1\3sub\1\1k\1v" +
                                 std::string("\0", 1) + std::string("\0\0", 2);
    std::string bytes = plain.bytes;
    bytes[10] = static_cast<char>(0x80);
    bytes.insert(11, metadata);
    EXPECT_EQ(read_draco_header(std::as_bytes(std::span(bytes)), "here").faces, plain.faces);
    const OpenedGltf opened(draco_file({bytes, plain.points, plain.faces}).glb());
    EXPECT_EQ(decoded_triangles(opened), Grid(3).triangles());
}

TEST(Draco, damaged_data_is_refused_or_harmless) {
    std::mt19937 random(9);
    int refused = 0;
    for (const int method : {kSequential, kEdgebreaker}) {
        const Encoded good = encode(Grid(6), method, 5);
        for (int trial = 0; trial < 1000; ++trial) {
            Encoded damaged = good;
            for (uint32_t change = 0; change < 1 + random() % 3; ++change)
                damaged.bytes[11 + random() % (damaged.bytes.size() - 11)] =
                    static_cast<char>(random());
            refused += !refusal_of(draco_file(damaged).glb()).empty();
        }
    }
    EXPECT_GT(refused, 200);
}

} // namespace
} // namespace romascope::gltf
