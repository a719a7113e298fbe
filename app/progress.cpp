// SPDX-License-Identifier: MIT
#include "app/progress.h"

#include <fmt/format.h>

#include <unistd.h>

#include <cstdio>

namespace romascope {
namespace {

/// On one line of a terminal that is written over and over.
void show_progress(const char* what, double fraction) {
    fmt::print(stderr, "\r{} {:3.0f} %{}", what, 100.0 * fraction, fraction >= 1.0 ? "\n" : "");
    std::fflush(stderr);
}

} // namespace

FrameProgress::FrameProgress(int frames) : terminal_(isatty(STDERR_FILENO)), frames_(frames) {}

void FrameProgress::done(int frame) {
    const auto now = std::chrono::steady_clock::now();
    const bool last = frame == frames_;
    if (!terminal_ || (last ? !shown_ : now - told_ < std::chrono::seconds(1)))
        return;
    told_ = now;
    shown_ = true;
    show_progress("frames", static_cast<double>(frame) / frames_);
}

std::function<void(double)> reference_progress() {
    if (!isatty(STDERR_FILENO))
        return {};
    return [](double fraction) { show_progress("reference", fraction); };
}

} // namespace romascope
