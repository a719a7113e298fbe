// SPDX-License-Identifier: MIT
#pragma once

#include "app/truths.h"

namespace romascope {

/// For how many frames pictures lag behind after what is shown changed at once: beside them the
/// same frames are rendered by a pipeline that begins there. Both are judged, by mean absolute
/// error, where the truth has changed.
class LagWatch {
public:
    /// A picture lags if its error is more than so many times that of the other pipeline's.
    static constexpr double kTolerated = 1.1;
    /// By how much the truth of a pixel changes at least for it to be looked at.
    static constexpr float kChange = 0.2f;

    /// Keeps references. `first`: the frame that shows something else than those before, and all
    /// from there on do. `scene`: at rest.
    LagWatch(const Scene& scene, const Settings& settings, const Showing& showing, Truths& truths,
             int first, ShaderLibrary shaders);
    void operator()(const Pipeline& pipeline, int frame);
    /// Frames from the first on until none lags any more; all of them if the last one does. Nothing
    /// if the truth changed nowhere by kChange: then there is nothing to lag behind.
    std::optional<int> value() const { return changed_ ? std::optional(lag_) : std::nullopt; }

private:
    bool is_judged(size_t pixel) const;
    double error_of(const Pipeline& pipeline) const;

    const Settings& settings_;
    const Showing& showing_;
    Truths& truths_;
    int first_;
    Pipeline fresh_;
    Image before_, truth_; ///< before the change, after it
    bool changed_ = false;
    int lag_ = 0;
};

} // namespace romascope
