// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace romascope {

/// What a user can mend: a bad file, key, value or driver. The text is one line that says what is
/// wrong, where, and what to do; `main` prints it on stderr and ends with `exit_status`.
/// A programmer's mistake is an assertion instead, a likely "no" is a return value.
class Error : public std::runtime_error {
public:
    explicit Error(const std::string& text, int exit_status = 1)
        : std::runtime_error(text), exit_status_(exit_status) {}

    /// 1: it did not work; 2: the input (command line, key, file) is at fault.
    int exit_status() const { return exit_status_; }

private:
    int exit_status_;
};

/// Exit status for bad input: command line, settings, scene files.
inline constexpr int kBadInput = 2;

} // namespace romascope
