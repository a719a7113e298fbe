// SPDX-License-Identifier: MIT
// The a-trous filter: neighbours on one surface are averaged, and only they.
#include "shaders/reuse/edges.h"
#include "tests/gl/reuse_test.h"

#include <cmath>
#include <set>

namespace romascope {
namespace {

class AtrousTest : public ReuseTest {
protected:
    std::vector<float> filter(const GpuScene& scene, const View& view,
                              const std::function<std::vector<float>()>& value) {
        const FrameContext context = frame(scene, settings_);
        gbuffer_.draw(context, view);
        const Texture values = upload(value());
        return filter_.run(context, view, gbuffer_, values).download_float(1);
    }

    static std::vector<float> noise(std::mt19937& random) {
        std::uniform_real_distribution<float> unit;
        return each_pixel([&](int, int) { return unit(random); });
    }

    AtrousFilter filter_;
};

constexpr double kRounded = 1.0 / 65535; // R16, up or down, once more by who reads it

TEST_F(AtrousTest, WhatIsConstantStaysSo) {
    std::mt19937 random(5);
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 30; ++i)
        for (const glm::vec3 corner :
             rectangle(random_direction(random), random_direction(random), 0.4f))
            corners.push_back(corner);
    const Scene scene = scene_of_triangles(corners);
    const GpuScene gpu(scene);
    for (int iterations = 1; iterations <= 5; ++iterations) {
        settings_.set(kAtrousIterations, iterations);
        for (const int code : {0, 1, 20000, 65535}) {
            const float constant = static_cast<float>(code) / 65535.0f;
            for (const float value : filter(gpu, view_of(scene.cameras.front()), [&] {
                     return each_pixel([&](int, int) { return constant; });
                 }))
                ASSERT_EQ(value, constant);
        }
    }
}

TEST_F(AtrousTest, NoiseOnAPlaneFallsByTheKernel) {
    // However steep the plane is seen: its pixels lie on it.
    const Scene scene = scene_of_triangles(rectangle({0, 0, 0}, {0, 1, 0}, 50.0f));
    const GpuScene gpu(scene);
    settings_.set(kAtrousIterations, 1);
    for (const float height : {2.0f, 0.9f}) {
        const View view = view_of(look_at("camera", {0, height, 3}, {0.3f, 0, 0}, 0.5f));
        double squares = 0, count = 0;
        for (uint32_t seed = 0; seed < 8; ++seed) {
            std::mt19937 random(seed);
            const std::vector<float> out = filter(gpu, view, [&] { return noise(random); });
            for (int y = 2; y < kSize.y - 2; ++y)
                for (int x = 2; x < kSize.x - 2; ++x, ++count)
                    squares += std::pow(double{out[index(x, y)]} - 0.5, 2);
        }
        // (1 + 16 + 36 + 16 + 1) / 16^2 along each axis, of a variance of 1/12.
        const double expected = std::pow(70.0 / 256.0, 2) / 12.0;
        EXPECT_NEAR(squares / count, expected, 0.06 * expected) << "from " << height << " m";
    }
}

TEST_F(AtrousTest, NothingCrossesAStepNorAnEdge) {
    // Two planes that meet the middle of the picture: one behind the other, or at an angle to it.
    const auto half = [](float side, glm::vec3 normal, float depth) {
        const glm::vec3 across = glm::normalize(glm::cross(glm::vec3(0, 1, 0), normal));
        return rectangle(glm::vec3(0, 0, depth) + side * 20.0f * across, normal, 20.0f);
    };
    struct Case {
        const char* what;
        std::vector<glm::vec3> left, right;
    };
    const Case cases[] = {
        {"a step of a metre", half(-1, {0, 0, 1}, 0), half(1, {0, 0, 1}, -1)},
        {"a step of three pixels' width", half(-1, {0, 0, 1}, 0), half(1, {0, 0, 1}, -0.25f)},
        {"a right angle", half(-1, glm::normalize(glm::vec3(1, 0, 1)), 0),
         half(1, glm::normalize(glm::vec3(-1, 0, 1)), 0)},
        {"an angle of 40 degrees", half(-1, {0, 0, 1}, 0),
         half(1, {-std::sin(0.7f), 0, std::cos(0.7f)}, 0)}};
    for (const Case& c : cases) {
        SCOPED_TRACE(c.what);
        std::vector<glm::vec3> corners = c.left;
        corners.insert(corners.end(), c.right.begin(), c.right.end());
        Scene scene = scene_of_triangles(corners);
        for (size_t i = 6; i < 12; ++i)
            scene.vertex_material[i] = 1; // its colour tells it
        scene.materials.push_back(scene.materials.front());
        scene.materials[1].base_color = glm::vec3(0.0f);
        const GpuScene gpu(scene);
        const View view = view_of(look_at("front", {0, 0, 3}, {0, 0, 0}, 1.0f));
        std::vector<float> values;
        for (int iterations = 1; iterations <= 5; ++iterations) {
            settings_.set(kAtrousIterations, iterations);
            const std::vector<float> out = filter(gpu, view, [&] {
                const std::vector<float> colors = gbuffer_.base_color().download_float(4);
                values.clear();
                for (size_t i = 0; i < colors.size(); i += 4)
                    values.push_back(colors[i] > 0.5f ? 0.75f : 0.25f);
                return values;
            });
            for (size_t i = 0; i < out.size(); ++i)
                ASSERT_NEAR(out[i], values[i], kRounded) << "pixel " << i << ", " << iterations;
            EXPECT_EQ(std::set<float>(values.begin(), values.end()).size(), 2u);
        }
    }
}

TEST_F(AtrousTest, EachIterationIsWhatItsTwinOnTheCpuSays) {
    // Boards that lean and lie a little off each other, so that neighbours count by parts.
    std::mt19937 random(9);
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 12; ++i) {
        const glm::vec3 centre = 0.8f * random_direction(random) * glm::vec3(1, 0.6f, 0.05f);
        const glm::vec3 normal = glm::vec3(0, 0.3f, 1) + 0.3f * random_direction(random);
        for (const glm::vec3 corner : rectangle(centre, glm::normalize(normal), 0.6f))
            corners.push_back(corner);
    }
    const Scene scene = scene_of_triangles(corners);
    const GpuScene gpu(scene);
    const View view = view_of(scene.cameras.front());
    settings_.set(kAtrousPlaneDistance, 2.5);
    settings_.set(kAtrousNormalAngle, 60.0);
    const std::vector<float> values = noise(random);
    std::vector<double> expected(values.begin(), values.end());
    constexpr double kSpline[] = {6.0 / 16, 4.0 / 16, 1.0 / 16};
    const double plane = pixels_at_unit_depth(view, 2.5);
    const auto cosine_limit = static_cast<float>(std::cos(glm::radians(60.0)));
    for (int iterations = 1; iterations <= 4; ++iterations) {
        settings_.set(kAtrousIterations, iterations);
        const std::vector<float> out = filter(gpu, view, [&] { return values; });
        const std::vector<Seen> points = seen(view);
        const std::vector<glm::vec3> normals = normals_seen();
        std::vector<double> next = expected;
        const int spacing = 1 << (iterations - 1);
        size_t partly = 0;
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 0; x < kSize.x; ++x) {
                const size_t at = index(x, y);
                double sum = 0, total = 0;
                for (int j = -2; j <= 2; ++j) {
                    for (int i = -2; i <= 2; ++i) {
                        const glm::ivec2 o(x + i * spacing, y + j * spacing);
                        if (glm::any(glm::lessThan(o, glm::ivec2(0))) ||
                            glm::any(glm::greaterThanEqual(o, kSize)))
                            continue;
                        const size_t other = index(o.x, o.y);
                        double weight = i == 0 && j == 0 ? 1.0 : 0.0;
                        if (weight == 0.0 && points[at].depth > 0 && points[other].depth > 0) {
                            const float distance = gpu::plane_distance(
                                glm::vec3(points[at].position), normals[at],
                                glm::vec3(points[other].position), normals[other]);
                            weight = double{gpu::edge_weight(
                                distance, static_cast<float>(plane * points[at].depth),
                                glm::dot(normals[at], normals[other]), cosine_limit)};
                            partly += weight > 0.01 && weight < 0.99;
                        }
                        weight *= kSpline[std::abs(i)] * kSpline[std::abs(j)];
                        sum += weight * expected[other];
                        total += weight;
                    }
                }
                next[at] = sum / total;
            }
        }
        EXPECT_GT(partly, 50u) << "or the weights were all alike";
        expected = next;
        for (size_t i = 0; i < out.size();
             ++i) // 4e-5 rad of the stored normals, and 16 bits a time
            ASSERT_NEAR(out[i], expected[i], 0.002) << "pixel " << i << ", " << iterations;
    }
}

} // namespace
} // namespace romascope
