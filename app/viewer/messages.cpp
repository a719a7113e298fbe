// SPDX-License-Identifier: MIT
#include "app/viewer/messages.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>

namespace romascope {
namespace {

constexpr size_t kMessagesKept = 200;

} // namespace

void Messages::tell(Severity severity, const std::string& text) {
    const auto now = std::chrono::steady_clock::now();
    if (!all_.empty() && all_.back().text == text && all_.back().severity == severity) {
        ++all_.back().times;
        all_.back().told = now;
    } else {
        all_.push_back({severity, text, 1, now});
        if (all_.size() > kMessagesKept)
            all_.pop_front();
    }
    // Not by fmt::print, which throws where nobody reads.
    const std::string line =
        fmt::format("{}: {}\n", severity == Severity::notice ? "notice" : "romascope", text);
    std::fputs(line.c_str(), stderr);
    std::fflush(stderr);
}

void Messages::withdraw(const std::string& text) {
    std::erase_if(all_, [&](const Message& message) { return message.text == text; });
}

} // namespace romascope
