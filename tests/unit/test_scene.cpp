// SPDX-License-Identifier: MIT
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/scene/camera_path.h"
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

/// A camera at `eye` that looks along `way`.
Camera camera_towards(glm::vec3 eye, glm::vec3 way, float fov) {
    return look_at("somewhere", eye, eye + way, fov);
}

TEST(CameraPathTest, PassesEachCamera) {
    const std::vector<Camera> stops = {camera_towards({0, 1, 2}, {1, 0.2f, 0}, 1.0f),
                                       camera_towards({4, 2, 0}, {0, -0.5f, 1}, 0.5f),
                                       camera_towards({4, 2, 9}, {-1, 0, 0}, 1.5f),
                                       camera_towards({0, 7, 9}, {0, -1, 0.1f}, 0.9f)};
    for (size_t i = 0; i < stops.size(); ++i) {
        const double at = static_cast<double>(i) / 3;
        for (const double near : {at - 1e-6, at, at + 1e-6}) {
            const Camera camera = camera_along(stops, near);
            EXPECT_LT(glm::distance(camera.eye, stops[i].eye), 1e-4f);
            EXPECT_LT(glm::distance(camera.forward, stops[i].forward), 1e-4f);
            EXPECT_LT(glm::distance(camera.up, stops[i].up), 1e-4f);
            EXPECT_NEAR(camera.vertical_fov, stops[i].vertical_fov, 1e-4f);
        }
    }
    EXPECT_EQ(camera_along(stops, -1).eye, stops[0].eye);
    EXPECT_EQ(camera_along(stops, 2).eye, stops[3].eye);
    EXPECT_EQ(camera_along(std::span(stops).first(1), 0.7).eye, stops[0].eye);
}

TEST(CameraPathTest, GoesEvenlyAlongALine) {
    std::vector<Camera> stops;
    for (int i = 0; i < 5; ++i)
        stops.push_back(camera_towards({2.0f * static_cast<float>(i), 1, 0}, {0, 0, -1}, 1.0f));
    for (double way = 0.25; way <= 0.75; way += 0.01) // apart from the doubled ends
        EXPECT_LT(glm::distance(camera_along(stops, way).eye, glm::vec3(8 * way, 1, 0)), 1e-4f);
}

TEST(CameraPathTest, RestsWhereACameraIsGivenTwice) {
    const std::vector<Camera> stops = {
        camera_towards({0, 1, 0}, {1, 0, 0}, 1.0f), camera_towards({4, 1, 0}, {0, 0, 1}, 1.0f),
        camera_towards({4, 1, 0}, {0, 0, 1}, 1.0f), camera_towards({4, 1, 9}, {-1, 0, 0}, 1.0f)};
    for (double way = 0.34; way < 0.66; way += 0.01) {
        EXPECT_EQ(camera_along(stops, way).eye, stops[1].eye) << way;
        EXPECT_LT(glm::distance(camera_along(stops, way).forward, stops[1].forward), 1e-6f) << way;
    }
    EXPECT_GT(glm::distance(camera_along(stops, 0.7).eye, stops[1].eye), 0.01f);
}

TEST(CameraPathTest, HasNoKinksAndTurnsTheShortestWay) {
    const std::vector<Camera> stops = {camera_towards({0, 0, 0}, {0, 0, -1}, 1.0f),
                                       camera_towards({1, 0, 0}, {1, 0, 0}, 1.0f),
                                       camera_towards({1, 0, 5}, {0, 0, 1}, 1.0f)};
    constexpr double kStep = 1e-3;
    for (double way = kStep; way < 1 - kStep; way += kStep) {
        const Camera before = camera_along(stops, way - kStep), at = camera_along(stops, way),
                     after = camera_along(stops, way + kStep);
        // A leg of 5 m in half the way bends by up to 60 m, 6e-5 in a step squared; a corner
        // would change the step itself, by 1e-2.
        EXPECT_LT(glm::length(after.eye - 2.0f * at.eye + before.eye), 2e-4f) << way;
        EXPECT_NEAR(glm::dot(at.forward, at.up), 0, 1e-5f);
        EXPECT_NEAR(glm::length(at.forward), 1, 1e-5f);
        EXPECT_NEAR(glm::length(at.up), 1, 1e-5f);
        // A half turn in all, 180 degrees over the whole way.
        EXPECT_NEAR(glm::dot(before.forward, at.forward), std::cos(3.14159265 * kStep), 1e-5);
    }
}

} // namespace
} // namespace romascope
