// SPDX-License-Identifier: MIT
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/scene/gltf/import.h"
#include "renderer/scene/scene.h"
#include "tests/support/expect_error.h"
#include "tests/support/gltf_text.h"

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <random>
#include <string>
#include <unistd.h>
#include <vector>

namespace romascope {
namespace {

namespace fs = std::filesystem;

// --- cameras ---------------------------------------------------------------------------------

Camera random_camera(std::mt19937& random) {
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    const auto point = [&] { return 5.0f * glm::vec3(unit(random), unit(random), unit(random)); };
    return look_at("random", point(), point(), 1.2f + unit(random));
}

TEST(Camera, projection_agrees_with_direction_through) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    for (int trial = 0; trial < 500; ++trial) {
        const Camera camera = random_camera(random);
        const glm::ivec2 size(100 + static_cast<int>(2000.0f * unit(random)),
                              100 + static_cast<int>(2000.0f * unit(random)));
        const glm::vec2 offset(unit(random) - 0.5f, unit(random) - 0.5f);
        const glm::vec2 pixel = glm::vec2(size) * glm::vec2(unit(random), unit(random));
        const float near_plane = 0.01f + unit(random);
        const glm::vec3 direction = camera.direction_through(pixel + offset, size);
        EXPECT_NEAR(glm::length(direction), 1.0f, 1e-5f);
        const glm::vec3 point = camera.eye + (1.0f + 20.0f * unit(random)) * direction;
        const glm::vec4 clip =
            camera.projection(size, near_plane, offset) * camera.view() * glm::vec4(point, 1.0f);
        const glm::vec3 ndc = glm::vec3(clip) / clip.w;
        const glm::vec2 found = (glm::vec2(ndc) * 0.5f + 0.5f) * glm::vec2(size);
        const float along = glm::dot(point - camera.eye, camera.forward);
        // Narrow views magnify the rounding of the world coordinates, wide ones that of the slope.
        const float pixels = static_cast<float>(std::max(size.x, size.y));
        const float slack = 2e-6f * pixels * (1.0f + 10.0f / std::tan(camera.vertical_fov / 2));
        EXPECT_LT(glm::distance(found, pixel), slack) << "trial " << trial;
        EXPECT_NEAR(clip.w, along, 1e-4f);
        EXPECT_NEAR(ndc.z, near_plane / along, 1e-4f * ndc.z + 1e-6f);
    }
}

TEST(Camera, first_row_is_the_top_of_the_picture) {
    const Camera camera; // at (0, 0, 1), looks along -z
    const glm::ivec2 size(200, 100);
    EXPECT_GT(camera.direction_through({100.0f, 0.0f}, size).y, 0.0f);
    EXPECT_LT(camera.direction_through({0.0f, 50.0f}, size).x, 0.0f);
    EXPECT_EQ(camera.direction_through({100.0f, 50.0f}, size), camera.forward);
    // The upper edge is half the field of view away from the middle.
    const float cosine = glm::dot(camera.direction_through({100.0f, 0.0f}, size), camera.forward);
    EXPECT_NEAR(std::acos(cosine), camera.vertical_fov / 2, 1e-5f);
    const glm::vec4 above =
        camera.projection(size, 0.1f) * camera.view() * glm::vec4(0.0f, 0.2f, 0.0f, 1.0f);
    EXPECT_LT(above.y, 0.0f);
}

TEST(Camera, depth_is_one_at_the_near_plane_and_zero_at_infinity) {
    const Camera camera;
    const glm::mat4 matrix = camera.projection({64, 48}, 0.25f);
    const auto depth = [&](float distance) {
        const glm::vec4 clip = matrix * glm::vec4(0.1f, 0.1f, -distance, 1.0f);
        return clip.z / clip.w;
    };
    EXPECT_EQ(depth(0.25f), 1.0f);
    EXPECT_EQ(depth(0.5f), 0.5f);
    EXPECT_GT(depth(1e30f), 0.0f);
    EXPECT_LT(depth(1e30f), 1e-30f);
}

TEST(Camera, look_at_makes_an_orthonormal_frame_with_y_up) {
    std::mt19937 random(2);
    for (int trial = 0; trial < 200; ++trial) {
        const Camera camera = random_camera(random);
        EXPECT_NEAR(glm::length(camera.forward), 1.0f, 1e-5f);
        EXPECT_NEAR(glm::length(camera.up), 1.0f, 1e-5f);
        EXPECT_NEAR(glm::dot(camera.forward, camera.up), 0.0f, 1e-5f);
        EXPECT_GT(camera.up.y, 0.0f);
        EXPECT_NEAR(camera.right().y, 0.0f, 1e-5f);
    }
    const Camera down = look_at("down", {1.0f, 5.0f, 2.0f}, {1.0f, 0.0f, 2.0f}, 1.0f);
    EXPECT_EQ(down.forward, glm::vec3(0.0f, -1.0f, 0.0f));
    EXPECT_EQ(down.up, glm::vec3(0.0f, 0.0f, 1.0f));
    // Distances whose square is no float.
    EXPECT_EQ(look_at("near", glm::vec3(0.0f), {1e-25f, 0.0f, 0.0f}, 1.0f).forward.x, 1.0f);
    EXPECT_EQ(look_at("far", glm::vec3(0.0f), {1e30f, 0.0f, 0.0f}, 1.0f).forward.x, 1.0f);
}

TEST(Camera, look_at_refuses_what_has_no_direction) {
    const glm::vec3 p(1.0f, 2.0f, 3.0f);
    const float infinite = std::numeric_limits<float>::infinity();
    EXPECT_CONTAINS(error_of([&] { look_at("c", p, p, 1.0f); }), "same point");
    EXPECT_CONTAINS(error_of([&] { look_at("c", p, glm::vec3(infinite), 1.0f); }), "finite");
    EXPECT_CONTAINS(error_of([&] { look_at("c", glm::vec3(std::nanf("")), p, 1.0f); }), "finite");
    for (const float fov : {0.0f, -1.0f, 3.2f, infinite, std::nanf("")})
        EXPECT_CONTAINS(error_of([&] { look_at("c", p, -p, fov); }), "field of view");
}

TEST(Camera, parses_eye_target_and_degrees) {
    const Camera camera = parse_camera("1,2.5,-3/1,2.5,7e0/60");
    EXPECT_EQ(camera.eye, glm::vec3(1.0f, 2.5f, -3.0f));
    EXPECT_EQ(camera.forward, glm::vec3(0.0f, 0.0f, 1.0f));
    EXPECT_NEAR(camera.vertical_fov, glm::radians(60.0f), 1e-6f);
    EXPECT_EQ(camera.name, "1,2.5,-3/1,2.5,7e0/60");
}

TEST(Camera, refuses_other_texts_and_tells_the_form) {
    for (const char* text :
         {"", "/", "//", "hall", "1,2,3", "1,2,3/4,5,6", "1,2/3,4,5/60", "1,2,3/4,5,6/60/7",
          "1,2,3,4/4,5,6/60", "1,2,3/4,5,6/sixty", "1,2,3/4,5,6/60deg", "1,2,3/4,5,6/",
          "1, 2,3/4,5,6/60", "nan,2,3/4,5,6/60", "1,inf,3/4,5,6/60", "1,2,1e99/4,5,6/60",
          "1,,3/4,5,6/60", "1;2;3/4;5;6/60"})
        EXPECT_CONTAINS(error_of([&] { parse_camera(text); }), "eye/target/degrees");
    for (const char* text : {"1,2,3/4,5,6/0", "1,2,3/4,5,6/180", "1,2,3/4,5,6/-60"})
        EXPECT_CONTAINS(error_of([&] { parse_camera(text); }), "field of view");
    EXPECT_CONTAINS(error_of([&] { parse_camera("1,2,3/1,2,3/60"); }), "same point");
}

TEST(Scene, camera_by_name) {
    Scene scene;
    scene.name = "hall";
    scene.cameras = {{"nave"}, {"stairs"}};
    EXPECT_EQ(scene.camera("stairs").name, "stairs");
    const std::string text = error_of([&] { scene.camera("roof"); });
    EXPECT_CONTAINS(text, "'roof'");
    EXPECT_CONTAINS(text, "nave, stairs");
}

// --- glTF ------------------------------------------------------------------------------------

class Gltf : public testing::Test {
protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() /
                  (std::string("romascope_") + info->name() + std::to_string(getpid()));
        fs::create_directories(folder_ / "asset");
    }
    void TearDown() override { fs::remove_all(folder_); }

