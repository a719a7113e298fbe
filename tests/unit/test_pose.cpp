// SPDX-License-Identifier: MIT
#include "renderer/base/error.h"
#include "renderer/scene/pose.h"
#include "tests/support/moving_scene.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace romascope {
namespace {

/// Half of a quarter turn's quaternion; as the files have it.
const float kHalf = std::sqrt(0.5f);

void expect_near(glm::dvec3 found, glm::dvec3 expected, double tolerance) {
    EXPECT_LE(glm::distance(found, expected), tolerance)
        << found.x << ", " << found.y << ", " << found.z << " is not " << expected.x << ", "
        << expected.y << ", " << expected.z;
}

std::string error_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        EXPECT_EQ(error.exit_status(), kBadInput);
        return error.what();
    }
    return {};
}

/// One node with one channel.
Motion one_channel(MotionPath path, Interpolation interpolation, std::vector<float> times,
                   std::vector<float> values) {
    Motion motion;
    motion.nodes.resize(1);
    motion.animations.push_back({"", times.back(), {}});
    motion.animations.front().channels.push_back({0, path, interpolation, times, values});
    return motion;
}

glm::dvec3 translation_at(const Motion& motion, double seconds) {
    return glm::dvec3(pose_at(motion, 0, seconds).node_to_world[0][3]);
}

/// Where the x axis goes, in degrees about z; the turn must keep z.
double turn_at(const Motion& motion, double seconds) {
    const glm::dmat4 matrix = pose_at(motion, 0, seconds).node_to_world[0];
    expect_near(glm::dvec3(matrix[2]), {0, 0, 1}, 1e-7);
    EXPECT_NEAR(glm::length(matrix[0]), 1.0, 1e-12);
    return glm::degrees(std::atan2(matrix[0].y, matrix[0].x));
}

// --- keys ------------------------------------------------------------------------------------

TEST(Keys, linear_between_and_constant_beyond_the_ends) {
    Motion motion = one_channel(MotionPath::translation, Interpolation::linear, {1.0f, 3.0f, 4.0f},
                                {0, 0, 0, 8, -4, 2, 8, 0, 2});
    motion.animations[0].duration = 6.0; // another channel is longer
    expect_near(translation_at(motion, 0.0), {0, 0, 0}, 0.0);
    expect_near(translation_at(motion, 0.99), {0, 0, 0}, 0.0);
    expect_near(translation_at(motion, 1.0), {0, 0, 0}, 0.0);
    expect_near(translation_at(motion, 1.5), {2, -1, 0.5}, 1e-12);
    expect_near(translation_at(motion, 3.0), {8, -4, 2}, 0.0);
    expect_near(translation_at(motion, 3.75), {8, -1, 2}, 1e-12);
    expect_near(translation_at(motion, 4.0), {8, 0, 2}, 0.0);
    expect_near(translation_at(motion, 5.9), {8, 0, 2}, 0.0);
}

TEST(Keys, steps_hold_until_the_next_key) {
    const Motion motion = one_channel(MotionPath::translation, Interpolation::step,
                                      {0.5f, 1.0f, 2.0f}, {1, 0, 0, 2, 0, 0, 3, 0, 0});
    EXPECT_EQ(translation_at(motion, 0.0).x, 1.0);
    EXPECT_EQ(translation_at(motion, 0.5).x, 1.0);
    EXPECT_EQ(translation_at(motion, 0.999999).x, 1.0);
    EXPECT_EQ(translation_at(motion, 1.0).x, 2.0);
    EXPECT_EQ(translation_at(motion, 1.999).x, 2.0);
    EXPECT_EQ(translation_at(motion, 2.0).x, 3.0);
}

TEST(Keys, cubic_by_hand) {
    // Half way from 1, leaving at 3 a second, to 5, arriving at -1 a second, in 2 seconds:
    // 0.5 * 1 + 2 * 0.125 * 3 + 0.5 * 5 - 2 * 0.125 * -1 = 4.
    const Motion motion =
        one_channel(MotionPath::translation, Interpolation::cubic, {1.0f, 3.0f},
                    {99, 0, 0, 1, 0, 0, 3, 0, 0, /**/ -1, 0, 0, 5, 0, 0, 99, 0, 0});
    EXPECT_NEAR(translation_at(motion, 2.0).x, 4.0, 1e-12);
    EXPECT_EQ(translation_at(motion, 0.5).x, 1.0);
    EXPECT_EQ(translation_at(motion, 1.0).x, 1.0);
    EXPECT_EQ(translation_at(motion, 3.0).x, 5.0);
}

