// SPDX-License-Identifier: MIT
#include "tests/gl/tracer_rays.h"

#include "tests/gl/run_on_rays.h"

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

} // namespace

std::vector<glm::vec2> trace_rays(ShaderLibrary& shaders, const Tracer& tracer,
                                  const Settings& settings, const std::vector<TestRay>& rays) {
    return run_on_rays<glm::vec2>(shaders, tracer, settings, kRayShader, rays);
}

} // namespace romascope
