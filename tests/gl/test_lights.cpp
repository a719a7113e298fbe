// SPDX-License-Identifier: MIT
// The lit view by a scene's own lights, against the formulas of KHR_lights_punctual in double
// precision. On an open plane ambient occlusion is exactly 1, and without a sky only lights count.
#include "renderer/passes/scene_lights.h"
#include "tests/gl/gl_test.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <functional>

namespace romascope {
namespace {

class LightsTest : public GlTest {
protected:
    LightsTest() {
        settings_.set(kWidth, 48);
        settings_.set(kHeight, 36);
        settings_.set(kOccupancyResolution, 32);
        settings_.set(kRomaAngularResolution, 2);
        leave_all_own_cells(settings_);
        settings_.set(kView, PictureKind::lit);
        settings_.set(kHighlights, Highlights::clip); // the formulas are of radiance
        settings_.set(kSkyStrength, 0.0);
        settings_.set(kSunStrength, 1.0);
        scene_ = scene_of_triangles(rectangle({0, 0, 0}, {0, 1, 0}, 3.0f));
    }

    Image render() {
        Pipeline pipeline(scene_, ShaderLibrary());
        pipeline.render(settings_, camera_);
        return pipeline.picture();
    }

    /// What lies at a pixel of the plane y = 0.
    glm::dvec3 point_at(int x, int y) const {
        const glm::vec3 way = camera_.direction_through(glm::vec2(x, y) + 0.5f, {48, 36});
        return glm::dvec3(camera_.eye) - glm::dvec3(way) * (double(camera_.eye.y) / double(way.y));
    }

    /// Each pixel is `irradiance` at its point, times the scene's exposure; relative to the largest
    /// value. Depth and normal are rounded by 1e-6 and 4e-5 rad; the picture is of floats.
    void expect_picture(const Image& image,
                        const std::function<double(glm::dvec3)>& irradiance) const {
        const double exposure = light_exposure(scene_);
        double largest = 0.0;
        for (int y = 0; y < 36; ++y)
            for (int x = 0; x < 48; ++x)
                largest = std::max(largest, exposure * irradiance(point_at(x, y)));
        ASSERT_GT(largest, 0.0);
        for (int y = 0; y < 36; ++y)
            for (int x = 0; x < 48; ++x)
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(image.at(x, y, c), exposure * irradiance(point_at(x, y)),
                                3e-4 * largest)
                        << x << " " << y;
    }