TEST(Keys, cubic_keys_of_a_cubic_give_that_cubic) {
    const auto value = [](double t) { return 0.5 - t + 0.75 * t * t - 0.25 * t * t * t; };
    const auto slope = [](double t) { return -1.0 + 1.5 * t - 0.75 * t * t; };
    std::vector<float> values;
    const std::vector<float> times = {0.0f, 0.5f, 2.0f, 4.0f};
    for (const float t : times)
        for (const double number : {slope(t), 0.0, 0.0, value(t), 0.0, 0.0, slope(t), 0.0, 0.0})
            values.push_back(static_cast<float>(number));
    const Motion motion = one_channel(MotionPath::translation, Interpolation::cubic, times, values);
    for (double t = 0.0; t <= 4.0; t += 0.0625)
        EXPECT_NEAR(translation_at(motion, t).x, value(t), 1e-6) << t; // values are floats
}

TEST(Keys, rotations_turn_at_constant_speed) {
    const Motion motion = one_channel(MotionPath::rotation, Interpolation::linear, {0.0f, 3.0f},
                                      {0, 0, 0, 1, 0, 0, kHalf, kHalf});
    // Interpolating the four numbers would give 28.7 and 61.3 degrees.
    EXPECT_NEAR(turn_at(motion, 1.0), 30.0, 1e-5);
    EXPECT_NEAR(turn_at(motion, 2.0), 60.0, 1e-5);
    EXPECT_NEAR(turn_at(motion, 3.0), 90.0, 1e-5);
}

TEST(Keys, rotations_take_the_short_way) {
    // 270 degrees forward are 90 back.
    const Motion motion = one_channel(MotionPath::rotation, Interpolation::linear, {0.0f, 2.0f},
                                      {0, 0, 0, 1, 0, 0, kHalf, -kHalf});
    EXPECT_NEAR(turn_at(motion, 1.0), -45.0, 1e-5);
    // The same rotation by opposite numbers: nothing turns.
    const Motion same = one_channel(MotionPath::rotation, Interpolation::linear, {0.0f, 2.0f},
                                    {0, 0, kHalf, kHalf, 0, 0, -kHalf, -kHalf});
    EXPECT_NEAR(turn_at(same, 0.7), 90.0, 1e-5);
}

TEST(Keys, rotations_of_any_length_are_made_rotations) {
    const Motion cubic = one_channel(
        MotionPath::rotation, Interpolation::cubic, {0.0f, 1.0f},
        {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, /**/ 0, 0, 0, 0, 0, 0, kHalf, kHalf, 0, 0, 0, 0});
    EXPECT_NEAR(turn_at(cubic, 0.5), 45.0, 1e-5); // the chord's middle, lengthened
    const Motion doubled = one_channel(MotionPath::rotation, Interpolation::linear, {0.0f, 1.0f},
                                       {0, 0, 0, 2, 0, 0, 2 * kHalf, 2 * kHalf});
    EXPECT_NEAR(turn_at(doubled, 1.0 / 3.0), 30.0, 1e-5);
    const Motion none =
        one_channel(MotionPath::rotation, Interpolation::step, {0.0f}, {0, 0, 0, 0});
    EXPECT_EQ(turn_at(none, 0.0), 0.0);
}

TEST(Keys, weights_of_all_targets) {
    Motion motion = one_channel(MotionPath::weights, Interpolation::linear, {0.0f, 2.0f},
                                {0.0f, 1.0f, 0.5f, 1.0f, -1.0f, 0.5f});
    motion.weights = {9.0f, 0.25f, 0.25f, 0.25f};
    motion.nodes[0].first_weight = 1;
    motion.nodes[0].weight_count = 3;
    EXPECT_EQ(pose_at(motion, 0, 0.5).weights, (std::vector<double>{9.0, 0.25, 0.5, 0.5}));
    EXPECT_EQ(pose_at(motion, -1, 0.5).weights, (std::vector<double>{9.0, 0.25, 0.25, 0.25}));
    // In-tangents of all, values of all, out-tangents of all.
    MotionChannel& channel = motion.animations[0].channels[0];
    channel.interpolation = Interpolation::cubic;
    channel.values = {9, 9, 9, 0, 0, 1, 1, 0, 0, /**/ 0, 8, 0, 0, 0, 1, 9, 9, 9};
    EXPECT_EQ(pose_at(motion, 0, 1.0).weights, (std::vector<double>{9.0, 0.25, -2.0, 1.0}));
}

