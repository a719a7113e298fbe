// SPDX-License-Identifier: MIT
// Temporal accumulation: history follows surfaces, and only them.
#include "tests/gl/reuse_test.h"

#include <cmath>
#include <numeric>

namespace romascope {
namespace {

/// A frame's outcome.
struct Outcome {
    std::vector<float> result;  ///< a pixel
    std::vector<float> history; ///< four a pixel: mean, fast mean, mean of squares, frames
    float mean(size_t pixel) const { return history[4 * pixel]; }
    float frames(size_t pixel) const { return history[4 * pixel + 3]; }
};

class TemporalTest : public ReuseTest {
protected:
    void SetUp() override {
        ReuseTest::SetUp();
        settings_.set(kTemporal, true);
        settings_.set(kTemporalClamp, std::numeric_limits<double>::infinity());
    }

    /// One frame. `value` is asked for once the G-buffer is drawn.
    Outcome render(const GpuScene& scene, const View& view,
                   const std::function<std::vector<float>()>& value) {
        const FrameContext context = frame(scene, settings_);
        gbuffer_.draw(context, view, scene.has_previous_positions());
        const Texture values = upload(value());
        temporal_.run(context, view, gbuffer_, before_, values);
        before_.remember(gbuffer_, view);
        return {temporal_.result().download_float(1), temporal_.history().download_float(4)};
    }

    static Scene floor_and_wall() {
        std::vector<glm::vec3> corners = rectangle({0, 0, 0}, {0, 1, 0}, 3.0f);
        for (const glm::vec3 corner : rectangle({0, 1.2f, -2}, {0.2f, 0.1f, 1}, 1.0f))
            corners.push_back(corner);
        return scene_of_triangles(corners);
    }

    SurfaceHistory before_;
    TemporalAccumulation temporal_;
};

TEST_F(TemporalTest, AStillCameraKeepsEveryHistory) {
    const Scene scene = floor_and_wall();
    const GpuScene gpu(scene);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit;
    settings_.set(kTemporalLength, 8);
    // Shifted by part of a pixel from frame to frame, as by an antialiasing, or not.
    for (const float shift : {0.0f, 0.9f}) {
        temporal_.reset();
        std::vector<double> mean(index(0, kSize.y));
        for (int i = 1; i <= 20; ++i) {
            SCOPED_TRACE(testing::Message() << "frame " << i << ", shift " << shift);
            const View view = view_of(scene.cameras.front(),
                                      shift * glm::vec2(unit(random) - 0.5f, unit(random) - 0.5f));
            const std::vector<float> values = each_pixel([&](int, int) { return unit(random); });
            const Outcome outcome = render(gpu, view, [&] { return values; });
            size_t begun_anew = 0;
            for (size_t pixel = 0; pixel < values.size(); ++pixel) {
                const double count = std::min(i, 8);
                mean[pixel] += (double{values[pixel]} - mean[pixel]) / count;
                if (shift == 0.0f) {
                    ASSERT_EQ(outcome.frames(pixel), static_cast<float>(count));
                    ASSERT_NEAR(outcome.mean(pixel), mean[pixel], 1e-5);
                    ASSERT_NEAR(outcome.result[pixel], mean[pixel], 1e-5 + 0.5 / 65535);
                } else {
                    // At an edge the pixel shows now one, now the other surface.
                    begun_anew += outcome.frames(pixel) != static_cast<float>(count) ||
                                  std::abs(double{outcome.mean(pixel)} - mean[pixel]) > 1e-5;
                }
            }
            EXPECT_LT(begun_anew, mean.size() / 20)
                << "only where three surfaces meet in one pixel";
        }
    }
}

TEST_F(TemporalTest, HistoryFollowsASurfaceUnderAMovingCamera) {
    const Scene scene = floor_and_wall();
    const GpuScene gpu(scene);
    // A texture of the world, which every frame gives alike: a mean along the way of each point is
    // that point's value, but for what lies between four pixels.
    const auto texture = [](glm::dvec3 p) {
        return 0.5 + 0.2 * std::sin(2 * p.x) + 0.2 * std::cos(3 * p.z + p.y);
    };
    const Camera start = look_at("start", {0.3f, 1.5f, 3.0f}, {0, 0.3f, -1}, 1.0f);
    std::vector<View> views;
    std::vector<double> errors;
    for (int i = 0; i < 12; ++i) {
        const View view =
            view_of(moved(start, static_cast<float>(i) * glm::vec3(0.04f, 0.01f, -0.03f)));
        std::vector<Seen> points;
        const Outcome outcome = render(gpu, view, [&] {
            points = seen(view);
            return each_pixel([&](int x, int y) {
                const Seen& point = points[index(x, y)];
                return static_cast<float>(point.depth > 0 ? texture(point.position) : 0.0);
            });
        });
        size_t kept = 0, visible = 0, came_in = 0;
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 0; x < kSize.x; ++x) {
                const Seen& point = points[index(x, y)];
                if (point.depth == 0)
                    continue;
                errors.push_back(
                    std::abs(double{outcome.mean(index(x, y))} - texture(point.position)));
                if (views.empty())
                    continue;
                ++visible;
                const glm::dvec2 place = place_of(views.back(), point.position);
                const glm::dvec2 inside = glm::dvec2(kSize) - 1.0;
                if (place.x < -1.6 || place.y < -1.6 || place.x > inside.x + 1.6 ||
                    place.y > inside.y + 1.6) {
                    ++came_in;
                    EXPECT_EQ(outcome.frames(index(x, y)), 1.0f) << x << " " << y;
                }
                kept += outcome.frames(index(x, y)) > 1.0f;
            }
        }
        if (!views.empty()) {
            EXPECT_GT(kept + came_in, visible * 96 / 100) << "frame " << i;
        }
        views.push_back(view);
    }
    // Between pixels at most an eighth of their distance squared times the curvature, 2.6 a square
    // metre, is lost at a time, a dozen times; distances are 0.07 m across, and up to four times as
    // much along the floor at its far end. At the borders of a surface only one side of a point has
    // history, which is a pixel off there: up to the slope, 1 a metre, times that.
    std::ranges::sort(errors);
    EXPECT_LT(errors[errors.size() / 2], 0.01);
    EXPECT_LT(errors[errors.size() * 95 / 100], 0.04);
    EXPECT_LT(errors.back(), 0.3);
    EXPECT_GT(errors.back(), 0.0) << "or nothing was between pixels";
}

