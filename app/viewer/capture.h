// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/frame/pipeline.h"

#include <filesystem>
#include <memory>

namespace romascope {

/// A picture that is rendered at another size than the window's, a frame at a time, while the
/// window goes on. It is what `romascope render` gives.
class Capture {
public:
    /// Keeps the scene alive. `settings`: with the size and the number of frames. Throws
    /// Error if they cannot be rendered.
    Capture(std::shared_ptr<const Scene> scene, const Settings& settings, ShaderLibrary shaders,
            std::filesystem::path file);

    /// One frame more; after the last one the file is written. True when that is done. Throws Error
    /// if the frame cannot be drawn or the file not be written.
    bool step();
    float progress() const { return static_cast<float>(done_) / static_cast<float>(frames_); }
    const std::filesystem::path& file() const { return file_; }
    glm::ivec2 size() const { return {settings_.get(kWidth), settings_.get(kHeight)}; }

private:
    std::shared_ptr<const Scene> scene_;
    Settings settings_;
    std::filesystem::path file_;
    Pipeline pipeline_;
    Camera camera_;
    int done_ = 0, frames_;
};

} // namespace romascope
