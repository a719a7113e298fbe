// SPDX-License-Identifier: MIT
#pragma once

#include "app/frame_run.h"

#include <optional>

namespace romascope {

/// The truths of the frames of a run, each made as it is asked for. The last one is kept, so that
/// who asks for it again has it at once.
class Truths {
public:
    /// Keeps references. `scene`: at rest, or in any pose. `samples`: rays per pixel.
    Truths(const Scene& scene, const Settings& settings, const Showing& showing, int samples,
           bool use_cache);
    /// Of the frame that is shown now, until the next call.
    const AoReference& now();
    /// Spent on all that were asked for, in this run or when they were put into the cache.
    double seconds() const { return seconds_; }
    /// Whether all that were asked for were in the cache before.
    bool from_cache() const { return from_cache_; }

private:
    bool is_of_now() const;

    const Scene& scene_;
    const Settings& settings_;
    const Showing& showing_;
    int samples_;
    bool use_cache_;
    std::optional<AoReference> last_;
    Pose pose_; ///< that `last_` is of
    Camera camera_;
    double seconds_ = 0;
    bool from_cache_ = true;
};

} // namespace romascope
