// SPDX-License-Identifier: MIT
// Where triangles, normals and cameras of a glTF file come to stand.
#include "tests/support/gltf_fixture.h"

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

#include <array>
#include <cmath>
#include <cstring>
#include <random>

namespace romascope {
namespace {

TEST_F(Gltf, square) {
    const Scene scene = load(glb(kSquare, square_bytes()), "my square.glb");
    expect_sound(scene);
    EXPECT_EQ(scene.name, "my square");
    EXPECT_EQ(scene.triangle_count(), 2u);
    ASSERT_EQ(scene.positions.size(), 4u);
    EXPECT_EQ(scene.positions[2], glm::vec3(1.0f, 1.0f, 0.0f));
    EXPECT_EQ(scene.indices, (std::vector<uint32_t>{0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(scene.normals[3], glm::vec3(0.0f, 0.0f, 1.0f));
    EXPECT_EQ(scene.bounds.min, glm::vec3(0.0f));
    EXPECT_EQ(scene.bounds.max, glm::vec3(1.0f, 1.0f, 0.0f));
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(scene.materials[0].name, "clay");
    EXPECT_EQ(scene.materials[0].base_color, glm::vec3(0.5f, 0.25f, 1.0f));
    EXPECT_EQ(scene.materials[0].emissive, glm::vec3(0.0f, 0.25f, 1.0f));
    ASSERT_EQ(scene.cameras.size(), 1u);
    const Camera& camera = scene.camera("eye");
    EXPECT_EQ(camera.eye, glm::vec3(0.5f, 0.5f, 3.0f));
    EXPECT_EQ(camera.forward, glm::vec3(0.0f, 0.0f, -1.0f));
    EXPECT_EQ(camera.up, glm::vec3(0.0f, 1.0f, 0.0f));
    EXPECT_FLOAT_EQ(camera.vertical_fov, 0.8f);
}

TEST_F(Gltf, every_width_of_indices_and_none) {
    const std::vector<uint32_t> expected = {0, 1, 2, 0, 2, 3};
    const std::string vertices = bytes_of(kCorners) + bytes_of(kNormals);
    const std::string bytes8 = vertices + std::string("\0\1\2\0\2\3\0\0\0\0\0", 12);
    const std::string bytes32 = vertices + bytes_of(expected);
    EXPECT_EQ(load(glb(replaced(kSquare, "5123", "5121"), bytes8)).indices, expected);
    std::string wide = replaced(replaced(kSquare, "5123", "5125"), "Length\": 12", "Length\": 24");
    wide = replaced(wide, "\"byteLength\": 108", "\"byteLength\": 120");
    EXPECT_EQ(load(glb(wide, bytes32)).indices, expected);

    std::string none = replaced(kSquare, ", \"indices\": 2", "");
    none = replaced(none, "\"bufferView\": 0, \"componentType\": 5126, \"count\": 4",
                    "\"bufferView\": 0, \"componentType\": 5126, \"count\": 3");
    none = replaced(none, "\"bufferView\": 1, \"componentType\": 5126, \"count\": 4",
                    "\"bufferView\": 1, \"componentType\": 5126, \"count\": 3");
    EXPECT_EQ(load(glb(none, square_bytes())).indices, (std::vector<uint32_t>{0, 1, 2}));
}

TEST_F(Gltf, strips_and_fans_keep_their_winding) {
    const auto load_mode = [&](int mode, const std::vector<uint16_t>& indices) {
        std::string json =
            replaced(kSquare, "\"indices\": 2", fmt::format("\"indices\": 2, \"mode\": {}", mode));
        json = replaced(json, "\"count\": 6", fmt::format("\"count\": {}", indices.size()));
        return load(glb(json, square_bytes(kCorners, kNormals, indices) + std::string(12, '\0')));
    };
    for (const Scene& scene : {load_mode(5, {0, 1, 3, 2}), load_mode(6, {0, 1, 2, 3})}) {
        ASSERT_EQ(scene.triangle_count(), 2u);
        EXPECT_EQ(face_normal(scene, 0), glm::vec3(0.0f, 0.0f, 1.0f));
        EXPECT_EQ(face_normal(scene, 1), glm::vec3(0.0f, 0.0f, 1.0f));
    }
    // A repeated corner joins strips; it is no triangle.
    EXPECT_EQ(load_mode(5, {0, 1, 3, 3, 2}).triangle_count(), 1u);
    EXPECT_CONTAINS(refusal(glb(replaced(kSquare, "\"count\": 6", "\"count\": 5"), square_bytes())),
                    "meshes[0].primitives[0]: 5 corners");
}

TEST_F(Gltf, matrix_and_parts_place_alike) {
    const float half = std::sqrt(0.5f);
    const glm::mat4 matrix = glm::mat4(1.0f) *
                             glm::mat4({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {1, 2, 3, 1}) *
                             glm::mat4_cast(glm::quat(half, 0.0f, half, 0.0f)) *
                             glm::mat4({2, 0, 0, 0}, {0, 3, 0, 0}, {0, 0, 4, 0}, {0, 0, 0, 1});
    std::string columns;
    for (int i = 0; i < 16; ++i)
        columns += fmt::format("{}{}", i ? ", " : "", matrix[i / 4][i % 4]);
    const Scene by_matrix = load_square("\"name\": \"square\"", "\"matrix\": [" + columns + "]");
    const Scene by_parts = load_square(
        "\"name\": \"square\"",
        fmt::format(R"("translation": [1, 2, 3], "scale": [2, 3, 4], "rotation": [0, {}, 0, {}])",
                    half, half));
    for (const Scene& scene : {by_matrix, by_parts}) {
        expect_sound(scene);
        // (1, 1, 0) -> scale (2, 3, 0) -> x to -z (0, 3, -2) -> moved (1, 5, 1).
        EXPECT_LT(glm::distance(scene.positions[2], glm::vec3(1.0f, 5.0f, 1.0f)), 1e-5f);
        EXPECT_LT(glm::distance(scene.normals[0], glm::vec3(1.0f, 0.0f, 0.0f)), 1e-6f);
        EXPECT_LT(glm::distance(face_normal(scene, 1), glm::vec3(1.0f, 0.0f, 0.0f)), 1e-5f);
    }
}

TEST_F(Gltf, children_move_with_their_parents_and_instances_are_written_out) {
    std::string json = replaced(kSquare, "\"nodes\": [0, 1]", "\"nodes\": [2, 3]");
    json = replaced(json, "\"translation\": [0.5, 0.5, 3]}",
                    R"("translation": [0.5, 0.5, 3]},
                       {"children": [0, 1], "translation": [10, 0, 0], "scale": [2, 2, 2]},
                       {"mesh": 0, "translation": [0, -5, 0]})");
    const Scene scene = load(glb(json, square_bytes()));
    expect_sound(scene);
    EXPECT_EQ(scene.triangle_count(), 4u);
    EXPECT_EQ(scene.positions[2], glm::vec3(12.0f, 2.0f, 0.0f));
    EXPECT_EQ(scene.positions[6], glm::vec3(1.0f, -4.0f, 0.0f));
    EXPECT_EQ(scene.cameras[0].eye, glm::vec3(11.0f, 1.0f, 6.0f));
    EXPECT_EQ(scene.bounds.min, glm::vec3(0.0f, -5.0f, 0.0f));
}

TEST_F(Gltf, normals_by_the_inverse_transpose) {
    // A slope along (1, 1, 0) with normal (1, -1, 0), stretched twice in x.
    const float n = std::sqrt(0.5f);
    const std::vector<float> corners = {0, 0, 0, 1, 1, 0, 1, 1, 1, 0, 0, 1};
    std::vector<float> normals;
    for (int i = 0; i < 4; ++i)
        normals.insert(normals.end(), {n, -n, 0});
    const Scene scene = load(glb(replaced(kSquare, "\"name\": \"square\"", "\"scale\": [2, 1, 1]"),
                                 square_bytes(corners, normals)));
    const glm::vec3 expected = glm::normalize(glm::vec3(1.0f, -2.0f, 0.0f));
    EXPECT_LT(glm::distance(scene.normals[1], expected), 1e-6f);
    EXPECT_LT(glm::distance(face_normal(scene, 0), expected), 1e-6f);
}

TEST_F(Gltf, mirrored_instances_keep_their_outside) {
    for (const char* scale : {"[-1, 1, 1]", "[1, -2, 1]", "[-1, -1, -1]", "[3, 1, -1]"}) {
        const Scene scene =
            load_square("\"name\": \"square\"", fmt::format("\"scale\": {}", scale));
        for (size_t triangle = 0; triangle < 2; ++triangle)
            EXPECT_GT(glm::dot(face_normal(scene, triangle), scene.normals[0]), 0.999f) << scale;
    }
    // Mirrored in z, the side that looked to +z looks to -z.
    EXPECT_EQ(load_square("\"name\": \"square\"", "\"scale\": [1, 1, -1]").normals[0],
              glm::vec3(0.0f, 0.0f, -1.0f));
}

TEST_F(Gltf, flattened_instances_and_hidden_ones) {
    const Scene flat = load_square("\"name\": \"square\"", "\"scale\": [1, 1, 0]");
    expect_sound(flat);
    EXPECT_EQ(flat.normals[0], glm::vec3(0.0f, 0.0f, 1.0f));
    EXPECT_CONTAINS(refusal(glb(replaced(kSquare, "\"name\": \"square\"", "\"scale\": [0, 0, 0]"),
                                square_bytes())),
                    "scene: has no triangles");
}

TEST_F(Gltf, missing_normals_become_flat) {
    const std::vector<float> bent = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 1};
    const Scene scene = load(glb(replaced(kSquare, ", \"NORMAL\": 1", ""), square_bytes(bent)));
    expect_sound(scene);
    EXPECT_EQ(scene.positions.size(), 6u); // no vertex is shared by differing triangles
    for (size_t i = 0; i < 6; ++i)
        EXPECT_LT(glm::distance(scene.normals[scene.indices[i]], face_normal(scene, i / 3)), 1e-6f);
    EXPECT_GT(glm::distance(scene.normals[0], scene.normals[3]), 0.1f);
}

TEST_F(Gltf, normals_of_any_length_become_unit) {
    const Scene scene =
        load(glb(kSquare, square_bytes(kCorners, {0, 0, 5, 0, 0, 1e-30f, 0, 3, 4, 0, 0, 0})));
    expect_sound(scene);
    EXPECT_EQ(scene.normals[1], glm::vec3(0.0f, 0.0f, 1.0f));
    EXPECT_LT(glm::distance(scene.normals[2], glm::vec3(0.0f, 0.6f, 0.8f)), 1e-6f);
    EXPECT_EQ(scene.normals[3], glm::vec3(0.0f, 0.0f, 1.0f)); // from its triangle
}

TEST_F(Gltf, interleaved_vertices) {
    std::vector<float> mixed;
    for (size_t i = 0; i < 4; ++i) {
        mixed.insert(mixed.end(), kCorners.begin() + 3 * static_cast<long>(i),
                     kCorners.begin() + 3 * static_cast<long>(i) + 3);
        mixed.insert(mixed.end(), {0, 0, 1});
    }
    std::string json = replaced(kSquare, "\"byteOffset\": 0, \"byteLength\": 48",
                                "\"byteStride\": 24, \"byteLength\": 96");
    json = replaced(json, "\"bufferView\": 1,", "\"bufferView\": 0, \"byteOffset\": 12,");
    const Scene scene =
        load(glb(json, bytes_of(mixed) + bytes_of(std::vector<uint16_t>{0, 1, 2, 0, 2, 3})));
    const Scene plain = load(glb(kSquare, square_bytes()));
    EXPECT_EQ(scene.positions, plain.positions);
    EXPECT_EQ(scene.normals, plain.normals);
}

TEST_F(Gltf, only_vertices_in_use_are_kept) {
    // 1000 vertices, of which a triangle far into the buffer uses three, close or far apart.
    std::vector<float> many(3000);
    std::mt19937 random(4);
    for (float& value : many)
        value = static_cast<float>(random() % 1000);
    std::string json = replaced(kSquare, ", \"NORMAL\": 1", "");
    json = replaced(json, "\"bufferView\": 0, \"componentType\": 5126, \"count\": 4",
                    "\"bufferView\": 0, \"componentType\": 5126, \"count\": 1000");
    json = replaced(json, "\"byteOffset\": 0, \"byteLength\": 48", "\"byteLength\": 12000");
    json = replaced(json, "\"byteOffset\": 96", "\"byteOffset\": 12000");
    json = replaced(json, "\"count\": 6", "\"count\": 3");
    json = replaced(json, "\"byteLength\": 108", "\"byteLength\": 12012");
    for (const auto& used : {std::array<uint16_t, 3>{500, 501, 502}, {998, 3, 500}}) {
        const std::vector<uint16_t> indices(used.begin(), used.end());
        std::string bytes = bytes_of(many) + bytes_of(indices);
        bytes.resize(12012);
        const Scene scene = load(glb(json, bytes));
        expect_sound(scene);
        ASSERT_EQ(scene.positions.size(), 3u);
        for (size_t i = 0; i < 3; ++i) {
            glm::vec3 expected;
            std::memcpy(&expected, &many[3 * indices[i]], sizeof(expected));
            EXPECT_EQ(scene.positions[scene.indices[i]], expected);
        }
    }
}

TEST_F(Gltf, without_material_it_is_white) {
    const Scene scene = load_square(R"(,
                            "material": 0)",
                                    "");
    expect_sound(scene);
    const Material& material = scene.materials[scene.vertex_material[0]];
    EXPECT_EQ(material.base_color, glm::vec3(1.0f));
    EXPECT_EQ(material.emissive, glm::vec3(0.0f));
}

TEST_F(Gltf, without_camera_one_shows_everything) {
    const Scene scene = load_square("\"camera\": 0, ", "");
    ASSERT_EQ(scene.cameras.size(), 1u);
    const Camera& camera = scene.camera("default");
    const glm::ivec2 size(100, 100);
    for (const glm::vec3& position : scene.positions) {
        const glm::vec4 clip =
            camera.projection(size, 0.01f) * camera.view() * glm::vec4(position, 1.0f);
        EXPECT_GT(clip.w, 0.0f);
        EXPECT_LT(std::abs(clip.x), clip.w);
        EXPECT_LT(std::abs(clip.y), clip.w);
    }
}

TEST_F(Gltf, camera_names_are_unique_and_come_from_node_or_camera) {
    std::string json = replaced(kSquare, "\"nodes\": [0, 1]", "\"nodes\": [0, 1, 2, 3, 4]");
    json = replaced(json, "\"type\": \"perspective\"",
                    "\"name\": \"lens\", \"type\": \"perspective\"");
    json = replaced(json, "\"translation\": [0.5, 0.5, 3]}",
                    R"("translation": [0.5, 0.5, 3]}, {"camera": 0}, {"camera": 0, "name": "eye"},
                       {"camera": 0, "rotation": [-0.70710678, 0, 0, 0.70710678]})");
    const Scene scene = load(glb(json, square_bytes()));
    ASSERT_EQ(scene.cameras.size(), 4u);
    EXPECT_EQ(scene.cameras[0].name, "eye");
    EXPECT_EQ(scene.cameras[1].name, "lens");
    EXPECT_EQ(scene.cameras[2].name, "eye_2");
    EXPECT_EQ(scene.cameras[3].name, "lens_2");
    const Camera& down = scene.cameras[3];
    EXPECT_LT(glm::distance(down.forward, glm::vec3(0.0f, -1.0f, 0.0f)), 1e-6f);
    EXPECT_LT(glm::distance(down.up, glm::vec3(0.0f, 0.0f, -1.0f)), 1e-6f);
}

} // namespace
} // namespace romascope