    Scene load(const std::string& content, const std::string& name = "thing.glb") const {
        write_file_atomically(folder_ / "asset" / name, content);
        return load_gltf(folder_ / "asset" / name);
    }
    Scene load_square(const std::string& from, const std::string& to) const {
        return load(glb(replaced(kSquare, from, to), square_bytes()));
    }
    /// The message without the file's name, which must come first.
    std::string refusal(const std::string& content, const std::string& name = "thing.glb") const {
        const std::string text = error_of([&] { load(content, name); });
        const std::string start = (folder_ / "asset" / name).string() + ": ";
        EXPECT_EQ(text.rfind(start, 0), 0u) << text;
        return text.substr(std::min(text.size(), start.size()));
    }
    fs::path folder_;
};

glm::vec3 face_normal(const Scene& scene, size_t triangle) {
    const auto at = [&](size_t i) { return scene.positions[scene.indices[3 * triangle + i]]; };
    return glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0)));
}

/// What holds for every scene that is let in.
void expect_sound(const Scene& scene) {
    EXPECT_FALSE(scene.indices.empty());
    EXPECT_EQ(scene.indices.size() % 3, 0u);
    EXPECT_EQ(scene.normals.size(), scene.positions.size());
    EXPECT_EQ(scene.vertex_material.size(), scene.positions.size());
    EXPECT_FALSE(scene.materials.empty());
    EXPECT_FALSE(scene.cameras.empty());
    for (const uint32_t index : scene.indices)
        ASSERT_LT(index, scene.positions.size());
    for (const uint32_t material : scene.vertex_material)
        ASSERT_LT(material, scene.materials.size());
    for (const glm::vec3& normal : scene.normals)
        ASSERT_NEAR(glm::length(normal), 1.0f, 1e-5f);
    for (const glm::vec3& position : scene.positions)
        ASSERT_LT(glm::length(position), 2e9f); // also false for NaN
    EXPECT_FALSE(scene.bounds.empty());
}

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

