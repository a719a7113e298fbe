// SPDX-License-Identifier: MIT
// What every tracer must keep, whatever its structure.
#include "renderer/reference/ao_tracer.h"
#include "tests/gl/gl_test.h"

#include <cmath>

namespace romascope {
namespace {

constexpr const char* kRayShader = R"(
#include "tracer.glsl"
layout(local_size_x = 64) in;
struct Ray { vec4 point; vec4 normal; vec4 direction; };
layout(std430, binding = 0) readonly buffer Rays { Ray rays[]; };
layout(std430, binding = 1) writeonly buffer Results { vec2 results[]; };
uniform int count;
void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count)
        return;
    Ray ray = rays[i];
    float t_max = ray.direction.w;
    results[i] = vec2(tracer_any_hit(ray.point.xyz, ray.normal.xyz, ray.direction.xyz, t_max) ? 1.0 : 0.0,
                      tracer_closest_hit(ray.point.xyz, ray.normal.xyz, ray.direction.xyz, t_max));
}
)";

struct Ray {
    glm::vec4 point, normal, direction; ///< direction.w: t_max
};

class TracersTest : public GlTest, public testing::WithParamInterface<size_t> {
protected:
    /// A closed room of 4 m with a block in it: every ray meets something.
    static Scene room() {
        std::vector<glm::vec3> corners;
        const auto add_box = [&](glm::vec3 centre, float half) {
            for (int axis = 0; axis < 3; ++axis) {
                for (const float side : {-1.0f, 1.0f}) {
                    glm::vec3 normal(0.0f);
                    normal[axis] = side;
                    for (const glm::vec3 corner : rectangle(centre + half * normal, normal, half))
                        corners.push_back(corner);
                }
            }
        };
        add_box({0, 0, 0}, 2.0f);
        add_box({0.6f, -1.2f, 0.4f}, 0.7f);
        return scene_of_triangles(corners);
    }

    std::vector<glm::vec2> trace(const Scene& scene, const std::vector<Ray>& rays) {
        const GpuScene gpu_scene(scene);
        const std::unique_ptr<Tracer> tracer = tracers()[GetParam()].make();
        tracer->build(frame(gpu_scene, settings_, 4, 2));
        shaders_.add("test/tracer.comp.glsl", kRayShader);
        const Program program(shaders_, {"rays",
                                         {{GL_COMPUTE_SHADER, "test/tracer.comp.glsl"}},
                                         tracer->shader_defines(settings_),
                                         {{"tracer.glsl", tracer->shader_file()}}});
        const Buffer in = Buffer::from("rays", std::span(rays));
        const Buffer out("results", rays.size() * sizeof(glm::vec2));
        program.use();
        program.set("count", static_cast<int>(rays.size()));
        in.bind(GL_SHADER_STORAGE_BUFFER, 0);
        out.bind(GL_SHADER_STORAGE_BUFFER, 1);
        tracer->bind(program);
        program.dispatch_covering({static_cast<int>(rays.size()), 1, 1});
        return out.download<glm::vec2>();
    }

    /// From places on the floor beside the block, upwards.
    static std::vector<Ray> rays_from_the_floor(float t_max) {
        std::mt19937 random(8);
        std::uniform_real_distribution<float> place(-1.8f, 1.8f);
        std::vector<Ray> rays;
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
    const std::vector<Ray> rays = rays_from_the_floor(std::numeric_limits<float>::infinity());
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
        EXPECT_GT(taken, needed / 10 * 9) << resolution;
    }
}

INSTANTIATE_TEST_SUITE_P(All, TracersTest, testing::Range(size_t{0}, tracers().size()),
                         [](const testing::TestParamInfo<size_t>& chosen) {
                             return std::string(tracers()[chosen.param].name);
                         });

} // namespace
} // namespace romascope
