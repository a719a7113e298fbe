// SPDX-License-Identifier: MIT
// What a benchmark found, as a table, as CSV and as JSON, with all that it takes to find it again.
#pragma once

#include "app/bench/measure.h"
#include "app/facts.h"

#include <string>
#include <vector>

namespace romascope {

/// A distribution: its median, and the values between which nine tenths lie.
struct Spread {
    double p5, median, p95;
};
Spread spread_of(const std::vector<double>& values);

/// One line: a pass, or the sum of some. Sums are made round by round, ratios as well.
struct BenchRow {
    std::string variant; ///< empty for what all share
    std::string phase;   ///< "build", "trace" or "shared"
    std::string pass;    ///< its name, or "sum", "sum of compute", "sum of rasterising"
    std::string kind;    ///< "compute", "rasterises" or "both"
    int batch = 1;
    std::vector<double> milliseconds;
    std::vector<double> ratios; ///< to the same line of the baseline; empty if that has none
    size_t bytes = 0;           ///< of the variant's structure; 0 where it is no line of that
};

/// Every pass of every variant and the sums of its build, in order.
std::vector<BenchRow> bench_rows(const BenchTimes& times, size_t baseline);

std::string bench_table(const Facts& facts, const std::vector<BenchRow>& rows,
                        const std::string& baseline);
/// Facts as lines "# name: text", then a line of columns.
std::string bench_csv(const Facts& facts, const std::vector<BenchRow>& rows);
std::string bench_json(const Facts& facts, const std::vector<BenchRow>& rows);

} // namespace romascope
