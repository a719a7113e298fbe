// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace romascope {

/// The name with the smallest edit distance (insert, delete, replace, swap neighbours; case does
/// not count) to `wanted`; the first of equals; empty if `names` is. The last word of a dotted name
/// is tried alone too: "resolution" finds "roma.resolution", unless a whole name is as near.
std::string nearest_name(std::string_view wanted, const std::vector<std::string>& names);

} // namespace romascope
