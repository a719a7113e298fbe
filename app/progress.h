// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>

namespace romascope {

/// Tells how far the frames are, on a terminal, where they take longer than one is glad to wait.
class FrameProgress {
public:
    explicit FrameProgress(int frames);
    /// `frame` frames are done.
    void done(int frame);

private:
    const bool terminal_;
    const int frames_;
    bool shown_ = false;
    std::chrono::steady_clock::time_point told_ = std::chrono::steady_clock::now();
};

/// What tells how far the reference is, in fractions from 0 to 1; empty without a terminal.
std::function<void(double)> reference_progress();

} // namespace romascope
