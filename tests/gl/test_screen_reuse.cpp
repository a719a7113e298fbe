// SPDX-License-Identifier: MIT
// The stages in the frame: every combination of them, what starts them anew, what moves.
#include "renderer/frame/jump.h"
#include "renderer/passes/deform.h"
#include "renderer/reuse/running_mean.h"
#include "tests/gl/reuse_test.h"
#include "tests/support/moving_scene.h"

#include <cmath>

namespace romascope {
namespace {

class ScreenReuseTest : public ReuseTest {
protected:
    void SetUp() override {
        ReuseTest::SetUp();
        settings_.set(kWidth, kSize.x);
        settings_.set(kHeight, kSize.y);
        settings_.set(kOccupancyResolution, 32);
        settings_.set(kAoRays, 1);
        settings_.set(kMean, false);
    }

    void choose(int combination) {
        settings_.set(kTemporal, (combination & 1) != 0);
        settings_.set(kAtrous, (combination & 2) != 0);
        settings_.set(kTaa, (combination & 4) != 0);
    }

    /// How many frames each pixel's history has.
    std::vector<double> frames_of(Pipeline& pipeline, const Camera& camera) {
        Settings settings = settings_;
        settings.set(kView, PictureKind::history);
        pipeline.render(settings, camera);
        const Image image = pipeline.picture();
        std::vector<double> frames;
        for (size_t i = 0; i < image.data.size(); i += 3)
            if (image.data[i] == image.data[i + 2]) // not the background
                frames.push_back(1 + double{image.data[i]} * (settings.get(kTemporalLength) - 1));
        return frames;
    }