TEST_F(TemporalTest, WhatAnotherSurfaceLeftIsNeverUsed) {
    // A board before a wall; the camera passes by. The wall is 1 and the board 0, and so it stays
    // to the last bit, also where the board has just been.
    std::vector<glm::vec3> corners = rectangle({0, 0, -1}, {0, 0, 1}, 6.0f);
    for (const glm::vec3 normal : {glm::vec3(0, 0, 1), glm::normalize(glm::vec3(1, 0, 1))}) {
        const Scene scene = scene_of_triangles([&] {
            std::vector<glm::vec3> all = corners;
            for (const glm::vec3 corner : rectangle({0, 0, 0}, normal, 0.4f))
                all.push_back(corner);
            return all;
        }());
        const GpuScene gpu(scene);
        temporal_.reset();
        size_t disoccluded = 0;
        std::vector<Seen> last;
        View last_view;
        for (int i = 0; i < 6; ++i) {
            const glm::vec3 eye(0.4f * static_cast<float>(i) - 1.0f, 0, 2);
            const View view = view_of(look_at("passing", eye, eye - glm::vec3(0, 0, 2), 1.0f));
            std::vector<Seen> points;
            std::vector<float> values;
            const Outcome outcome = render(gpu, view, [&] {
                points = seen(view);
                return values = each_pixel([&](int x, int y) {
                           return points[index(x, y)].position.z < -0.9 ? 1.0f : 0.0f;
                       });
            });
            for (size_t pixel = 0; pixel < values.size(); ++pixel)
                ASSERT_EQ(outcome.mean(pixel), values[pixel]) << pixel << " in frame " << i;
            for (int y = 0; i > 0 && y < kSize.y; ++y) {
                for (int x = 0; x < kSize.x; ++x) {
                    const glm::ivec2 was(
                        glm::floor(place_of(last_view, points[index(x, y)].position) + 0.5));
                    bool hidden = values[index(x, y)] == 1.0f;
                    for (int k = 0; k < 9; ++k) {
                        const glm::ivec2 near = was + glm::ivec2(k % 3 - 1, k / 3 - 1);
                        hidden = hidden && glm::all(glm::greaterThanEqual(near, glm::ivec2(0))) &&
                                 glm::all(glm::lessThan(near, kSize)) &&
                                 last[index(near.x, near.y)].position.z > -0.9;
                    }
                    disoccluded += hidden;
                    if (hidden) {
                        ASSERT_EQ(outcome.frames(index(x, y)), 1.0f) << x << " " << y;
                    }
                }
            }
            last = points;
            last_view = view;
        }
        EXPECT_GT(disoccluded, 20u) << "or nothing came out from behind the board";
    }
}

