// SPDX-License-Identifier: MIT
#include "renderer/passes/empty.h"

namespace romascope {

ShaderVariant EmptyPass::variant() {
    return {"empty", {{GL_COMPUTE_SHADER, "passes/empty.comp.glsl"}}, {}, {}};
}

void EmptyPass::run(const ShaderLibrary& shaders, PassTimer& timer) {
    const Program& program = program_.get(shaders, variant());
    auto pass = timer.compute("empty dispatch");
    program.use();
    pass.repeat([&] {
        program.dispatch_covering({1, 1, 1});
        glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    });
}

} // namespace romascope
