// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace romascope {

/// Collects the driver's debug messages of high and medium severity for as long as it lives.
/// Needs a current context; full output needs one made with `debug`.
class DebugLog {
public:
    DebugLog();
    ~DebugLog();
    DebugLog(const DebugLog&) = delete;
    DebugLog& operator=(const DebugLog&) = delete;

    const std::vector<std::string>& messages() const { return messages_; }
    /// The same, and forgets them.
    std::vector<std::string> take() { return std::exchange(messages_, {}); }

private:
    friend struct DebugLogAccess;
    std::vector<std::string> messages_;
};

/// A named group of GL commands: what frame debuggers show.
class DebugGroup {
public:
    explicit DebugGroup(const std::string& name);
    ~DebugGroup();
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;
};

/// Throws Error that names the GL error and `where`, if one is pending.
void check_gl_error(const char* where);

} // namespace romascope