// --- time ------------------------------------------------------------------------------------

TEST(Time, starts_over_after_the_end) {
    const Motion motion = one_channel(MotionPath::translation, Interpolation::linear, {0.0f, 4.0f},
                                      {0, 0, 0, 4, 0, 0});
    EXPECT_EQ(translation_at(motion, 4.0).x, 4.0);
    EXPECT_NEAR(translation_at(motion, 4.25).x, 0.25, 1e-12);
    EXPECT_NEAR(translation_at(motion, 4000.75).x, 0.75, 1e-9);
    EXPECT_NEAR(translation_at(motion, 1e6 + 3.0).x, 3.0, 1e-6);
}

TEST(Time, an_animation_of_one_key_is_a_still) {
    const Motion motion =
        one_channel(MotionPath::translation, Interpolation::linear, {0.0f}, {1, 2, 3});
    for (const double seconds : {0.0, 0.5, 1e5})
        expect_near(translation_at(motion, seconds), {1, 2, 3}, 0.0);
}

TEST(Time, poses_repeat_with_the_duration) {
    std::mt19937 random(5);
    for (int trial = 0; trial < 20; ++trial) {
        const Scene scene = random_moving_scene(random, kAllKinds);
        const double duration = scene.motion.animations[0].duration;
        const double seconds =
            std::uniform_real_distribution<double>(0.01, 0.99)(random) * duration;
        const Pose once = pose_at(scene.motion, 0, seconds);
        const Pose later = pose_at(scene.motion, 0, seconds + 7.0 * duration);
        for (size_t node = 0; node < once.node_to_world.size(); ++node)
            for (int column = 0; column < 4; ++column)
                EXPECT_LT(glm::distance(once.node_to_world[node][column],
                                        later.node_to_world[node][column]),
                          1e-9);
        for (size_t i = 0; i < once.weights.size(); ++i)
            EXPECT_NEAR(once.weights[i], later.weights[i], 1e-9);
    }
}

// --- hierarchy and matrices ------------------------------------------------------------------

/// An arm along x: upper arm from 0 to 1, forearm from 1 to 2; in a second the shoulder turns by 90
/// degrees about z, the elbow by 90 more.
struct Arm {
    MovingSceneBuilder builder;
    uint32_t shoulder, elbow;

    Arm() {
        shoulder = builder.add_node({});
        MotionNode node;
        node.parent = 0;
        node.translation = {1, 0, 0};
        elbow = builder.add_node(node);
        for (const uint32_t joint : {shoulder, elbow})
            builder.add_channel(joint, MotionPath::rotation, Interpolation::linear, {0.0f, 1.0f},
                                {0, 0, 0, 1, 0, 0, kHalf, kHalf});
    }
};

TEST(Hierarchy, children_follow_their_parents) {
    Arm arm;
    const Pose pose = pose_at(arm.builder.motion(), 0, 1.0);
    const glm::dmat4& forearm = pose.node_to_world[arm.elbow];
    expect_near(glm::dvec3(forearm * glm::dvec4(0, 0, 0, 1)), {0, 1, 0}, 1e-7);
    expect_near(glm::dvec3(forearm * glm::dvec4(1, 0, 0, 1)), {-1, 1, 0}, 1e-7);
    const Pose half = pose_at(arm.builder.motion(), 0, 0.5);
    const double s = std::sqrt(0.5);
    expect_near(glm::dvec3(half.node_to_world[arm.elbow] * glm::dvec4(1, 0, 0, 1)), {s, s + 1, 0},
                1e-7);
    const Pose rest = pose_at(arm.builder.motion(), -1, 1.0);
    expect_near(glm::dvec3(rest.node_to_world[arm.elbow] * glm::dvec4(1, 0, 0, 1)), {2, 0, 0}, 0.0);
}

