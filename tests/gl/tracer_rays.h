// SPDX-License-Identifier: MIT
// Rays for tests of any tracer, traced by its own GLSL.
#pragma once

#include "tests/gl/gl_test.h"

namespace romascope {

struct TestRay {
    glm::vec4 point, normal, direction; ///< direction.w: t_max
};

/// For each ray any-hit (0 or 1) and the closest distance, or -1. `tracer` has been built.
std::vector<glm::vec2> trace_rays(ShaderLibrary& shaders, const Tracer& tracer,
                                  const Settings& settings, const std::vector<TestRay>& rays);

} // namespace romascope
