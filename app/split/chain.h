// SPDX-License-Identifier: MIT
#pragma once

#include "app/split/split_scene.h"
#include "app/split/tally.h"
#include "renderer/tracers/dda/dda_tracer.h"
#include "renderer/tracers/ray_list.h"

#include <memory>

namespace romascope {

/// Asks every link of a method's chain about the same rays: the triangles, the cells of the
/// occupancy map one by one, the method itself. All links in cells share one origin, off the
/// surface as the method's own rays are, and pass as many of their surface's cells.
class Chain {
public:
    Chain();

    /// One ray from each point of the scene, of frame `frame` of the random sequences; what the
    /// links say, in the order of SplitScene::points().
    std::vector<ChainAnswers> ask(SplitScene& scene, const Settings& settings, uint32_t frame);

private:
    Tracer& tracer_of(const Settings& settings);
    std::vector<bool> trace(const Settings& settings, const Tracer& tracer,
                            const std::vector<ListedRay>& rays);

    ShaderLibrary shaders_;
    PassTimer untimed_{TimerClock::none};
    std::string tracer_name_;
    std::unique_ptr<Tracer> tracer_;
    DdaTracer cells_;
    RayList rays_;
};

} // namespace romascope
