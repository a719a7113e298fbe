// SPDX-License-Identifier: MIT
#include "tests/gl/tracer_rays.h"

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
    shaders.add("test/tracer.comp.glsl", kRayShader);
    const Program program(shaders, {"rays",
                                    {{GL_COMPUTE_SHADER, "test/tracer.comp.glsl"}},
                                    tracer.shader_defines(settings),
                                    {{"tracer.glsl", tracer.shader_file()}}});
    const Buffer in = Buffer::from("rays", std::span(rays));
    const Buffer out("results", rays.size() * sizeof(glm::vec2));
    program.use();
    program.set("count", static_cast<int>(rays.size()));
    in.bind(GL_SHADER_STORAGE_BUFFER, 0);
    out.bind(GL_SHADER_STORAGE_BUFFER, 1);
    tracer.bind(program);
    program.dispatch_covering({static_cast<int>(rays.size()), 1, 1});
    return out.download<glm::vec2>();
}

} // namespace romascope
