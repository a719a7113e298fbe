// SPDX-License-Identifier: MIT
#include "app/truths.h"

#include "renderer/scene/pose.h"

namespace romascope {

Truths::Truths(const Scene& scene, const Settings& settings, const Showing& showing, int samples,
               bool use_cache)
    : scene_(scene), settings_(settings), showing_(showing), samples_(samples),
      use_cache_(use_cache) {}

bool Truths::is_of_now() const {
    return last_ && pose_ == showing_.pose() && same_view(camera_, showing_.camera());
}

const AoReference& Truths::now() {
    if (is_of_now())
        return *last_;
    pose_ = showing_.pose();
    camera_ = showing_.camera();
    if (scene_.motion.empty()) {
        last_ = truth_of(scene_, camera_, settings_, samples_, use_cache_);
    } else {
        Scene posed = scene_;
        apply_pose(posed, pose_);
        last_ = truth_of(posed, camera_, settings_, samples_, use_cache_);
    }
    seconds_ += last_->seconds;
    from_cache_ = from_cache_ && last_->from_cache;
    return *last_;
}

} // namespace romascope
