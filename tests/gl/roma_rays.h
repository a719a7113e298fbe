// SPDX-License-Identifier: MIT
// Rays through aligned maps, for tests of any alignment: drawn at random, traced by the tracer's
// own GLSL.
#pragma once

#include "renderer/tracers/roma/walk_cpu.h"
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

/// What aligned maps on the CPU say, to the bit.
struct RomaTwin {
    /// Distance of the closest hit along a map's direction or against it; -1 for a miss.
    std::function<float(const RomaTestRay& ray, int map, bool forward)> distance;
    std::function<bool(int map, glm::vec3 direction)> is_forward;
};

/// A random base map, aligned by any alignment, and rays through it.
class AlignedMapsTest : public GlTest {
protected:
    /// Draws a base map, and has `tracer_` align it by the settings.
    void align_random_grid(glm::ivec3 size, double density, unsigned seed);

    /// Some start within the bounds, some far outside; reaches from nothing to infinity.
    std::vector<RomaTestRay> random_rays(int count);

    std::vector<RomaTestResult> trace(const std::vector<RomaTestRay>& rays);

    /// Results are to the bit those of the twin, and so are those of the snapped direction and of
    /// the candidate of the walk. Gives how many rays hit along the candidate in `choice`.
    size_t expect_twins(const std::vector<RomaTestRay>& rays,
                        const std::vector<RomaTestResult>& results, const RomaTwin& twin) const;

    /// With roma.snap off results are to the bit what a twin says, and so is what was counted, for
    /// few and for many columns. `prepare` aligns maps anew by the settings.
    void expect_unsnapped_twins(
        const std::function<void()>& prepare,
        const std::function<WalkResult(const RomaTestRay& ray, int iterations, int escape)>& walk);

    std::mt19937 random_;
    Settings settings_{all_knobs()};
    BitGrid base_;
    OccupancyGrid grid_;
    Bounds bounds_;
    RomaTracer tracer_;
};

} // namespace romascope