TEST(Hierarchy, scale_comes_before_rotation_before_translation) {
    Motion motion;
    MotionNode node;
    node.translation = {10, 0, 0};
    node.rotation = glm::dquat(std::sqrt(0.5), 0, 0, std::sqrt(0.5)); // about z
    node.scale = {2, 3, -1};
    motion.nodes.push_back(node);
    node = {};
    node.parent = 0;
    node.has_matrix = true;
    node.matrix = glm::dmat4(1.0);
    node.matrix[3] = {0, 1, 0, 1};
    motion.nodes.push_back(node);
    const Pose pose = pose_at(motion, -1, 0.0);
    expect_near(glm::dvec3(pose.node_to_world[0] * glm::dvec4(1, 1, 1, 1)), {7, 2, -1}, 1e-12);
    expect_near(glm::dvec3(pose.node_to_world[1] * glm::dvec4(1, 0, 1, 1)), {7, 2, -1}, 1e-12);
}

TEST(Skin, vertices_follow_the_mean_of_their_joints) {
    Arm arm;
    MotionNode elsewhere; // a skinned mesh's own node does not move it
    elsewhere.translation = {100, 100, 100};
    MovingSceneBuilder::Piece piece;
    piece.node = arm.builder.add_node(elsewhere);
    piece.corners = {{2, 0, 0}, {1, 0.5, 0}, {1, 0.5, 0}};
    piece.normals = {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}};
    glm::dmat4 to_elbow(1.0);
    to_elbow[3] = {-1, 0, 0, 1};
    piece.skin = arm.builder.add_skin({arm.elbow, arm.shoulder}, {to_elbow, glm::dmat4(1.0)});
    piece.influence_sets = 2;
    const Influence none{};
    const Influence forearm{{0, 0, 0, 0}, {0.25f, 0.75f, 0, 0}};
    const Influence upper_arm{{0, 0, 1, 0}, {0, 0, 1, 0}};
    const Influence half{{1, 0, 0, 0}, {0.5f, 0, 0, 0}};
    const Influence other_half{{0, 0, 0, 0}, {0, 0, 0, 0.5f}};
    piece.influences = {forearm, none, none, upper_arm, half, other_half};
    arm.builder.add_moving(piece);
    Scene scene = arm.builder.build();
    apply_pose(scene, pose_at(scene.motion, 0, 1.0));
    expect_near(scene.positions[0], {-1, 1, 0}, 1e-6);
    expect_near(scene.positions[1], {-0.5, 1, 0}, 1e-6);
    expect_near(scene.positions[2], {-0.25, 0.75, 0}, 1e-6); // the forearm alone: (0, 0.5, 0)
    expect_near(scene.normals[0], {0, -1, 0}, 1e-6);
    expect_near(scene.normals[1], {-1, 0, 0}, 1e-6);
    expect_near(scene.normals[2], glm::normalize(glm::dvec3(-1, -1, 0)), 1e-6);
}

TEST(Morph, targets_add_up_before_the_node_moves) {
    MovingSceneBuilder builder;
    MotionNode node;
    node.scale = {2, 2, 2};
    node.weight_count = 2;
    builder.motion().weights = {0.5f, -1.0f};
    MovingSceneBuilder::Piece piece;
    piece.node = builder.add_node(node);
    piece.corners = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    piece.normals = {{0, 0, 1}, {0, 0, 0}, {0, 0, 1}};
    piece.deltas = {{{0, 2, 0}, {2, 0, 0}}, {{0, 0, 2}, {2, 0, 0}}, {{0, 0, 0}, {0, 0, 0}},
                    {{0, 0, 1}, {0, 0, 0}}, {{0, 0, 0}, {1, 0, 0}}, {{3, 0, 0}, {0, 0, 1}}};
    builder.add_moving(piece);
    const Scene scene = builder.build();
    expect_near(scene.positions[0], {2, 2, -2}, 0.0);
    expect_near(scene.positions[1], {0, 2, 2}, 0.0);
    expect_near(scene.positions[2], {-6, 0, 2}, 0.0);
    expect_near(scene.normals[0], glm::normalize(glm::dvec3(1, 0, 1)), 1e-6);
    EXPECT_EQ(scene.normals[1], glm::vec3(0.0f)); // the triangle's own stays that
    EXPECT_EQ(scene.normals[2], glm::vec3(0.0f)); // nothing is left of it
}

