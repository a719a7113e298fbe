// SPDX-License-Identifier: MIT
#include "tests/gl/roma_rays.h"

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

std::vector<RomaTestRay> random_roma_rays(std::mt19937& random, const Bounds& bounds, int maps,
                                          int count) {
    std::uniform_real_distribution<float> unit(-0.3f, 1.3f);
    std::uniform_real_distribution<float> reach(0.0f, 1.0f);
    std::uniform_int_distribution<int> map(0, maps - 1);
    std::vector<RomaTestRay> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 place(unit(random), unit(random), unit(random));
        const float diagonal = glm::length(bounds.extent());
        const float t_max = i % 4 == 0    ? std::numeric_limits<float>::infinity()
                            : i % 17 == 0 ? 0.0f
                                          : diagonal * reach(random) * reach(random);
        rays.push_back({glm::vec4(bounds.min + place * bounds.extent(), 0.0f),
                        glm::vec4(random_direction(random), 0.0f),
                        glm::vec4(random_direction(random), t_max),
                        {map(random), i % 2, 0, 0}});
    }
    return rays;
}

std::vector<RomaTestResult> trace_roma_rays(ShaderLibrary& shaders, const RomaTracer& tracer,
                                            const Settings& settings,
                                            const std::vector<RomaTestRay>& rays) {
    shaders.add("test/rays.comp.glsl", kRayShader);
    const Program program(shaders, {"rays",
                                    {{GL_COMPUTE_SHADER, "test/rays.comp.glsl"}},
                                    tracer.shader_defines(settings),
                                    {{"tracer.glsl", tracer.shader_file()}}});
    const Buffer in = Buffer::from("rays", std::span(rays));
    const Buffer out("results", rays.size() * sizeof(RomaTestResult));
    program.use();
    program.set("count", static_cast<int>(rays.size()));
    in.bind(GL_SHADER_STORAGE_BUFFER, 0);
    out.bind(GL_SHADER_STORAGE_BUFFER, 1);
    tracer.bind(program);
    program.dispatch_covering({static_cast<int>(rays.size()), 1, 1});
    return out.download<RomaTestResult>();
}

void expect_walks(const std::vector<RomaTestResult>& results, const RomaTracer& tracer,
                  const std::function<RomaTestWalk(size_t)>& walk) {
    size_t hits = 0, unfinished = 0;
    for (size_t i = 0; i < results.size(); ++i) {
        const RomaTestWalk expected = walk(i);
        ASSERT_EQ(results[i].given.w, expected.distance) << "ray " << i;
        ASSERT_EQ(results[i].given.z != 0.0f, expected.distance >= 0.0f) << "ray " << i;
        hits += expected.distance >= 0.0f;
        unfinished += expected.unfinished;
    }
    EXPECT_GT(hits, results.size() / 100);
    EXPECT_LT(hits, results.size());
    // Each ray was traced for any hit and for the closest.
    const std::vector<NamedCount> counts = tracer.counts();
    ASSERT_EQ(counts.size(), 2u);
    EXPECT_EQ(counts[0].count, 2 * results.size());
    EXPECT_EQ(counts[1].count, 2 * unfinished);
}

} // namespace romascope
