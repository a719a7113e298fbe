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

Progress::Progress(const char* what) : terminal_(isatty(STDERR_FILENO)), what_(what) {}

void Progress::done(double share) {
    const auto now = std::chrono::steady_clock::now();
    const bool last = share >= 1.0;
    if (!terminal_ || (last ? !shown_ : now - told_ < std::chrono::seconds(1)))
        return;
    told_ = now;
    shown_ = true;
    show_progress(what_, share);
}

std::function<void(double)> reference_progress() {
    if (!isatty(STDERR_FILENO))
        return {};
    return [](double fraction) { show_progress("reference", fraction); };
}

} // namespace romascope