    Scene scene_;
    Camera camera_ = look_at("above", {0.3f, 3.0f, 0.4f}, {0, 0, 0}, 0.9f);
    Settings settings_{all_knobs()};
};

/// Candela over squared distance, times the cosine on a floor.
double by_point(const Light& light, glm::dvec3 at) {
    const glm::dvec3 way = glm::dvec3(light.position) - at;
    const double distance = glm::length(way);
    const double end = std::pow(distance / double(light.range), 4.0);
    return double(light.color.x) * std::max(0.0, 1.0 - end) / (distance * distance) *
           std::max(0.0, way.y / distance);
}

TEST_F(LightsTest, PointsFallOffWithTheSquareOfTheDistance) {
    for (const float height : {0.2f, 1.0f, 20.0f}) {
        Light light{.position = {0.4f, height, -0.3f}, .color = glm::vec3(700.0f)};
        scene_.lights = {light};
        expect_picture(render(), [&](glm::dvec3 at) { return by_point(light, at); });
    }
}

TEST_F(LightsTest, NothingComesFromBelow) {
    scene_.lights = {{.position = {0, 1, 0}}, {.position = {0, -1, 0}, .color = glm::vec3(100)}};
    expect_picture(render(), [&](glm::dvec3 at) { return by_point(scene_.lights[0], at); });
}

TEST_F(LightsTest, TheRangeEndsThem) {
    const Light light{.position = {0, 0.5f, 0}, .color = glm::vec3(3.0f), .range = 0.9f};
    scene_.lights = {light};
    const Image image = render();
    expect_picture(image, [&](glm::dvec3 at) { return by_point(light, at); });
    EXPECT_EQ(image.at(0, 0, 0), 0.0f); // beyond it
}

TEST_F(LightsTest, SpotsHaveTheirCone) {
    Light light{.kind = LightKind::spot,
                .position = {0, 1.5f, 0},
                .direction = glm::normalize(glm::vec3(0.2f, -1.0f, 0.1f)),
                .color = glm::vec3(40.0f)};
    for (const auto& [inner, outer] : {std::pair(0.2f, 0.5f), {0.0f, 0.4f}, {0.3f, 0.3001f}}) {
        light.inner_cone = inner;
        light.outer_cone = outer;
        scene_.lights = {light};
        const Image image = render();
        const double sharpness =
            1.0 / std::max(0.001, std::cos(double(inner)) - std::cos(double(outer)));
        const auto share = [&](glm::dvec3 at) {
            const glm::dvec3 way = glm::normalize(at - glm::dvec3(light.position));
            const double c = glm::dot(way, glm::dvec3(light.direction));
            return std::clamp((c - std::cos(double(outer))) * sharpness, 0.0, 1.0);
        };
        // A cone as sharp as that may put a pixel on its edge to either side.
        if (sharpness < 100)
            expect_picture(
                image, [&](glm::dvec3 at) { return by_point(light, at) * share(at) * share(at); });
        int lit = 0, dark = 0;
        for (int y = 0; y < 36; ++y)
            for (int x = 0; x < 48; ++x) {
                const glm::dvec3 way = glm::normalize(point_at(x, y) - glm::dvec3(light.position));
                const double angle = std::acos(glm::dot(way, glm::dvec3(light.direction)));
                if (angle > double(outer) + 0.01) {
                    EXPECT_EQ(image.at(x, y, 0), 0.0f);
                    ++dark;
                } else if (angle < double(outer) - 0.01) {
                    EXPECT_GT(image.at(x, y, 0), 0.0f);
                    ++lit;
                }
            }
        EXPECT_GT(lit, 50);
        EXPECT_GT(dark, 50);
    }
}

TEST_F(LightsTest, DirectionalOnesAreTheSameEverywhere) {
    // The exposure makes the picture the same, however strong they are: 1, as the sun.
    for (const float lux : {0.01f, 3.0f, 100000.0f}) {
        scene_.lights = {{.kind = LightKind::directional,
                          .direction = glm::normalize(glm::vec3(1, -2, 0.5f)),
                          .color = glm::vec3(lux)}};
        const double cosine = 2.0 / std::sqrt(5.25);
        EXPECT_NEAR(light_exposure(scene_), 1.0 / (double(lux) * cosine), 1e-5 / double(lux));
        const Image image = render();
        for (const float value : image.data)
            ASSERT_NEAR(value, 1.0f, 3e-4f);
    }
}

TEST_F(LightsTest, ExposureFitsWhereLightFallsNotTheDarkAround) {
    // A lamp a metre above a floor. The integral of E is intensity times the solid angle of the
    // floor, that of E squared pi / 2 times the squared intensity but for what is far away.
    for (const float half : {4.0f, 12.0f}) {
        scene_ = scene_of_triangles(rectangle({0, 0, 0}, {0, 1, 0}, half));
        scene_.lights = {{.position = {0, 1, 0}, .color = glm::vec3(70.0f)}};
        const double solid_angle = 4.0 * std::atan(half * half / std::sqrt(2.0 * half * half + 1));
        const double expected = 2.0 / glm::pi<double>() * solid_angle;
        EXPECT_NEAR(70.0f * light_exposure(scene_), expected, 0.06 * expected); // 2048 points
    }
    scene_.lights[0].position.y = -1.0f;
    scene_.materials[0].double_sided = false;
    EXPECT_EQ(light_exposure(scene_), 1.0f); // reaches nothing
}

TEST_F(LightsTest, TheStrongestAreTaken) {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> place(-1.0f, 1.0f);
    std::vector<Light> strong;
    for (int i = 0; i < 100; ++i) {
        Light light{.position = {place(random), 1.0f, place(random)},
                    .color = glm::vec3(i % 3 == 0 ? 0.5f : 1.0f)};
        scene_.lights.push_back(light);
        if (i % 3 != 0 && strong.size() < size_t{gpu::kMaxLights})
            strong.push_back(light);
    }
    ASSERT_EQ(strong.size(), size_t{gpu::kMaxLights});
    expect_picture(render(), [&](glm::dvec3 at) {
        double sum = 0.0;
        for (const Light& light : strong)
            sum += by_point(light, at);
        return sum;
    });
}

TEST_F(LightsTest, SunOrSceneAsChosen) {
    const Image sun = render();
    scene_.lights = {{.position = {0, 1, 0}}};
    const Image own = render();
    EXPECT_NE(sun.data, own.data);
    settings_.set(kLights, LightSource::sun);
    EXPECT_EQ(render().data, sun.data);
    settings_.set(kLights, LightSource::scene);
    EXPECT_EQ(render().data, own.data);
    scene_.lights.clear();
    for (const float value : render().data)
        ASSERT_EQ(value, 0.0f);
}

TEST_F(LightsTest, MovingOnesAreWhereTheirNodeIs) {
    scene_.lights = {{.position = {0, 1, 0}, .color = glm::vec3(5.0f)}};
    scene_.motion.nodes.resize(1);
    scene_.motion.lights = {{.index = 0, .node = 0}};
    Pipeline pipeline(scene_, ShaderLibrary());
    Light moved = scene_.lights[0];
    for (const glm::vec3 place : {glm::vec3(0.7f, 0.6f, 0.2f), {-0.5f, 1.5f, 0.1f}}) {
        Pose pose;
        pose.node_to_world = {glm::translate(glm::dmat4(1.0), glm::dvec3(place))};
        pipeline.set_pose(pose);
        pipeline.render(settings_, camera_);
        moved.position = place;
        expect_picture(pipeline.picture(), [&](glm::dvec3 at) { return by_point(moved, at); });
    }
}

} // namespace
} // namespace romascope