TEST_F(TemporalTest, ACutAndAnotherSizeBeginAnew) {
    const Scene scene = floor_and_wall();
    const GpuScene gpu(scene);
    const auto ones = [] { return each_pixel([](int, int) { return 1.0f; }); };
    const View front = view_of(scene.cameras.front());
    for (int i = 0; i < 5; ++i)
        render(gpu, front, ones);
    // From below the floor nothing is what it was: its other side faces the camera.
    const View below = view_of(look_at("below", {0.5f, -2, 1}, {0, 0, 0}, 1.0f));
    std::vector<Seen> points;
    const Outcome cut = render(gpu, below, [&] {
        points = seen(below);
        return ones();
    });
    for (size_t pixel = 0; pixel < points.size(); ++pixel)
        if (points[pixel].depth > 0) {
            ASSERT_EQ(cut.frames(pixel), 1.0f);
        }
    before_.forget();
    const Outcome forgotten = render(gpu, below, ones);
    EXPECT_EQ(forgotten.frames(0), 1.0f);

    View smaller = below;
    smaller.size -= 8;
    const FrameContext context = frame(gpu, settings_);
    gbuffer_.draw(context, smaller);
    const Texture value("test values", GL_TEXTURE_2D, GL_R32F, glm::ivec3(smaller.size, 1));
    const float one = 1.0f;
    glClearTexImage(value.id(), 0, GL_RED, GL_FLOAT, &one);
    temporal_.run(context, smaller, gbuffer_, before_, value);
    const std::vector<float> history = temporal_.history().download_float(4);
    ASSERT_EQ(history.size(), 4 * static_cast<size_t>(smaller.size.x * smaller.size.y));
    for (size_t i = 3; i < history.size(); i += 4)
        ASSERT_EQ(history[i], 1.0f);
}

TEST_F(TemporalTest, TheClampBoundsTheLagAndCostsNothingAtRest) {
    const Scene scene = scene_of_triangles(rectangle({0, 0, 0}, {0, 0, 1}, 9.0f));
    const GpuScene gpu(scene);
    const View view = view_of(look_at("front", {0, 0, 3}, {0, 0, 0}, 1.0f));
    /// Frames after a change of the mean until the error is a quarter of it; error at rest.
    struct Course {
        int lag = 0;
        double rest = 0;
    };
    const auto course = [&](double clamp, float from, float to) {
        settings_.set(kTemporalClamp, clamp);
        temporal_.reset();
        std::mt19937 random(11);
        Course found{200, 0};
        for (int i = 0; i < 100; ++i) {
            const float probability = i < 60 ? from : to;
            std::bernoulli_distribution ray(static_cast<double>(probability));
            const Outcome outcome = render(gpu, view, [&] {
                return each_pixel([&](int, int) { return ray(random) ? 1.0f : 0.0f; });
            });
            double bias = 0, squares = 0;
            for (const float value : outcome.result) {
                bias += double{value} - double{probability};
                squares += std::pow(double{value} - double{probability}, 2);
            }
            const auto pixels = static_cast<double>(outcome.result.size());
            if (i == 59)
                found.rest = std::sqrt(squares / pixels);
            if (i >= 60 && found.lag == 200 &&
                std::abs(bias / pixels) < 0.25 * std::abs(double{from} - double{to}))
                found.lag = i - 59;
        }
        return found;
    };
    constexpr double kNone = std::numeric_limits<double>::infinity();
    for (const auto& [from, to] :
         {std::pair(0.9f, 0.5f), std::pair(0.5f, 0.9f), std::pair(1.0f, 0.3f)}) {
        SCOPED_TRACE(testing::Message() << from << " to " << to);
        const Course free = course(kNone, from, to), held = course(2.0, from, to);
        // By (1 - 1/32)^n alone a quarter takes 44 frames.
        EXPECT_GT(free.lag, 40);
        EXPECT_LE(held.lag, 14);
        EXPECT_LE(held.rest, 1.05 * free.rest + 1e-6);
    }
}

} // namespace
} // namespace romascope
