// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace romascope {

/// The name that `wanted` may be misspelt for: with the smallest edit distance (insert, delete,
/// replace, swap neighbours; case does not count), the first of equals; empty if none is near. Near
/// is what differs in at most three letters of eight.
/// Dotted names are compared by their parts, all before the last dot and the word after it, which
/// both have to be near: "roma.directions" does not find "roma.iterations". The word alone finds
/// its name too, "resolution" or "nowhere.resolution" "occupancy.resolution", but only where no
/// whole name is as near, and behind another group only if it is written right.
std::string nearest_name(std::string_view wanted, const std::vector<std::string>& names);

/// ": did you mean 'NAME'?", or nothing, see nearest_name. `before`: instead of the colon.
std::string did_you_mean(std::string_view wanted, const std::vector<std::string>& names,
                         std::string_view before = ": ");

} // namespace romascope
