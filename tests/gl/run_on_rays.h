// SPDX-License-Identifier: MIT
// Rays from the CPU through the GLSL of a tracer and back.
#pragma once

#include "tests/gl/gl_test.h"

namespace romascope {

/// One result for each ray. `text`: a compute shader that includes "tracer.glsl", in groups of 64;
/// rays in buffer 0, results in buffer 1, their number in `uniform int count`. `tracer` has been
/// built.
template <class Result, class Ray>
std::vector<Result> run_on_rays(ShaderLibrary& shaders, const Tracer& tracer,
                                const Settings& settings, const char* text,
                                const std::vector<Ray>& rays) {
    shaders.add("test/rays.comp.glsl", text);
    const Program program(shaders, {"rays",
                                    {{GL_COMPUTE_SHADER, "test/rays.comp.glsl"}},
                                    tracer.shader_defines(settings),
                                    {{"tracer.glsl", tracer.shader_file()}}});
    const Buffer in = Buffer::from("rays", std::span(rays));
    const Buffer out("results", rays.size() * sizeof(Result));
    program.use();
    program.set("count", static_cast<int>(rays.size()));
    in.bind(GL_SHADER_STORAGE_BUFFER, 0);
    out.bind(GL_SHADER_STORAGE_BUFFER, 1);
    tracer.bind(program);
    program.dispatch_covering({static_cast<int>(rays.size()), 1, 1});
    return out.download<Result>();
}

} // namespace romascope
