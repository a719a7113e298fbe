// SPDX-License-Identifier: MIT
#include "app/lag_watch.h"

#include <cmath>

namespace romascope {

LagWatch::LagWatch(const Scene& scene, const Settings& settings, const Showing& showing,
                   Truths& truths, int first, ShaderLibrary shaders)
    : settings_(settings), showing_(showing), truths_(truths), first_(first),
      fresh_(scene, std::move(shaders)) {}

bool LagWatch::is_judged(size_t pixel) const {
    return std::abs(truth_.data[pixel] - before_.data[pixel]) >= kChange;
}

double LagWatch::error_of(const Pipeline& pipeline) const {
    const Image picture = pipeline.picture();
    double sum = 0;
    for (size_t i = 0; i < truth_.data.size(); ++i)
        if (is_judged(i))
            sum += std::abs(double{picture.data[i]} - double{truth_.data[i]});
    return sum;
}

void LagWatch::operator()(const Pipeline& pipeline, int frame) {
    if (frame + 1 == first_)
        before_ = truths_.now().visibility;
    if (frame < first_)
        return;
    if (frame == first_) {
        truth_ = truths_.now().visibility;
        for (size_t i = 0; i < truth_.data.size(); ++i)
            changed_ = changed_ || is_judged(i);
        fresh_.restart(static_cast<uint32_t>(frame)); // with the same random numbers
    }
    fresh_.set_pose(showing_.pose());
    fresh_.render(settings_, showing_.camera());
    if (error_of(pipeline) > kTolerated * error_of(fresh_))
        lag_ = frame - first_ + 1;
}

} // namespace romascope
