// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <string>

namespace romascope {

/// "a, b, c" for messages; of more than 20 names the first, then "...".
inline std::string listing(std::span<const std::string> names) {
    constexpr size_t kMostTold = 20;
    const size_t told = std::min(names.size(), kMostTold);
    return fmt::format("{}{}", fmt::join(names.first(told), ", "),
                       told < names.size() ? ", ..." : "");
}

} // namespace romascope
