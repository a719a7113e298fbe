// SPDX-License-Identifier: MIT
#pragma once

#include "app/truths.h"
#include "renderer/metrics/flicker.h"

namespace romascope {

/// The flicker of frames, watched as they are rendered: over the second half of them, when what has
/// to come to rest has. Each frame's picture is read back, and its truth made where it is another.
class FlickerWatch {
public:
    /// Keeps a reference. `frames`: of the whole run.
    FlickerWatch(Truths& truths, int frames) : truths_(truths), frames_(frames) {}
    void operator()(const Pipeline& pipeline, int frame) {
        if (frame + 1 >= frames_ / 2)
            flicker_.add(truths_.now().visibility, pipeline.picture());
    }
    double value() const { return flicker_.value(); }

private:
    Truths& truths_;
    int frames_;
    Flicker flicker_;
};

} // namespace romascope