TEST(Normals, stay_at_right_angles_to_their_surface) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int trial = 0; trial < 500; ++trial) {
        glm::dmat3 matrix;
        for (int column = 0; column < 3; ++column)
            matrix[column] = {unit(random), unit(random), unit(random)};
        if (std::abs(glm::determinant(matrix)) < 1e-2)
            continue;
        matrix *= std::pow(10.0, 12.0 * unit(random));
        const glm::dvec3 a(unit(random), unit(random), unit(random));
        const glm::dvec3 b(unit(random), unit(random), unit(random));
        const glm::dvec3 normal = glm::normalize(glm::cross(a, b));
        const glm::dvec3 moved(moved_normal(matrix, normal));
        EXPECT_NEAR(glm::length(moved), 1.0, 1e-6);
        EXPECT_NEAR(glm::dot(moved, glm::normalize(matrix * a)), 0.0, 1e-6);
        EXPECT_NEAR(glm::dot(moved, glm::normalize(matrix * b)), 0.0, 1e-6);
        EXPECT_GT(glm::dot(moved, matrix * normal), 0.0); // also where the matrix mirrors
    }
}

TEST(Normals, of_flattened_and_vanished_surfaces) {
    const glm::dmat3 flat(glm::dvec3(2, 0, 0), glm::dvec3(0, 3, 0), glm::dvec3(0, 0, 0));
    EXPECT_EQ(moved_normal(flat, {0, 0, 1}), glm::vec3(0, 0, 1));
    EXPECT_EQ(moved_normal(flat, {1, 0, 0}), glm::vec3(0.0f));
    EXPECT_EQ(moved_normal(glm::dmat3(0.0), {1, 0, 0}), glm::vec3(0.0f));
    const glm::dmat3 mirrored(glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1));
    EXPECT_EQ(moved_normal(mirrored, {1, 0, 0}), glm::vec3(-1, 0, 0));
    EXPECT_EQ(moved_normal(mirrored, {0, 1, 0}), glm::vec3(0, 1, 0));
}

TEST(Mounts, cameras_and_lights_follow_their_nodes) {
    Arm arm;
    arm.builder.scene().cameras.push_back(look_at("still", {5, 5, 5}, {0, 0, 0}, 0.7f));
    arm.builder.scene().lights.resize(2);
    arm.builder.motion().cameras.push_back({0, arm.elbow});
    arm.builder.motion().lights.push_back({1, arm.shoulder});
    const Scene scene = arm.builder.build();
    const Pose pose = pose_at(scene.motion, 0, 1.0);
    const Camera camera = camera_at(scene, 0, pose);
    expect_near(camera.eye, {0, 1, 0}, 1e-6);
    expect_near(camera.forward, {0, 0, -1}, 1e-6);
    expect_near(camera.up, {0, -1, 0}, 1e-6); // half a turn
    EXPECT_EQ(camera.vertical_fov, scene.cameras[0].vertical_fov);
    EXPECT_EQ(camera_at(scene, 1, pose).eye, glm::vec3(5, 5, 5));
    const std::vector<Light> lights = lights_at(scene, pose);
    EXPECT_EQ(lights[0].position, scene.lights[0].position);
    expect_near(lights[1].position, {0, 0, 0}, 1e-6);
    expect_near(lights[1].direction, {0, 0, -1}, 1e-6);
    Scene moved = scene;
    apply_pose(moved, pose);
    EXPECT_EQ(moved.cameras[0].eye, camera.eye);
    EXPECT_EQ(moved.lights[1].position, lights[1].position);
}

TEST(Mounts, a_squashed_node_leaves_the_camera_where_it_was) {
    Arm arm;
    arm.builder.motion().cameras.push_back({0, arm.elbow});
    const Scene scene = arm.builder.build();
    Pose pose = pose_at(scene.motion, 0, 1.0);
    pose.node_to_world[arm.elbow][2] = glm::dvec4(0.0);
    EXPECT_EQ(camera_at(scene, 0, pose).eye, scene.cameras[0].eye);
    EXPECT_EQ(camera_at(scene, 0, pose).forward, scene.cameras[0].forward);
}

// --- bounds ----------------------------------------------------------------------------------

bool contains(const Bounds& bounds, glm::vec3 p) {
    return glm::all(glm::lessThanEqual(bounds.min, p)) &&
           glm::all(glm::lessThanEqual(p, bounds.max));
}

