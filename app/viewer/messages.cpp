// SPDX-License-Identifier: MIT
#include "app/viewer/messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>

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

void Messages::replace(Severity severity, std::vector<std::string>& told,
                       std::vector<std::string> now) {
    const auto has = [](const std::vector<std::string>& texts, const std::string& text) {
        return std::ranges::find(texts, text) != texts.end();
    };
    for (const std::string& text : told)
        if (!has(now, text))
            withdraw(text);
    for (const std::string& text : now)
        if (!has(told, text))
            tell(severity, text);
    told = std::move(now);
}

} // namespace romascope
