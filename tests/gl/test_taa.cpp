// SPDX-License-Identifier: MIT
// Temporal antialiasing: edges become shares of pixels, and nothing else is added to the picture.
#include "tests/gl/reuse_test.h"

#include <cmath>

namespace romascope {
namespace {

class TaaTest : public ReuseTest {
protected:
    /// One frame; `color` is asked for each pixel once the G-buffer is drawn. Three numbers a
    /// pixel, or one.
    std::vector<float> render(const GpuScene& scene, const View& view, bool single,
                              const std::function<glm::vec3(const Seen&)>& color) {
        const FrameContext context = frame(scene, settings_);
        gbuffer_.draw(context, view, scene.has_previous_positions());
        std::vector<float> texels;
        for (const Seen& point : seen(view)) {
            const glm::vec3 c = color(point);
            if (single)
                texels.push_back(c.x);
            else
                texels.insert(texels.end(), {c.x, c.y, c.z, 1.0f});
        }
        const Texture picture = upload(texels, single ? 1 : 4);
        const Texture& out = taa_.run(context, view, gbuffer_, before_, picture);
        before_.remember(gbuffer_, view);
        return out.download_float(single ? 1 : 3);
    }

    static glm::vec2 shift(int frame) {
        return glm::vec2(std::fmod(0.7548777f * static_cast<float>(frame), 1.0f),
                         std::fmod(0.5698403f * static_cast<float>(frame), 1.0f)) -
               0.5f;
    }

    SurfaceHistory before_;
    Taa taa_;
};

TEST_F(TaaTest, AStillEdgeBecomesItsCoverage) {
    // A board askew before nothing; what covers a pixel by a share shows by that share.
    const Scene scene = scene_of_triangles(rectangle({0, 0, 0}, {0, 0, 1}, 0.8f));
    const GpuScene gpu(scene);
    Camera camera = look_at("front", {0, 0, 3}, {0, 0, 0}, 1.0f);
    camera.up = glm::normalize(glm::vec3(0.3f, 1.0f, 0.0f));
    const auto white = [](const Seen& point) { return glm::vec3(point.depth > 0 ? 0.8f : 0.2f); };
    settings_.set(kTaaLength, 64);
    settings_.set(kTaaClamp, 2.0); // within it is all of an edge's 3 x 3 pixels
    for (const bool single : {true, false}) {
        taa_.reset();
        before_.forget();
        std::vector<float> out;
        std::vector<double> mean(index(0, kSize.y));
        for (int i = 0; i < 48; ++i) {
            const View view = view_of(camera, shift(i));
            out = render(gpu, view, single, white);
            const std::vector<Seen> points = seen(view);
            for (size_t pixel = 0; pixel < points.size(); ++pixel)
                mean[pixel] += (points[pixel].depth > 0 ? 0.8 : 0.2) / 48;
        }
        size_t edges = 0;
        double error = 0;
        for (size_t pixel = 0; pixel < mean.size(); ++pixel) {
            const float value = out[single ? pixel : 3 * pixel];
            if (mean[pixel] > 0.21 && mean[pixel] < 0.79) {
                ++edges;
                error += std::abs(double{value} - mean[pixel]);
            } else {
                ASSERT_NEAR(value, mean[pixel], 1e-5) << "inside and outside nothing changes";
            }
        }
        ASSERT_GT(edges, 60u);
        // What is left is the clamp's, of frames in which a neighbourhood shows less of the edge.
        EXPECT_LT(error / static_cast<double>(edges), 0.06);
    }
}

TEST_F(TaaTest, NoGhostStaysWhereABoardHasBeen) {
    std::vector<glm::vec3> corners = rectangle({0, 0, -1}, {0, 0, 1}, 8.0f);
    for (const glm::vec3 corner : rectangle({0, 0, 0}, {0, 0, 1}, 0.4f))
        corners.push_back(corner);
    const Scene scene = scene_of_triangles(corners);
    const GpuScene gpu(scene);
    const auto color = [](const Seen& point) {
        return point.position.z > -0.5 ? glm::vec3(0.9f, 0.1f, 0.0f) : glm::vec3(0.0f, 0.3f, 0.7f);
    };
    for (int i = 0; i < 6; ++i) {
        const glm::vec3 eye(0.4f * static_cast<float>(i) - 1.0f, 0, 2);
        const View view =
            view_of(look_at("passing", eye, eye - glm::vec3(0, 0, 1), 1.0f), shift(i));
        const std::vector<float> out = render(gpu, view, false, color);
        const std::vector<Seen> points = seen(view);
        size_t mixed = 0;
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 0; x < kSize.x; ++x) {
                const bool board = points[index(x, y)].position.z > -0.5;
                bool edge = false;
                for (int k = 0; k < 9; ++k) {
                    const glm::ivec2 near = glm::clamp(glm::ivec2(x + k % 3 - 1, y + k / 3 - 1),
                                                       glm::ivec2(0), kSize - 1);
                    edge = edge || (points[index(near.x, near.y)].position.z > -0.5) != board;
                }
                mixed += edge;
                for (size_t c = 0; c < 3 && !edge; ++c) {
                    ASSERT_NEAR(out[3 * index(x, y) + c],
                                color(points[index(x, y)])[static_cast<int>(c)], 1e-4)
                        << x << " " << y << " in frame " << i;
                }
            }
        }
        EXPECT_GT(mixed, 0u);
    }
}

TEST_F(TaaTest, WhatTheNeighboursHaveIsABound) {
    // A picture that turns from white to black at once is black at once; and NaN-free at that.
    const Scene scene = scene_of_triangles(rectangle({0, 0, 0}, {0, 0, 1}, 9.0f));
    const GpuScene gpu(scene);
    const View view = view_of(look_at("front", {0, 0, 3}, {0, 0, 0}, 1.0f));
    for (int i = 0; i < 6; ++i)
        render(gpu, view, true, [](const Seen&) { return glm::vec3(1.0f); });
    for (const float value : render(gpu, view, true, [](const Seen&) { return glm::vec3(0.0f); }))
        ASSERT_NEAR(value, 0.0f, 1e-5f);
    // Noise of one frame is averaged as far as its length says.
    settings_.set(kTaaClamp, 100.0);
    settings_.set(kTaaLength, 8);
    taa_.reset();
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit;
    std::vector<double> mean(index(0, kSize.y));
    std::vector<float> out, values;
    for (int i = 1; i <= 12; ++i) {
        values.clear();
        out = render(gpu, view, true, [&](const Seen&) {
            values.push_back(unit(random));
            return glm::vec3(values.back());
        });
        for (size_t pixel = 0; pixel < out.size(); ++pixel)
            mean[pixel] += (double{values[pixel]} - mean[pixel]) / std::min(i, 8);
    }
    for (size_t pixel = 0; pixel < out.size(); ++pixel)
        ASSERT_NEAR(out[pixel], mean[pixel], 1e-5);
}

} // namespace
} // namespace romascope
