// SPDX-License-Identifier: MIT
#include "renderer/scene/fit.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace romascope {
namespace {

/// Where the points lie in a picture of 16:9: the largest |x| and |y|, 1 being the edges.
/// Fails the test if one lies behind the camera.
glm::dvec2 farthest_out(const Camera& camera, const std::vector<glm::vec3>& points) {
    const double slope = std::tan(0.5 * static_cast<double>(camera.vertical_fov));
    const glm::dvec3 forward(camera.forward), up(camera.up);
    glm::dvec2 farthest(0.0);
    for (const glm::vec3 point : points) {
        const glm::dvec3 way = glm::dvec3(point) - glm::dvec3(camera.eye);
        const double depth = glm::dot(way, forward);
        EXPECT_GT(depth, 0.0);
        const glm::dvec2 place(glm::dot(way, glm::cross(forward, up)), glm::dot(way, up));
        farthest =
            glm::max(farthest, glm::abs(place / (depth * slope)) / glm::dvec2(16.0 / 9.0, 1.0));
    }
    return farthest;
}

Camera fit(const std::vector<glm::vec3>& points) {
    ViewFit view;
    for (const glm::vec3 point : points)
        view.add(point);
    return view.camera();
}

std::vector<glm::vec3> random_points(std::mt19937& random, size_t count, glm::vec3 centre,
                                     glm::vec3 size) {
    std::uniform_real_distribution<float> unit(-0.5f, 0.5f);
    std::vector<glm::vec3> points(count);
    for (glm::vec3& point : points)
        point = centre + size * glm::vec3(unit(random), unit(random), unit(random));
    return points;
}

constexpr double kInside = 0.9; ///< the margin is 5 % of the picture on each side

TEST(ViewFit, touches_the_margin_and_nothing_lies_in_it) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    for (int trial = 0; trial < 300; ++trial) {
        // From grains to planets, few points and many, flat and long ones among them.
        const float scale = std::pow(10.0f, 12.0f * unit(random) - 4.0f);
        glm::vec3 size(scale * unit(random), scale * unit(random), scale * unit(random));
        if (trial % 3 == 0)
            size[trial / 3 % 3] = 0.0f;
        const auto points =
            random_points(random, 8 + trial % 50, glm::vec3(scale * unit(random)), size);
        const glm::dvec2 farthest = farthest_out(fit(points), points);
        EXPECT_LE(std::max(farthest.x, farthest.y), kInside + 1e-6) << trial;
        EXPECT_GE(std::max(farthest.x, farthest.y), kInside - 1e-4) << trial;
    }
}

TEST(ViewFit, far_from_the_origin_nothing_leaves_the_picture) {
    // The eye is rounded to what floats can tell apart there: 64 m.
    std::mt19937 random(2);
    for (const float size : {1e3f, 1e4f, 1e6f}) {
        const auto points =
            random_points(random, 100, glm::vec3(9e8f, -8e8f, 7e8f), glm::vec3(size));
        const glm::dvec2 farthest = farthest_out(fit(points), points);
        EXPECT_LE(std::max(farthest.x, farthest.y), kInside + 1e-6) << size;
    }
}

TEST(ViewFit, a_single_point_is_in_the_middle) {
    for (const glm::vec3 point : {glm::vec3(0.0f), glm::vec3(1.0f, -2.0f, 3.0f)}) {
        const Camera camera = fit({point, point});
        const glm::dvec2 place = farthest_out(camera, {point});
        EXPECT_LT(std::max(place.x, place.y), 1e-5);
        EXPECT_NEAR(glm::distance(camera.eye, point), 1.0f, 1e-4f);
    }
}

TEST(ViewFit, a_line_towards_the_eye_is_seen_from_before_its_end) {
    const glm::vec3 back = -fit({glm::vec3(0.0f), glm::vec3(1.0f)}).forward;
    const std::vector<glm::vec3> line = {-7.0f * back, 3.0f * back};
    const Camera camera = fit(line);
    EXPECT_NEAR(glm::distance(camera.eye, line[1]), 0.1, 1e-3);
    EXPECT_LT(farthest_out(camera, line).y, kInside);
}

TEST(ViewFit, a_box_counts_by_its_corners) {
    ViewFit by_box;
    by_box.add(Bounds{{-1.0f, 0.0f, 2.0f}, {4.0f, 1.0f, 3.0f}});
    std::vector<glm::vec3> corners;
    for (const float x : {-1.0f, 4.0f})
        for (const float y : {0.0f, 1.0f})
            for (const float z : {2.0f, 3.0f})
                corners.emplace_back(x, y, z);
    EXPECT_EQ(by_box.camera().eye, fit(corners).eye);
}

TEST(FitCamera, vertices_without_triangle_do_not_count) {
    Scene scene;
    scene.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1000, 1000, 1000}};
    scene.indices = {0, 1, 2};
    const Camera camera = fit_camera(scene);
    EXPECT_EQ(camera.name, "default");
    EXPECT_NEAR(camera.vertical_fov, glm::quarter_pi<float>(), 1e-6f);
    const glm::dvec2 farthest =
        farthest_out(camera, {scene.positions.begin(), scene.positions.begin() + 3});
    EXPECT_NEAR(std::max(farthest.x, farthest.y), kInside, 1e-4);
    EXPECT_NEAR(glm::dot(camera.forward, camera.up), 0.0f, 1e-6f);
    EXPECT_GT(camera.forward.z, -1.0f);
    EXPECT_LT(camera.forward.z, -0.7f); // seen from in front
}

/// A triangle that goes 10 m to the right in two seconds, and one that stands.
Scene passing_triangle() {
    const std::vector<glm::vec3> triangle = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    Scene scene;
    scene.positions = {{0, 0, -1}, {1, 0, -1}, {0, 1, -1}};
    scene.positions.insert(scene.positions.end(), triangle.begin(), triangle.end());
    scene.indices = {0, 1, 2, 3, 4, 5};
    Motion& motion = scene.motion;
    motion.nodes.resize(1);
    motion.animations = {
        {"pass",
         2.0,
         {{0, MotionPath::translation, Interpolation::linear, {0.0f, 2.0f}, {0, 0, 0, 10, 0, 0}}}}};
    motion.first_vertex = 3;
    motion.matrix_count = 1;
    motion.rest_positions = triangle;
    motion.rest_normals.resize(3, glm::vec3(0, 0, 1));
    motion.parts = {{.first_vertex = 3, .vertex_count = 3}};
    return scene;
}

TEST(FitCamera, what_moves_stays_in_the_picture) {
    const Scene scene = passing_triangle();
    const Camera camera = fit_camera(scene);
    std::vector<glm::vec3> all(scene.positions.begin(), scene.positions.begin() + 3);
    for (int i = 0; i < 16; ++i)
        for (const glm::vec3 corner : scene.motion.rest_positions)
            all.push_back(corner + glm::vec3(10.0f * static_cast<float>(i) / 16.0f, 0, 0));
    const glm::dvec2 farthest = farthest_out(camera, all);
    EXPECT_LE(std::max(farthest.x, farthest.y), kInside + 1e-6);
    // Boxes are larger than what is in them, and have room for rounding.
    EXPECT_GE(std::max(farthest.x, farthest.y), 0.85);
}

} // namespace
} // namespace romascope