TEST_F(Gltf, text_form_reads_buffers_beside_it_only) {
    const auto with_uri = [&](const std::string& uri) {
        return replaced(kSquare, "{\"byteLength\": 108",
                        "{\"uri\": \"" + uri + "\", \"byteLength\": 108");
    };
    write_file_atomically(folder_ / "asset" / "da ta.bin", square_bytes());
    write_file_atomically(folder_ / "outside.bin", square_bytes());
    EXPECT_EQ(load(with_uri("da%20ta.bin"), "a.gltf").triangle_count(), 2u);
    EXPECT_CONTAINS(refusal(with_uri("../outside.bin"), "a.gltf"), "outside the folder");
    fs::create_symlink(folder_ / "outside.bin", folder_ / "asset" / "link.bin");
    EXPECT_CONTAINS(refusal(with_uri("link.bin"), "a.gltf"), "outside the folder");
    EXPECT_CONTAINS(refusal(with_uri("missing.bin"), "a.gltf"), "missing.bin");
    EXPECT_CONTAINS(refusal(with_uri("."), "a.gltf"), "glTF");
}

TEST_F(Gltf, images_are_neither_decoded_nor_trusted) {
    // Its view lies far outside the buffer; with tinygltf's own loader this reads foreign memory.
    std::string json =
        replaced(kSquare, "\"buffers\":",
                 "\"images\": [{\"bufferView\": 3, "
                 "\"mimeType\": \"image/png\"}, {\"uri\": \"no.png\"}], \"buffers\":");
    json = replaced(json, "\"byteLength\": 12}",
                    "\"byteLength\": 12}, {\"buffer\": 0, \"byteOffset\": 999999999999, "
                    "\"byteLength\": 7}");
    EXPECT_EQ(load(glb(json, square_bytes())).triangle_count(), 2u);
}

struct Broken {
    const char* from;
    const char* to;
    const char* element; ///< that the message names
};

