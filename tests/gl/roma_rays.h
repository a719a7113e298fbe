// SPDX-License-Identifier: MIT
// Rays through aligned maps, for tests of any alignment: drawn at random, traced by the tracer's
// own GLSL.
#pragma once

#include "tests/gl/gl_test.h"

#include <functional>

namespace romascope {

struct RomaTestRay {
    glm::vec4 point, normal, direction; ///< direction.w: t_max
    glm::ivec4 choice;                  ///< candidate, 1 along it or 0 against it
};

/// Of the candidate in `choice`: any-hit (0 or 1), closest distance or -1; both of the direction,
/// snapped. Of the candidate in a place of the walk: its map, the cosine to the normal, both again.
struct RomaTestResult {
    glm::vec4 given, chosen;
};

/// Some start within the bounds, some far outside; reaches from nothing to infinity.
std::vector<RomaTestRay> random_roma_rays(std::mt19937& random, const Bounds& bounds, int maps,
                                          int count);

std::vector<RomaTestResult> trace_roma_rays(ShaderLibrary& shaders, const RomaTracer& tracer,
                                            const Settings& settings,
                                            const std::vector<RomaTestRay>& rays);

/// What the ray's own direction should give, without snapping.
struct RomaTestWalk {
    float distance;
    bool unfinished;
};

/// Results of tracing with roma.snap off, and what was counted, are to the bit what a twin says.
/// `walk`: the twin, for a ray by its place.
void expect_walks(const std::vector<RomaTestResult>& results, const RomaTracer& tracer,
                  const std::function<RomaTestWalk(size_t)>& walk);

} // namespace romascope
