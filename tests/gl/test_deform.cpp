// SPDX-License-Identifier: MIT
#include "renderer/passes/deform.h"
#include "renderer/scene/gltf/import.h"
#include "tests/gl/gl_test.h"
#include "tests/support/moving_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <filesystem>

namespace romascope {
namespace {

namespace fs = std::filesystem;

/// Of the largest coordinate. A vertex is a sum of up to 8 joints' terms of 4 products each, in
/// single precision: a few times 2^-24 = 6e-8 for each. Terms that cancel, and targets, may be
/// larger than their sum. Measured on random scenes: 2e-7.
constexpr double kPositionTolerance = 1e-6;

/// Unit normals, where the surface is not squashed. Measured on random scenes: 3e-6.
constexpr double kNormalTolerance = 3e-5;

double largest_coordinate(const Bounds& bounds) {
    const glm::vec3 largest = glm::max(glm::abs(bounds.min), glm::abs(bounds.max));
    return std::max({largest.x, largest.y, largest.z});
}

struct Vertices {
    std::vector<glm::vec3> positions, normals;
    bool operator==(const Vertices&) const = default;
};

/// In words, empty if there is none.
std::string difference(const Image& a, const Image& b) {
    size_t count = 0;
    float worst = 0.0f;
    for (size_t i = 0; i < a.data.size(); ++i) {
        count += a.data[i] != b.data[i];
        worst = std::max(worst, std::abs(a.data[i] - b.data[i]));
    }
    return count ? fmt::format("{} of {} values differ, by up to {}", count, a.data.size(), worst)
                 : "";
}

class DeformTest : public GlTest {
protected:
    Vertices download(const GpuScene& scene) {
        return {scene.positions().download<glm::vec3>(), scene.normals().download<glm::vec3>()};
    }

    /// Moves on the GPU and on the CPU and compares.
    void check(const Scene& scene, Deform& deform, GpuScene& gpu, int animation, double seconds) {
        SCOPED_TRACE(testing::Message() << "second " << seconds);
        const Pose pose = pose_at(scene.motion, animation, seconds);
        Scene expected = scene;
        apply_pose(expected, pose);
        deform.run(shaders_, *timer_, gpu, scene.motion, pose);
        const Vertices found = download(gpu);
        EXPECT_EQ(gpu.bounds().min, expected.bounds.min);
        EXPECT_EQ(gpu.bounds().max, expected.bounds.max);
        ASSERT_EQ(found.positions.size(), expected.positions.size());
        double position_error = 0, normal_error = 0;
        size_t outside = 0, still_moved = 0;
        for (size_t i = 0; i < found.positions.size(); ++i) {
            const glm::vec3 p = found.positions[i];
            position_error =
                std::max(position_error, double{glm::distance(p, expected.positions[i])});
            // Rounding may decide whether a normal that all but vanishes is there.
            const bool vanished =
                (found.normals[i] == glm::vec3(0.0f)) != (expected.normals[i] == glm::vec3(0.0f));
            if (!vanished)
                normal_error = std::max(
                    normal_error, double{glm::distance(found.normals[i], expected.normals[i])});
            vanished_ += vanished;
            outside += glm::any(glm::lessThan(p, expected.bounds.min)) ||
                       glm::any(glm::greaterThan(p, expected.bounds.max));
            still_moved += i < scene.motion.first_vertex && p != scene.positions[i];
        }
        const double size = largest_coordinate(expected.bounds);
        EXPECT_LE(position_error, kPositionTolerance * size);
        EXPECT_LE(normal_error, kNormalTolerance);
        EXPECT_EQ(outside, 0u);
        EXPECT_EQ(still_moved, 0u);
        worst_position_ = std::max(worst_position_, position_error / size);
        worst_normal_ = std::max(worst_normal_, normal_error);
    }

    BitGrid occupancy(const GpuScene& scene) {
        OccupancyMap map;
        map.build(frame(scene, settings_));
        return map.download();
    }

