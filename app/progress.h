// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>

namespace romascope {

/// Tells how far something is, on a terminal, where it takes longer than one is glad to wait.
class Progress {
public:
    /// `what`: a word that goes before the share; a string literal.
    explicit Progress(const char* what);
    /// `share` of it is done, from 0 to 1.
    void done(double share);

private:
    const bool terminal_;
    const char* what_;
    bool shown_ = false;
    std::chrono::steady_clock::time_point told_ = std::chrono::steady_clock::now();
};

/// What tells how far the reference is, in fractions from 0 to 1; empty without a terminal.
std::function<void(double)> reference_progress();

} // namespace romascope