TEST_F(Gltf, broken_files_are_refused_with_their_element) {
    const std::vector<Broken> cases = {
        {"\"POSITION\": 0", "\"POSITION\": 9",
         "meshes[0].primitives[0].attributes.POSITION: accessor 9"},
        {"\"POSITION\": 0", "\"POSITION\": -7",
         "meshes[0].primitives[0].attributes.POSITION: accessor -7"},
        {"\"POSITION\": 0, ", "", "meshes[0].primitives[0].attributes.POSITION: has no accessor"},
        {"\"POSITION\": 0", "\"POSITION\": 2",
         "attributes.POSITION: accessors[2]: is SCALAR, but VEC3"},
        {"\"NORMAL\": 1", "\"NORMAL\": 77", "attributes.NORMAL: accessor 77"},
        {"\"indices\": 2", "\"indices\": 3", "meshes[0].primitives[0].indices: accessor 3"},
        {"\"indices\": 2", "\"indices\": -3", "meshes[0].primitives[0].indices: accessor -3"},
        {"\"indices\": 2", "\"indices\": 0", "indices: accessors[0]: is VEC3"},
        {"\"indices\": 2", "\"indices\": 2, \"mode\": 9", "meshes[0].primitives[0].mode: 9"},
        {"\"material\": 0", "\"material\": 1", "meshes[0].primitives[0].material: material 1"},
        {"5123", "5122", "indices: accessors[2]: component type 5122"},
        {"\"count\": 6", "\"count\": 7", "accessors[2]: 7 elements"},
        {"\"count\": 6", "\"count\": 4611686018427387904", "accessors[2]: 4611686018427387904"},
        {"\"count\": 6", "\"count\": 0", "accessors[2]: has no elements"},
        {"\"bufferView\": 2", "\"bufferView\": 5", "indices: accessors[2]: has no bufferView"},
        {"\"bufferView\": 0,", "\"bufferView\": 5,", "accessors[0]: bufferView 5"},
        {"\"bufferView\": 0,", "", "accessors[0]: has no bufferView"},
        {"\"bufferView\": 1,", "\"bufferView\": 1, \"byteOffset\": 4,", "accessors[1]: 4 elements"},
        {"\"bufferView\": 1,", "\"bufferView\": 1, \"byteOffset\": 18446744073709551612,",
         "accessors[1]: 4 elements from byte"},
        {"\"bufferView\": 1,", "\"bufferView\": 1, \"byteOffset\": 2,",
         "accessors[1]: byteOffset 2"},
        {"\"bufferView\": 1,",
         "\"bufferView\": 1, \"sparse\": {\"count\": 1, \"indices\": {\"bufferView\": 2, "
         "\"componentType\": 5123}, \"values\": {\"bufferView\": 0}},",
         "accessors[1]: sparse"},
        {"\"byteOffset\": 96", "\"byteOffset\": 97", "bufferViews[2]: offset 97"},
        {"\"byteOffset\": 96", "\"byteOffset\": 18446744073709551605", "bufferViews[2]: offset"},
        {"{\"buffer\": 0, \"byteOffset\": 48", "{\"buffer\": 4, \"byteOffset\": 48",
         "bufferViews[1]: buffer 4"},
        {"\"byteOffset\": 48,", "\"byteOffset\": 48, \"byteStride\": 8,",
         "accessors[1]: byteStride 8"},
        {"\"byteOffset\": 48,", "\"byteOffset\": 48, \"byteStride\": 16,",
         "accessors[1]: 4 elements"},
        {"\"mesh\": 0", "\"mesh\": 1", "nodes[0].mesh: mesh 1"},
        {"\"camera\": 0", "\"camera\": 3", "nodes[1].camera: camera 3"},
        {"\"nodes\": [0, 1]", "\"nodes\": [0, 5]", "scene.nodes: node 5"},
        {"\"nodes\": [0, 1]", "\"nodes\": [0, -1]", "scene.nodes: node -1"},
        {"\"nodes\": [0, 1]", "\"nodes\": [0, 0]", "scene.nodes: node 0 is reached twice"},
        {"\"scene\": 0", "\"scene\": 2", "scene: scene 2"},
        {"\"mesh\": 0", "\"mesh\": 0, \"children\": [0]", "nodes[0].children: node 0 is reached"},
        {"\"mesh\": 0", "\"mesh\": 0, \"children\": [8]", "nodes[0].children: node 8"},
        {"\"mesh\": 0", "\"mesh\": 0, \"matrix\": [1, 2, 3]", "nodes[0].matrix: has 3 numbers"},
        {"\"mesh\": 0", "\"mesh\": 0, \"matrix\": [1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1]",
         "nodes[0].matrix: is not affine"},
        {"\"mesh\": 0", "\"mesh\": 0, \"scale\": [1, 2]", "nodes[0].scale: has 2 numbers"},
        {"\"mesh\": 0", "\"mesh\": 0, \"rotation\": [0, 0, 0, 0]", "nodes[0].rotation"},
        {"\"mesh\": 0", "\"mesh\": 0, \"translation\": [1e300, 0, 0]", "nodes[0]: places a vertex"},
        {"\"mesh\": 0", "\"mesh\": 0, \"scale\": [1e300, 1e300, 1]", "nodes[0]: places a vertex"},
        {"\"yfov\": 0.8", "\"yfov\": 0", "cameras[0].perspective.yfov"},
        {"\"yfov\": 0.8", "\"yfov\": 3.2", "cameras[0].perspective.yfov"},
        {"[0.5, 0.5, 3]", "[0.5, 0.5, 3], \"scale\": [0, 0, 0]", "nodes[1]: its transform"},
        {"{\"version\": \"2.0\"}", "{\"version\": \"1.0\"}", "asset.version: '1.0'"},
        {"\"scene\": 0,", "\"extensionsRequired\": [\"VENDOR_strange\\nthing\"], \"scene\": 0,",
         "extensionsRequired: needs VENDOR_strange"},
        {"\"indices\": 2", "\"indices\": 2, \"extensions\": {\"KHR_draco_mesh_compression\": {}}",
         "meshes[0].primitives[0]: compressed by KHR_draco_mesh_compression"},
        {"\"byteOffset\": 48,",
         "\"byteOffset\": 48, \"extensions\": {\"EXT_meshopt_compression\": {}},",
         "bufferViews[1]: compressed by EXT_meshopt_compression"},
        {"{\"byteLength\": 108}", "{\"byteLength\": 10800}", "glTF: "},
        {"\"meshes\"", "\"ignored\"", "nodes[0].mesh: mesh 0"},
    };
    for (const Broken& each : cases)
        EXPECT_CONTAINS(refusal(glb(replaced(kSquare, each.from, each.to), square_bytes())),
                        each.element);
}

