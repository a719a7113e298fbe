// SPDX-License-Identifier: MIT
// What every tracer must keep, whatever its structure.
#include "renderer/gl/capabilities.h"
#include "renderer/reference/ao_tracer.h"
#include "renderer/tracers/samples/samples_tracer.h"
#include "tests/gl/tracer_rays.h"

#include <cmath>

namespace romascope {
namespace {

class TracersTest : public GlTest, public testing::WithParamInterface<size_t> {
protected:
    /// A closed room of 4 m with a block in it: every ray meets something.
    static Scene room() {
        std::vector<glm::vec3> corners;
        add_box(corners, {0, 0, 0}, 2.0f);
        add_box(corners, {0.6f, -1.2f, 0.4f}, 0.7f);
        return scene_of_triangles(corners);
    }

    std::vector<glm::vec2> trace(const Scene& scene, const std::vector<TestRay>& rays) {
        const GpuScene gpu_scene(scene);
        const std::unique_ptr<Tracer> tracer = tracers()[GetParam()].make();
        tracer->build(frame(gpu_scene, settings_, 4, 2));
        return trace_rays(shaders_, *tracer, settings_, rays);
    }

    /// From places on the floor beside the block, upwards.
    static std::vector<TestRay> rays_from_the_floor(float t_max) {
        std::mt19937 random(8);
        std::uniform_real_distribution<float> place(-1.8f, 1.8f);
        std::vector<TestRay> rays;
        while (rays.size() < 4000) {
            const glm::vec3 point(place(random), -2.0f, place(random));
            glm::vec3 direction = random_direction(random);
            direction.y = std::abs(direction.y);
            if (direction.y > 0.3f && (point.x < -0.5f || point.z < -0.7f))
                rays.push_back({glm::vec4(point, 0), {0, 1, 0, 0}, glm::vec4(direction, t_max)});
        }
        return rays;
    }

    Settings settings_{all_knobs()};
};

TEST_P(TracersTest, AnyHitAndClosestHitAgree) {
    for (const float t_max : {0.0f, 0.5f, 1.5f, 3.0f, std::numeric_limits<float>::infinity()}) {
        const std::vector<glm::vec2> results = trace(room(), rays_from_the_floor(t_max));
        for (const glm::vec2 result : results) {
            ASSERT_EQ(result.x != 0.0f, result.y >= 0.0f) << "reach " << t_max;
            ASSERT_LE(result.y, t_max);
        }
    }
}

TEST_P(TracersTest, HitsAreWhereTheTrianglesAre) {
    const Scene scene = room();
    settings_.set(kSamplesCount, 256); // few miss most sheets, which is no fault
    const std::vector<TestRay> rays = rays_from_the_floor(std::numeric_limits<float>::infinity());
    const std::vector<glm::vec2> results = trace(scene, rays);
    const AoTracer truth(scene);
    double found = 0, close = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        const glm::vec3 origin = glm::vec3(rays[i].point) + glm::vec3(0, 1e-4f, 0);
        const auto hit = truth.closest(origin, glm::vec3(rays[i].direction));
        ASSERT_TRUE(hit.has_value()) << "the room is closed";
        found += results[i].y >= 0;
        close += results[i].y >= 0 && std::abs(results[i].y - hit->distance) < 0.6f;
    }
    // A wall one sheet thick is missed by up to a tenth of the rays; snapping turns a ray by up to
    // a stratum, which moves the hits of a good part of them by more than this.
    EXPECT_GT(found / static_cast<double>(rays.size()), 0.9);
    EXPECT_GT(close / static_cast<double>(rays.size()), 0.5);
}

TEST_P(TracersTest, WhatItTakesIsKnownBefore) {
    for (const int resolution : {32, 61, 130}) {
        settings_.set(kOccupancyResolution, resolution);
        const GpuScene gpu_scene(room()); // as long as it is wide and high: the largest map
        const std::unique_ptr<Tracer> tracer = tracers()[GetParam()].make();
        const size_t needed = tracer->bytes_needed(settings_);
        tracer->build(frame(gpu_scene, settings_, 4, 2));
        size_t taken = 0;
        for (const StructureBytes& structure : tracer->bytes())
            taken += structure.bytes;
        EXPECT_LE(taken, needed) << resolution;
        // Software alone packs the base map for the shear.
        EXPECT_GT(taken, needed / 10 * (query_driver().software ? 9 : 8)) << resolution;
    }
}

INSTANTIATE_TEST_SUITE_P(All, TracersTest, testing::Range(size_t{0}, tracers().size()),
                         [](const testing::TestParamInfo<size_t>& chosen) {
                             return std::string(tracers()[chosen.param].name);
                         });

} // namespace
} // namespace romascope
