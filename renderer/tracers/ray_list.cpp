// SPDX-License-Identifier: MIT
#include "renderer/tracers/ray_list.h"

#include <algorithm>

namespace romascope {
namespace {

static_assert(sizeof(ListedRay) == 3 * 16, "std430 layout of ListedRay");

/// Rays at a time: what every driver takes in one buffer and one dispatch.
constexpr size_t kMostAtOnce = 1 << 20;

} // namespace

ShaderVariant RayList::variant(const Settings& settings, const Tracer& tracer,
                               RayQuestion question) {
    std::vector<ShaderDefine> defines = tracer.shader_defines(settings);
    defines.push_back({"RAY_LIST_CANDIDATES", tracer.sample_candidates(settings) ? "1" : "0"});
    defines.push_back({"RAY_LIST_DISTANCES", question == RayQuestion::distance ? "1" : "0"});
    return {"ray list",
            {{GL_COMPUTE_SHADER, "tracers/ray_list.comp.glsl"}},
            defines,
            {{"tracer.glsl", tracer.shader_file()}}};
}

std::vector<float> RayList::trace(const ShaderLibrary& shaders, const Settings& settings,
                                  const Tracer& tracer, RayQuestion question,
                                  std::span<const ListedRay> rays) {
    const ShaderVariant wanted = variant(settings, tracer, question);
    auto found = std::ranges::find(programs_, wanted, &std::pair<ShaderVariant, Program>::first);
    if (found == programs_.end())
        found = programs_.insert(found, {wanted, Program(shaders, wanted)});
    const Program& program = found->second;
    program.use();
    tracer.bind(program);
    std::vector<float> all;
    all.reserve(rays.size());
    while (!rays.empty()) {
        const std::span<const ListedRay> some = rays.first(std::min(rays.size(), kMostAtOnce));
        rays = rays.subspan(some.size());
        const Buffer in = Buffer::from("rays", some);
        const Buffer out("answers", some.size() * sizeof(float));
        in.bind(GL_SHADER_STORAGE_BUFFER, 0);
        out.bind(GL_SHADER_STORAGE_BUFFER, 1);
        program.set("ray_count", static_cast<int>(some.size()));
        program.dispatch_covering({static_cast<int>(some.size()), 1, 1});
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        const std::vector<float> answers = out.download<float>();
        all.insert(all.end(), answers.begin(), answers.end());
    }
    return all;
}

} // namespace romascope
