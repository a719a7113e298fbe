// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <deque>
#include <string>
#include <vector>

namespace romascope {

enum class Severity { info, notice, error };

/// Something the user should know.
struct Message {
    Severity severity = Severity::info;
    std::string text;
    int times = 1;                              ///< how often in a row
    std::chrono::steady_clock::time_point told; ///< last
};

/// What was told to the user, newest last: in the window and, line by line, on stderr.
class Messages {
public:
    void tell(Severity severity, const std::string& text);
    /// It no longer holds: forgotten, if it is there.
    void withdraw(const std::string& text);
    /// What holds is now another: tells what `told` does not have, withdraws what `now` does not
    /// have, and makes `told` the same as `now`.
    void replace(Severity severity, std::vector<std::string>& told, std::vector<std::string> now);
    const std::deque<Message>& all() const { return all_; }

private:
    std::deque<Message> all_;
};

} // namespace romascope
