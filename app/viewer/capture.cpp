// SPDX-License-Identifier: MIT
#include "app/viewer/capture.h"

#include "renderer/image/image_io.h"

#include <utility>

namespace romascope {

Capture::Capture(std::shared_ptr<const Scene> scene, const Settings& settings,
                 ShaderLibrary shaders, std::filesystem::path file)
    : scene_(std::move(scene)), settings_(settings), file_(std::move(file)),
      pipeline_(*scene_, std::move(shaders)), frames_(settings.get(kFrames)) {
    const Pose pose = pose_of_frame(*scene_, settings, 0);
    camera_ = chosen_camera(*scene_, settings, pose);
    pipeline_.set_pose(pose);
}

bool Capture::step() {
    pipeline_.render(settings_, camera_);
    if (++done_ < frames_)
        return false;
    write_image(file_, pipeline_.picture());
    return true;
}

} // namespace romascope
