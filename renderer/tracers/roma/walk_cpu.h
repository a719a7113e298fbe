// SPDX-License-Identifier: MIT
// The CPU twin of unsnapped.glsl: a ray that keeps its direction, in one aligned map.
#pragma once

#include "renderer/tracers/roma/roma_cpu.h"
#include "renderer/tracers/roma/shear_cpu.h"

namespace romascope {

struct WalkResult {
    float distance = -1.0f;  ///< metres from the surface; negative for a miss
    bool unfinished = false; ///< the last iteration was traced snapped
};

/// `escape`: occupied cells that are skipped at the start of the ray.
WalkResult walk_on_cpu(const AlignedMap& map, const gpu::RomaWalk& walk, int iterations,
                       int escape);
WalkResult walk_on_cpu(const ShearedMap& map, const gpu::RomaWalk& walk, int iterations,
                       int escape);

} // namespace romascope