    Settings settings_{all_knobs()};
    double worst_position_ = 0, worst_normal_ = 0;
    size_t vanished_ = 0;
};

TEST_F(DeformTest, EqualsTheCpuOnRandomScenes) {
    std::mt19937 random(11);
    const MovingKinds choices[] = {
        {.rigid = true},    {.skinned = true},          {.skinned_twice = true},
        {.morphing = true}, {.morphing_skinned = true}, {.rigid = true, .morphing = true},
        kAllKinds};
    for (const MovingKinds& kinds : choices) {
        for (int trial = 0; trial < 6; ++trial) {
            SCOPED_TRACE(testing::Message() << "kinds " << &kinds - choices << ", trial " << trial);
            const Scene scene = random_moving_scene(random, kinds);
            GpuScene gpu(scene);
            Deform deform(scene.motion);
            for (const double seconds : {0.0, 0.4, 1.1, 2.9})
                check(scene, deform, gpu, 0, seconds);
            check(scene, deform, gpu, -1, 0.0);
        }
    }
    EXPECT_EQ(vanished_, 0u);
    RecordProperty("position_error", fmt::format("{:.1e}", worst_position_));
    RecordProperty("normal_error", fmt::format("{:.1e}", worst_normal_));
}

TEST_F(DeformTest, FindsThePartOfEachVertex) {
    for (const uint32_t count : {1u, 2u, 3u, 7u, 8u, 9u, 64u, 1000u, 3000u}) {
        SCOPED_TRACE(testing::Message() << count << " parts");
        MovingSceneBuilder builder;
        MovingSceneBuilder::Piece piece;
        for (uint32_t i = 0; i < count; ++i) {
            MotionNode node;
            node.translation = {0.125 * i, 1.0, -1.0};
            piece.node = builder.add_node(node);
            for (uint32_t corner = 0; corner < 3 * (1 + i % 3); ++corner)
                piece.corners.emplace_back(corner, i, corner % 2);
            piece.normals.assign(piece.corners.size(), glm::vec3(0, 1, 0));
            builder.add_moving(piece);
            piece.corners.clear();
        }
        const Scene scene = builder.build(); // all is exact in single precision
        Scene rest = scene;
        std::fill(rest.positions.begin(), rest.positions.end(), glm::vec3(0.0f));
        GpuScene gpu(rest);
        Deform(scene.motion)
            .run(shaders_, *timer_, gpu, scene.motion, pose_at(scene.motion, -1, 0));
        EXPECT_EQ(download(gpu).positions, scene.positions);
        EXPECT_EQ(download(gpu).normals, scene.normals);
    }
}

TEST_F(DeformTest, MovesMoreVerticesThanOneRowOfGroups) {
    MovingSceneBuilder builder;
    builder.add_still({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    MovingSceneBuilder::Piece piece;
    MotionNode node;
    node.translation = {1, 2, 3};
    piece.node = builder.add_node(node);
    const size_t count = 3 * 400'000; // a row has 2^20
    for (size_t i = 0; i < count; ++i)
        piece.corners.emplace_back(i % 1024, i / 1024, i % 7);
    piece.normals.assign(count, glm::vec3(1, 0, 0));
    builder.add_moving(piece);
    const Scene scene = builder.build();
    Scene rest = scene;
    std::fill(rest.positions.begin() + 3, rest.positions.end(), glm::vec3(0.0f));
    GpuScene gpu(rest);
    Deform(scene.motion).run(shaders_, *timer_, gpu, scene.motion, pose_at(scene.motion, -1, 0));
    EXPECT_TRUE(download(gpu).positions == scene.positions);
}

TEST_F(DeformTest, KeepsTheDirectionOfNormalsAtAnyScale) {
    for (const double scale : {1e-9, 1.0, 1e6}) {
        MovingSceneBuilder builder;
        MotionNode node;
        node.scale = scale * glm::dvec3(1, 2, -3);
        MovingSceneBuilder::Piece piece;
        piece.node = builder.add_node(node);
        piece.corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 1}};
        piece.normals.assign(3, glm::normalize(glm::vec3(1, 2, 3)));
        builder.add_moving(piece);
        const Scene scene = builder.build();
        GpuScene gpu(scene);
        Deform(scene.motion)
            .run(shaders_, *timer_, gpu, scene.motion, pose_at(scene.motion, -1, 0));
        const glm::vec3 expected = glm::normalize(glm::vec3(1, 1, -1));
        EXPECT_LE(glm::distance(download(gpu).normals[0], expected), kNormalTolerance) << scale;
    }
}

TEST_F(DeformTest, GivesTheSameBytesWhateverWentBefore) {
    std::mt19937 random(4);
    const Scene scene = random_moving_scene(random, kAllKinds, 300);
    const Pose pose = pose_at(scene.motion, 0, 1.3);
    const Pose other = pose_at(scene.motion, 0, 0.2);
    GpuScene gpu(scene);
    Deform deform(scene.motion);
    deform.run(shaders_, *timer_, gpu, scene.motion, pose);
    const Vertices first = download(gpu);
    deform.run(shaders_, *timer_, gpu, scene.motion, other);
    EXPECT_FALSE(download(gpu) == first);
    deform.run(shaders_, *timer_, gpu, scene.motion, pose);
    EXPECT_TRUE(download(gpu) == first);
    GpuScene again(scene);
    Deform(scene.motion).run(shaders_, *timer_, again, scene.motion, pose);
    EXPECT_TRUE(download(again) == first);
}

TEST_F(DeformTest, OccupancyMapFollowsWhoeverBuildsIt) {
    const Scene scene = exact_moving_scene();
    for (const OccupancyBuilder builder : {OccupancyBuilder::raster, OccupancyBuilder::compute}) {
        settings_.set(kOccupancyBuilder, builder);
        GpuScene gpu(scene);
        Deform deform(scene.motion);
        BitGrid last = occupancy(gpu);
        for (const double seconds : {1.0, 2.0, 3.0, 4.0}) {
            const Pose pose = pose_at(scene.motion, 0, seconds);
            deform.run(shaders_, *timer_, gpu, scene.motion, pose);
            Scene posed = scene;
            apply_pose(posed, pose);
            const BitGrid moved = occupancy(gpu);
            EXPECT_TRUE(moved == occupancy(GpuScene(posed))) << seconds;
            EXPECT_FALSE(moved == last) << seconds;
            last = moved;
        }
    }
}

TEST_F(DeformTest, OccupancyMapOfRandomScenesFollowsButForRounding) {
    std::mt19937 random(21);
    size_t set = 0, different = 0;
    for (int trial = 0; trial < 6; ++trial) {
        const Scene scene = random_moving_scene(random, kAllKinds);
        const Pose pose = pose_at(scene.motion, 0, 0.8);
        GpuScene gpu(scene);
        Deform(scene.motion).run(shaders_, *timer_, gpu, scene.motion, pose);
        Scene posed = scene;
        apply_pose(posed, pose);
        const BitGrid moved = occupancy(gpu), expected = occupancy(GpuScene(posed));
        ASSERT_EQ(moved.size(), expected.size());
        for (size_t i = 0; i < moved.words().size(); ++i)
            different += std::popcount(moved.words()[i] ^ expected.words()[i]);
        set += expected.count();
    }
    // Vertices are off by some 1e-4 cells of 128, and a vertex is rounded to 1/256 of a cell: of
    // the cells along a triangle's rim and where it passes from one to the next, one in a hundred
    // may change.
    EXPECT_LE(different, set / 100);
    EXPECT_GT(set, 10'000u);
}

TEST_F(DeformTest, PicturesFollow) {
    const Scene scene = exact_moving_scene();
    settings_.set(kWidth, 96);
    settings_.set(kHeight, 64);
    settings_.set(kView, PictureKind::lit); // of normals and of ambient occlusion
    Pipeline moving(scene, ShaderLibrary());
    Image last;
    for (const double seconds : {0.0, 2.0, 3.0}) {
        Scene posed = scene;
        const Pose pose = pose_at(scene.motion, 0, seconds);
        apply_pose(posed, pose);
        posed.motion = {};
        Pipeline still(posed, ShaderLibrary());
        moving.set_pose(pose);
        moving.restart();
        for (int i = 0; i < 2; ++i) {
            moving.render(settings_, scene.cameras[0]);
            still.render(settings_, scene.cameras[0]);
        }
        EXPECT_EQ(difference(moving.picture(), still.picture()), "") << seconds;
        EXPECT_NE(moving.picture().data, last.data);
        last = moving.picture();
    }
}

TEST_F(DeformTest, ANewPoseStartsTheMeanAnewAndTheSameDoesNot) {
    const Scene scene = exact_moving_scene();
    settings_.set(kWidth, 32);
    settings_.set(kHeight, 32);
    Pipeline pipeline(scene, ShaderLibrary());
    const auto render_at = [&](double seconds) {
        pipeline.set_pose(pose_at(scene.motion, 0, seconds));
        pipeline.render(settings_, scene.cameras[0]);
        return pipeline.picture();
    };
    const Image first = render_at(1.0);
    EXPECT_EQ(pipeline.frame_count(), 1u);
    render_at(1.0);
    EXPECT_EQ(pipeline.frame_count(), 2u);
    render_at(1.5);
    EXPECT_EQ(pipeline.frame_count(), 1u);
    EXPECT_NE(render_at(1.0).data, first.data); // other random directions
    EXPECT_EQ(pipeline.frame_count(), 1u);
    pipeline.restart();
    EXPECT_EQ(render_at(1.0).data, first.data);
}

TEST_F(DeformTest, TheChosenCameraFollowsItsNode) {
    Scene scene = exact_moving_scene();
    scene.motion.cameras.push_back({0, scene.motion.parts[1].node});
    settings_.set(kTime, 0.5);
    settings_.set(kFps, 2.0);
    const Pose pose = pose_of_frame(scene, settings_, 3);
    EXPECT_EQ(pose, pose_at(scene.motion, 0, 2.0));
    EXPECT_EQ(chosen_camera(scene, settings_, pose).eye, camera_at(scene, 0, pose).eye);
    settings_.set(kCamera, "camera");
    EXPECT_EQ(chosen_camera(scene, settings_, pose).eye, camera_at(scene, 0, pose).eye);
    settings_.set(kCamera, "1,2,3/0,0,0/60");
    EXPECT_EQ(chosen_camera(scene, settings_, pose).eye, glm::vec3(1, 2, 3));
}

/// The glTF files in the folder that ROMASCOPE_SCENES names, and below.
std::vector<fs::path> scene_files() {
    std::vector<fs::path> files;
    if (const char* folder = std::getenv("ROMASCOPE_SCENES"))
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
            if (entry.path().extension() == ".glb" || entry.path().extension() == ".gltf")
                files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

TEST_F(DeformTest, EqualsTheCpuOnAnimatedFiles) {
    int moving = 0;
    for (const fs::path& file : scene_files()) {
        SCOPED_TRACE(file.string());
        const Scene scene = load_gltf(file);
        if (scene.motion.parts.empty())
            continue;
        ++moving;
        GpuScene gpu(scene);
        Deform deform(scene.motion);
        for (int i = 0; i < static_cast<int>(scene.motion.animations.size()); ++i)
            for (const double part : {0.0, 0.21, 0.5, 0.83, 1.0})
                check(scene, deform, gpu, i,
                      part * scene.motion.animations[static_cast<size_t>(i)].duration);
    }
    if (moving == 0)
        GTEST_SKIP() << "ROMASCOPE_SCENES names no folder with glTF files that move";
    RecordProperty("files", moving);
}

} // namespace
} // namespace romascope
