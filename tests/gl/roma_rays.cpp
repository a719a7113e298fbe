// SPDX-License-Identifier: MIT
#include "tests/gl/roma_rays.h"

#include "shaders/tracers/roma/concentric.h"
#include "tests/gl/run_on_rays.h"
#include "tests/support/random_grid.h"

namespace romascope {
namespace {

/// Traces given rays with the tracer's own GLSL. In: 4 vec4 per ray (point, normal, direction with
/// t_max, candidate and sign). Out: any-hit, closest distance, both of the snapped direction; and
/// for the candidate in a place of the walk its map, the cosine to the normal, any-hit, distance.
constexpr const char* kRayShader = R"(
#include "tracer.glsl"
layout(local_size_x = 64) in;
struct Ray { vec4 point; vec4 normal; vec4 direction; ivec4 choice; };
layout(std430, binding = 0) readonly buffer Rays { Ray rays[]; };
struct Result { vec4 given; vec4 chosen; };
layout(std430, binding = 1) writeonly buffer Results { Result results[]; };
uniform int count;
void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count)
        return;
    Ray ray = rays[i];
    vec3 point = ray.point.xyz, normal = ray.normal.xyz;
    float t_max = ray.direction.w;
    int map = ray.choice.x;
    bool forward = ray.choice.y != 0;
    results[i].given = vec4(roma_any_hit(map, forward, point, normal, t_max) ? 1.0 : 0.0,
                      roma_closest_hit(map, forward, point, normal, t_max),
                      tracer_any_hit(point, normal, ray.direction.xyz, t_max) ? 1.0 : 0.0,
                      tracer_closest_hit(point, normal, ray.direction.xyz, t_max));
    int place = i % TRACER_CANDIDATE_COUNT;
    results[i].chosen = vec4(float(int(roma_candidates[place].w)), dot(tracer_candidate(place), normal),
                     tracer_candidate_any_hit(place, point, normal, t_max) ? 1.0 : 0.0,
                     tracer_candidate_closest_hit(place, point, normal, t_max));
}
)";

} // namespace

void AlignedMapsTest::align_random_grid(glm::ivec3 size, double density, unsigned seed) {
    random_.seed(seed);
    base_ = random_grid(size, density, random_);
    grid_.size = size;
    grid_.cell_size = 0.173f;
    grid_.origin = {-3.7f, 1.1f, 20.0f};
    bounds_ = {};
    bounds_.add(grid_.origin);
    bounds_.add(grid_.origin + grid_.cell_size * glm::vec3(size));
    const Scene any = scene_of_triangles(rectangle({0, 0, 0}, {0, 1, 0}, 1.0f));
    const GpuScene gpu_scene(any);
    tracer_.align(frame(gpu_scene, settings_, seed, seed * 7),
                  upload_base(base_, RomaTracer::store_for(settings_)), grid_, bounds_);
}

std::vector<RomaTestRay> AlignedMapsTest::random_rays(int count) {
    std::uniform_real_distribution<float> unit(-0.3f, 1.3f);
    std::uniform_real_distribution<float> reach(0.0f, 1.0f);
    std::uniform_int_distribution<int> map(0, static_cast<int>(tracer_.candidates().size()) - 1);
    std::vector<RomaTestRay> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 place(unit(random_), unit(random_), unit(random_));
        const float diagonal = glm::length(bounds_.extent());
        const float t_max = i % 4 == 0    ? std::numeric_limits<float>::infinity()
                            : i % 17 == 0 ? 0.0f
                                          : diagonal * reach(random_) * reach(random_);
        rays.push_back({glm::vec4(bounds_.min + place * bounds_.extent(), 0.0f),
                        glm::vec4(random_direction(random_), 0.0f),
                        glm::vec4(random_direction(random_), t_max),
                        {map(random_), i % 2, 0, 0}});
    }
    return rays;
}

std::vector<RomaTestResult> AlignedMapsTest::trace(const std::vector<RomaTestRay>& rays) {
    return run_on_rays<RomaTestResult>(shaders_, tracer_, settings_, kRayShader, rays);
}

size_t AlignedMapsTest::expect_twins(const std::vector<RomaTestRay>& rays,
                                     const std::vector<RomaTestResult>& results,
                                     const RomaTwin& twin) const {
    size_t hits = 0;
    EXPECT_EQ(results.size(), rays.size());
    for (size_t i = 0; i < results.size(); ++i) {
        const auto& [given, chosen] = results[i];
        const float expected = twin.distance(rays[i], rays[i].choice.x, rays[i].choice.y != 0);
        EXPECT_EQ(given.y, expected) << "ray " << i;
        EXPECT_EQ(given.x != 0.0f, expected >= 0.0f) << "ray " << i;
        const glm::vec3 direction(rays[i].direction);
        const int stratum =
            gpu::stratum_of_direction(direction, settings_.get(kRomaAngularResolution));
        const bool along = twin.is_forward(stratum, direction);
        EXPECT_EQ(given.w, twin.distance(rays[i], stratum, along)) << "ray " << i;
        EXPECT_EQ(given.z != 0.0f, given.w >= 0.0f) << "ray " << i;
        // The candidate of the walk, turned to the side of the normal.
        const int walked = static_cast<int>(chosen.x);
        EXPECT_EQ(chosen.w, twin.distance(rays[i], walked, chosen.y >= 0.0f)) << "ray " << i;
        EXPECT_EQ(chosen.z != 0.0f, chosen.w >= 0.0f) << "ray " << i;
        if (testing::Test::HasFailure())
            break; // one ray says enough
        hits += expected >= 0.0f;
    }
    return hits;
}

void AlignedMapsTest::expect_unsnapped_twins(
    const std::function<void()>& prepare,
    const std::function<WalkResult(const RomaTestRay& ray, int iterations, int escape)>& walk) {
    settings_.set(kRomaSnap, false);
    for (const int iterations : {1, 5, 64}) {
        const int escape = iterations % 3;
        settings_.set(kRomaIterations, iterations);
        settings_.set(kRomaEscape, escape);
        prepare();
        const std::vector<RomaTestRay> rays = random_rays(4000);
        const std::vector<RomaTestResult> results = trace(rays);
        size_t hits = 0, unfinished = 0;
        for (size_t i = 0; i < rays.size(); ++i) {
            const WalkResult expected = walk(rays[i], iterations, escape);
            ASSERT_EQ(results[i].given.w, expected.distance) << "ray " << i;
            ASSERT_EQ(results[i].given.z != 0.0f, expected.distance >= 0.0f) << "ray " << i;
            hits += expected.distance >= 0.0f;
            unfinished += expected.unfinished;
        }
        EXPECT_GT(hits, rays.size() / 100);
        EXPECT_LT(hits, rays.size());
        // Each ray was traced for any hit and for the closest.
        const std::vector<NamedCount> counts = tracer_.counts();
        ASSERT_EQ(counts.size(), 2u);
        EXPECT_EQ(counts[0].count, 2 * rays.size());
        EXPECT_EQ(counts[1].count, 2 * unfinished);
    }
}

} // namespace romascope
