// SPDX-License-Identifier: MIT
// What an error split found, as a table, as CSV and as JSON.
#pragma once

#include "app/facts.h"
#include "app/split/tally.h"

#include <string>
#include <vector>

namespace romascope {

/// Of one variant.
struct SplitResult {
    std::string variant;
    std::vector<Tally> scenes; ///< in the order of the names
    Tally all() const;
};

/// A block for each variant, then a line for each.
std::string split_table(const Facts& facts, const std::vector<std::string>& scenes,
                        const std::vector<SplitResult>& results);
/// Facts as lines "# name: text", then a line of columns, then one for each variant, scene and
/// step; the scene "all" is their sum, there with more than one.
std::string split_csv(const Facts& facts, const std::vector<std::string>& scenes,
                      const std::vector<SplitResult>& results);
std::string split_json(const Facts& facts, const std::vector<std::string>& scenes,
                       const std::vector<SplitResult>& results);

} // namespace romascope
