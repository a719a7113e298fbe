// SPDX-License-Identifier: MIT
#pragma once

#include "app/split/split_scene.h"
#include "renderer/tracers/candidate_set.h"

namespace romascope {

/// Where a ray should go and where it goes instead.
struct SplitDirection {
    glm::vec3 drawn{};
    glm::vec3 traced{}; ///< the same, where rays keep their direction
    int place = -1;     ///< of the candidate, where the method is told which one to trace
};

/// A direction for each point, by its camera, pixel, seed and frame.
///
/// Without `choose`, drawn directions are cosine-distributed about the normal, and traced along the
/// candidate of their stratum, if there are candidates: as published. With it the candidate is
/// chosen first, with probability proportional to |normal . c|, and the drawn direction is one that
/// it stands for: cosine-distributed within its stratum, turned to the side of the normal.
std::vector<SplitDirection> draw_directions(const std::vector<SplitPoint>& points,
                                            const CandidateSet& candidates, bool choose,
                                            uint32_t seed, uint32_t frame);

} // namespace romascope