TEST_F(Gltf, broken_bytes_are_refused_with_their_element) {
    std::vector<float> corners = kCorners;
    corners[4] = std::nanf("");
    EXPECT_CONTAINS(refusal(glb(kSquare, square_bytes(corners))),
                    "meshes[0].primitives[0].attributes.POSITION: element 1 is not finite");
    std::vector<float> normals = kNormals;
    normals[11] = std::numeric_limits<float>::infinity();
    EXPECT_CONTAINS(refusal(glb(kSquare, square_bytes(kCorners, normals))),
                    "attributes.NORMAL: element 3 is not finite");
    EXPECT_CONTAINS(refusal(glb(kSquare, square_bytes(kCorners, kNormals, {0, 1, 2, 0, 2, 4}))),
                    "meshes[0].primitives[0].indices: index 5 names vertex 4, there are 4");
}

TEST_F(Gltf, other_contents_are_refused) {
    const std::string good = glb(kSquare, square_bytes());
    for (const size_t length : {0u, 3u, 4u, 12u, 19u, 20u, 200u, 1000u})
        EXPECT_FALSE(refusal(good.substr(0, length)).empty()) << length;
    EXPECT_CONTAINS(refusal("v 0 0 0\nv 1 0 0\n", "a.obj"), "not a glTF 2.0 file");
    EXPECT_CONTAINS(refusal("{}", "a.gltf"), "glTF");
    EXPECT_CONTAINS(refusal("{\"asset\": {\"version\": \"2.0\"}}", "a.gltf"), "no triangles");
    EXPECT_CONTAINS(refusal("{\"asset\": " + std::string(100000, '['), "a.gltf"), "nested deeper");
    // Brackets in strings are not nesting.
    EXPECT_EQ(load_square("\"square\"", "\"" + std::string(500, '[') + "\\\"\"").triangle_count(),
              2u);
    EXPECT_CONTAINS(error_of([&] { load_gltf(folder_ / "absent.glb"); }), "absent.glb");
    EXPECT_CONTAINS(error_of([&] { load_gltf(folder_); }), "folder");
}

TEST_F(Gltf, deep_hierarchies_and_many_parents) {
    // A chain of 100,000 nodes is honest; a node with two parents is not, however short.
    std::string chain = R"({"name": "square", "children": [2]})";
    std::string nodes;
    for (int i = 2; i < 100000; ++i)
        nodes += fmt::format(R"(, {{"children": [{}]}})", i + 1);
    nodes += R"(, {"mesh": 0})";
    std::string json = replaced(kSquare, R"({"name": "square", "mesh": 0})", chain);
    json = replaced(json, "[0.5, 0.5, 3]}", "[0.5, 0.5, 3]}" + nodes);
    EXPECT_EQ(load(glb(json, square_bytes())).triangle_count(), 2u);
    EXPECT_CONTAINS(
        refusal(glb(replaced(json, "\"children\": [3]}", "\"children\": [3, 3]}"), square_bytes())),
        "node 3 is reached twice");
}

TEST_F(Gltf, random_damage_is_refused_or_harmless) {
    const std::string json = kSquare;
    const std::string file = glb(json, square_bytes());
    std::mt19937 random(11);
    int refused = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        std::string damaged = file;
        for (uint32_t change = 0; change < 1 + random() % 4; ++change) {
            const size_t at = random() % damaged.size();
            // Digits mostly, so that the JSON often stays well-formed.
            damaged[at] = random() % 3 && std::isdigit(static_cast<unsigned char>(file[at]))
                              ? static_cast<char>('0' + random() % 10)
                              : static_cast<char>(random());
        }
        try {
            expect_sound(load(damaged));
        } catch (const Error&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 1000);
    EXPECT_LT(refused, 3000);
}

} // namespace
} // namespace romascope