TEST(MovingBounds, contain_every_vertex_in_any_pose) {
    std::mt19937 random(7);
    for (int trial = 0; trial < 40; ++trial) {
        Scene scene = random_moving_scene(random, kAllKinds, 4);
        for (const double seconds : {0.0, 0.3, 0.9, 1.7, 12.3}) {
            SCOPED_TRACE(testing::Message() << "trial " << trial << " at " << seconds);
            const Pose pose = pose_at(scene.motion, 0, seconds);
            apply_pose(scene, pose);
            for (const glm::vec3& position : scene.positions)
                EXPECT_TRUE(contains(scene.bounds, position));
            // Each part alone: others must not hide what it lacks.
            Motion alone = scene.motion;
            alone.still = {};
            for (const MovingPart& part : scene.motion.parts) {
                alone.parts = {part};
                const Bounds bounds = MovingBounds(alone).at(alone, pose, palette(alone, pose));
                for (uint32_t i = 0; i < part.vertex_count; ++i)
                    EXPECT_TRUE(contains(bounds, scene.positions[part.first_vertex + i]));
            }
        }
    }
}

TEST(MovingBounds, have_no_slack_where_nothing_is_mixed) {
    MovingSceneBuilder builder;
    builder.add_node({.translation = {1, 2, 3}, .scale = {2, -2, 2}});
    MovingSceneBuilder::Piece piece;
    piece.corners = {{-1, 0, 0}, {1, 1, 0}, {0, 1, 1}};
    piece.normals.assign(3, glm::vec3(0.0f));
    builder.add_moving(piece);
    const Bounds bounds = builder.build().bounds;
    expect_near(bounds.min, {-1, 0, 3}, 1e-4);
    expect_near(bounds.max, {3, 2, 5}, 1e-4);
}

TEST(MovingBounds, refuse_what_is_too_far_away_or_no_number) {
    for (const float far : {2e9f, 3e38f}) {
        MovingSceneBuilder builder;
        for (int depth = 0; depth < 10; ++depth)
            builder.add_node({.parent = depth - 1, .scale = glm::dvec3(depth ? far : 1.0)});
        builder.add_channel(0, MotionPath::translation, Interpolation::linear, {0.0f, 1.0f},
                            {0, 0, 0, far, 0, 0});
        MovingSceneBuilder::Piece piece;
        piece.node = far > 1e30f ? 9 : 0;
        piece.corners = {{0, 0, 0}, {1, 1, 0}, {0, 1, 1}};
        piece.normals.assign(3, glm::vec3(0.0f));
        builder.add_moving(piece);
        const Motion& motion = builder.motion();
        const Pose pose = pose_at(motion, 0, 1.0);
        EXPECT_NE(error_of([&] {
                      MovingBounds(motion).at(motion, pose, palette(motion, pose));
                  }).find("beyond 1000000000 m"),
                  std::string::npos);
    }
}

// --- names -----------------------------------------------------------------------------------

TEST(FindAnimation, by_name_or_number) {
    Scene scene;
    scene.name = "dance";
    EXPECT_EQ(find_animation(scene, ""), -1);
    EXPECT_EQ(find_animation(scene, "none"), -1);
    EXPECT_EQ(error_of([&] { find_animation(scene, "walk"); }),
              "scene 'dance' has no animation 'walk': it has none at all");
    for (const char* name : {"walk", "run", "2", ""})
        scene.motion.animations.push_back({name, 1.0, {}});
    EXPECT_EQ(find_animation(scene, ""), 0);
    EXPECT_EQ(find_animation(scene, "none"), -1);
    EXPECT_EQ(find_animation(scene, "run"), 1);
    EXPECT_EQ(find_animation(scene, "1"), 1);
    EXPECT_EQ(find_animation(scene, "2"), 2); // a name, too
    EXPECT_EQ(find_animation(scene, "3"), 3);
    EXPECT_EQ(error_of([&] { find_animation(scene, "rum"); }),
              "scene 'dance' has no animation 'rum': did you mean 'run'? (it has walk, run, 2, ; "
              "numbers go from 0 to 3)");
    for (const char* wanted : {"4", "-1", "1x", "99999999999999999999"})
        EXPECT_NE(error_of([&] { find_animation(scene, wanted); }).find("0 to 3"),
                  std::string::npos);
}

} // namespace
} // namespace romascope