    static Scene box() {
        std::vector<glm::vec3> corners = rectangle({0, 0, 0}, {0, 1, 0}, 2.0f);
        for (const glm::vec3 corner : rectangle({0.3f, 0.5f, -0.4f}, {1, 0, 1}, 0.5f))
            corners.push_back(corner);
        return scene_of_triangles(corners);
    }
};

TEST_F(ScreenReuseTest, EveryCombinationDrawsFinitePicturesOfWhatMoves) {
    std::mt19937 random(2);
    const Scene scene = random_moving_scene(random, kAllKinds);
    const Camera camera = look_at("camera", scene.bounds.centre() + scene.bounds.extent(),
                                  scene.bounds.centre(), 1.0f);
    const glm::vec3 step = 0.01f * scene.bounds.extent();
    for (const PictureKind kind : {PictureKind::ambient_occlusion, PictureKind::lit}) {
        settings_.set(kView, kind);
        std::vector<std::vector<float>> pictures;
        for (int combination = 0; combination < 8; ++combination) {
            SCOPED_TRACE(testing::Message() << "combination " << combination);
            choose(combination);
            Pipeline pipeline(scene, ShaderLibrary());
            for (int round = 0; round < 2; ++round) {
                pipeline.restart();
                Image last;
                for (int i = 0; i < 5; ++i) {
                    pipeline.set_pose(pose_at(scene.motion, 0, 0.05 * i));
                    pipeline.render(settings_, moved(camera, static_cast<float>(i) * step));
                    last = pipeline.picture();
                    for (const float value : last.data)
                        ASSERT_TRUE(value >= 0.0f && value <= 2.0f) << value;
                }
                if (round == 0)
                    pictures.push_back(last.data);
                else
                    EXPECT_EQ(last.data, pictures.back()) << "the same frames, the same bytes";
            }
        }
        for (size_t a = 0; a < pictures.size(); ++a)
            for (size_t b = 0; b < a; ++b)
                EXPECT_NE(pictures[a], pictures[b]) << "stages " << a << " and " << b;
    }
}

TEST_F(ScreenReuseTest, MotionIsWhatTheVerticesMovedBy) {
    const Scene scene = exact_moving_scene();
    GpuScene gpu(scene);
    Deform deform(scene.motion);
    const Pose before = pose_at(scene.motion, 0, 1.0), now = pose_at(scene.motion, 0, 1.25);
    deform.run(shaders_, *timer_, gpu, scene.motion, before);
    gpu.remember_positions();
    deform.run(shaders_, *timer_, gpu, scene.motion, now);
    Scene first = scene, second = scene;
    apply_pose(first, before);
    apply_pose(second, now);
    std::vector<glm::vec3> ways;
    for (size_t i = 0; i < first.positions.size(); ++i)
        ways.push_back(second.positions[i] - first.positions[i]);
    const Camera camera = look_at(
        "camera", second.bounds.centre() + 0.8f * second.bounds.extent() + glm::vec3(0, 0, 1),
        second.bounds.centre(), 1.0f);
    const View view = view_of(camera);
    gbuffer_.draw(frame(gpu, settings_), view, true);
    const std::vector<float> motion = gbuffer_.motion().download_float(4);
    const std::vector<Seen> points = seen(view);
    size_t on_a_triangle = 0, visible = 0, moving = 0;
    for (size_t pixel = 0; pixel < points.size(); ++pixel) {
        const glm::dvec3 way(motion[4 * pixel], motion[4 * pixel + 1], motion[4 * pixel + 2]);
        if (points[pixel].depth == 0) {
            EXPECT_EQ(way, glm::dvec3(0.0));
            continue;
        }
        ++visible;
        // Some triangle has the point, and its corners' ways mix to the point's.
        const double small = 1e-3 * points[pixel].depth;
        bool found = false;
        for (size_t i = 0; i < second.indices.size() && !found; i += 3) {
            const auto at = [&](const std::vector<glm::vec3>& values, size_t k) {
                return glm::dvec3(values[second.indices[i + k]]);
            };
            const glm::dvec3 a = at(second.positions, 0), ab = at(second.positions, 1) - a,
                             ac = at(second.positions, 2) - a, ap = points[pixel].position - a;
            const glm::dvec3 normal = glm::cross(ab, ac);
            const double area = glm::dot(normal, normal);
            if (area == 0 || std::abs(glm::dot(ap, normal)) > small * std::sqrt(area))
                continue;
            const double v = glm::dot(glm::cross(ap, ac), normal) / area;
            const double w = glm::dot(glm::cross(ab, ap), normal) / area;
            if (v < -0.01 || w < -0.01 || v + w > 1.01)
                continue;
            const glm::dvec3 expected =
                at(ways, 0) + v * (at(ways, 1) - at(ways, 0)) + w * (at(ways, 2) - at(ways, 0));
            found = glm::distance(expected, way) < 0.02 * (glm::length(expected) + small);
        }
        on_a_triangle += found;
        moving += glm::length(way) > 0.01;
    }
    EXPECT_GT(visible, 100u);
    EXPECT_GT(moving, 30u);
    EXPECT_GE(on_a_triangle, visible * 98 / 100) << "some lie on an edge";
}

TEST_F(ScreenReuseTest, HistoryGoesWithWhatMoves) {
    // A board that crosses the picture by four of its pixels a frame, before a wall.
    MovingSceneBuilder builder;
    builder.add_still(rectangle({0, 0, -2}, {0, 0, 1}, 8.0f));
    const uint32_t node = builder.add_node({});
    MovingSceneBuilder::Piece piece;
    piece.corners = rectangle({-2, 0, 0}, {0, 0, 1}, 0.6f);
    piece.normals.assign(piece.corners.size(), glm::vec3(0, 0, 1));
    piece.node = node;
    builder.add_moving(piece);
    builder.add_channel(node, MotionPath::translation, Interpolation::linear, {0, 1},
                        {0, 0, 0, 4, 0, 0});
    const Scene scene = builder.build();
    const Camera camera = look_at("front", {0, 0, 4}, {0, 0, 0}, 1.0f);
    settings_.set(kTemporal, true);
    Pipeline pipeline(scene, ShaderLibrary());
    std::vector<double> frames;
    for (int i = 0; i < 8; ++i) {
        pipeline.set_pose(pose_at(scene.motion, 0, 0.25 + 0.07 * i));
        frames = frames_of(pipeline, camera);
    }
    ASSERT_EQ(frames.size(), index(0, kSize.y));
    size_t all = 0;
    for (const double f : frames)
        all += std::abs(f - 8) < 0.1;
    // The board covers 11 x 11 pixels and goes on by 2.6 a frame; the two or three columns that
    // come out behind it, less one that goes on from its neighbours, have fewer than 8 frames for
    // seven.
    EXPECT_GT(all, frames.size() - 7 * 4 * 13);
    EXPECT_LT(all, frames.size() - 7 * 1 * 9);
    const int row = kSize.y / 2;
    const double board = frames[index(kSize.x / 2 + 9, row)];
    EXPECT_NEAR(board, 8, 0.1) << "the board's own history went with it";
    // What stands still again goes on.
    for (int i = 0; i < 4; ++i)
        frames = frames_of(pipeline, camera);
    EXPECT_NEAR(frames[index(kSize.x / 2 + 9, row)], 12, 0.1);
}

TEST_F(ScreenReuseTest, WhatJumpsBeginsAnewAndNothingElse) {
    const Scene scene = box();
    const Camera camera = scene.cameras.front();
    settings_.set(kTemporal, true);
    settings_.set(kAtrous, true);
    Pipeline pipeline(scene, ShaderLibrary());
    const auto least_and_most = [&] {
        const std::vector<double> frames = frames_of(pipeline, camera);
        const auto [least, most] = std::ranges::minmax_element(frames);
        return std::pair(std::lround(*least), std::lround(*most));
    };
    using Frames = std::pair<long, long>;
    for (int i = 0; i < 4; ++i)
        pipeline.render(settings_, camera);
    EXPECT_EQ(least_and_most(), Frames(5, 5));
    settings_.set(kSunStrength, 3.0); // what the picture shows is another thing
    settings_.set(kAtrousIterations, 2);
    settings_.set(kTaa, true);
    settings_.set(kTime, 0.5);
    const std::vector<double> frames = frames_of(pipeline, camera);
    EXPECT_GT(std::ranges::count_if(frames, [](double f) { return f > 5.5; }),
              static_cast<long>(frames.size() * 9 / 10));
    settings_.set(kTaa, false);
    for (int i = 0; i < 8; ++i)
        pipeline.render(settings_, camera);
    settings_.set(kAoRadius, 0.3);
    EXPECT_EQ(least_and_most(), Frames(1, 1));
    EXPECT_EQ(least_and_most(), Frames(2, 2));
    settings_.set(kOccupancyResolution, 64);
    EXPECT_EQ(least_and_most(), Frames(1, 1));
    settings_.set(kTracer, std::string("dda"));
    EXPECT_EQ(least_and_most(), Frames(1, 1));
    settings_.set(kWidth, kSize.x - 8);
    EXPECT_EQ(least_and_most(), Frames(1, 1));
    settings_.set(kTemporal, false);
    pipeline.render(settings_, camera);
    settings_.set(kTemporal, true);
    EXPECT_EQ(least_and_most(), Frames(1, 1));
    pipeline.restart();
    EXPECT_EQ(least_and_most(), Frames(1, 1));
}

TEST_F(ScreenReuseTest, WhatIsSwitchedOffHoldsNothing) {
    settings_.set(kTracer, std::string("dda")); // aligned maps differ from frame to frame
    const Scene scene = box();
    Pipeline pipeline(scene, ShaderLibrary());
    const auto held = [&] {
        pipeline.render(settings_, scene.cameras.front());
        size_t bytes = 0;
        for (const StructureBytes& structure : pipeline.bytes())
            bytes += structure.bytes;
        return bytes;
    };
    const size_t plain = held(), pixels = index(0, kSize.y);
    for (int combination = 1; combination < 8; ++combination) {
        choose(combination);
        EXPECT_EQ(held() - plain, pixels * ScreenReuse::bytes_per_pixel(settings_, false))
            << "stages " << combination;
        choose(0);
        EXPECT_EQ(held(), plain) << "stages " << combination;
    }
}

TEST_F(ScreenReuseTest, OffTheyChangeNothing) {
    const Scene scene = box();
    Pipeline pipeline(scene, ShaderLibrary());
    pipeline.render(settings_, scene.cameras.front());
    const Image plain = pipeline.picture();
    settings_.set(kView, PictureKind::ambient_occlusion_raw);
    choose(3);
    pipeline.restart();
    pipeline.render(settings_, scene.cameras.front());
    EXPECT_EQ(pipeline.picture().data, plain.data) << "raw is before them";
    settings_.set(kView, PictureKind::ambient_occlusion);
    choose(1);
    pipeline.restart();
    pipeline.render(settings_, scene.cameras.front());
    const std::vector<float> first = pipeline.picture().data;
    for (size_t i = 0; i < first.size(); ++i)
        ASSERT_NEAR(first[i], plain.data[i], 1.0 / 65535) << "a first frame is its own history";
}

} // namespace
} // namespace romascope
