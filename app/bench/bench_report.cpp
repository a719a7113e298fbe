// SPDX-License-Identifier: MIT
#include "app/bench/bench_report.h"

#include "app/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace romascope {
namespace {

/// What all tracers of cells build first.
constexpr std::string_view kOccupancyPass = "occupancy map";

std::string kind_of(const PassTiming& timing) {
    return timing.rasterises ? "rasterises" : "compute";
}

BenchRow pass_row(const std::string& variant, const std::string& phase, const PassTiming& timing) {
    return {variant, phase, timing.pass, kind_of(timing), timing.batch, timing.milliseconds, {}, 0};
}

/// The sum, in each round, of the passes that are chosen; nothing if there are none.
template <class Chosen>
std::optional<BenchRow> sum_row(const std::string& variant, const std::string& name,
                                const std::vector<PassTiming>& passes, const Chosen& chosen) {
    BenchRow row{variant, "build", name, "", 1, {}, {}, 0};
    for (const PassTiming& pass : passes) {
        if (!chosen(pass))
            continue;
        row.kind = row.kind.empty() || row.kind == kind_of(pass) ? kind_of(pass) : "both";
        row.milliseconds.resize(pass.milliseconds.size(), 0.0);
        std::ranges::transform(row.milliseconds, pass.milliseconds, row.milliseconds.begin(),
                               std::plus());
    }
    return row.kind.empty() ? std::nullopt : std::optional(row);
}

std::vector<BenchRow> rows_of(const VariantTimes& variant) {
    std::vector<BenchRow> rows;
    for (const PassTiming& pass : variant.build)
        rows.push_back(pass_row(variant.name, "build", pass));
    const auto add_sum = [&](const std::string& name, const auto& chosen) {
        if (std::optional<BenchRow> row = sum_row(variant.name, name, variant.build, chosen))
            rows.push_back(std::move(*row));
    };
    // Whatever they are made of, sums of the same name can be compared.
    add_sum("sum beyond occupancy",
            [](const PassTiming& pass) { return pass.pass != kOccupancyPass; });
    if (std::ranges::any_of(variant.build, &PassTiming::rasterises) &&
        !std::ranges::all_of(variant.build, &PassTiming::rasterises)) {
        add_sum("sum of rasterising", [](const PassTiming& pass) { return pass.rasterises; });
        add_sum("sum of compute", [](const PassTiming& pass) { return !pass.rasterises; });
    }
    add_sum("sum", [](const PassTiming&) { return true; });
    for (const PassTiming& pass : variant.trace)
        rows.push_back(pass_row(variant.name, "trace", pass));
    for (BenchRow& row : rows)
        row.bytes = row.pass == "sum" ? variant.bytes : 0;
    return rows;
}

void add_ratios(std::vector<BenchRow>& rows, const std::vector<BenchRow>& baseline) {
    for (BenchRow& row : rows) {
        const auto base = std::ranges::find_if(baseline, [&](const BenchRow& other) {
            return other.phase == row.phase && other.pass == row.pass;
        });
        if (base == baseline.end())
            continue;
        for (size_t i = 0; i < row.milliseconds.size(); ++i)
            row.ratios.push_back(row.milliseconds[i] / base->milliseconds[i]);
    }
}

} // namespace

Spread spread_of(const std::vector<double>& values) {
    return {quantile(values, 0.05), quantile(values, 0.5), quantile(values, 0.95)};
}

std::vector<BenchRow> bench_rows(const BenchTimes& times, size_t baseline) {
    const std::vector<BenchRow> base = rows_of(times.variants[baseline]);
    std::vector<BenchRow> all = {pass_row("", "shared", times.empty),
                                 pass_row("", "shared", times.gbuffer)};
    for (const VariantTimes& variant : times.variants) {
        std::vector<BenchRow> rows = rows_of(variant);
        add_ratios(rows, base);
        all.insert(all.end(), rows.begin(), rows.end());
    }
    return all;
}

std::string bench_table(const Facts& facts, const std::vector<BenchRow>& rows,
                        const std::string& baseline) {
    std::string text = fact_lines(facts);
    text += fmt::format("\n{:<7}{:<22} {:>10} {:>10} {:>10} {:>8} {:>8} {:>8} {:>6}\n", "", "pass",
                        "median ms", "p5", "p95", "ratio", "p5", "p95", "batch");
    std::string variant;
    for (const BenchRow& row : rows) {
        if (row.variant != variant) {
            variant = row.variant;
            text += fmt::format("\n{}{}\n", variant, variant == baseline ? "  (baseline)" : "");
        }
        const Spread time = spread_of(row.milliseconds);
        text += fmt::format("{:<7}{:<22} {:>10.4f} {:>10.4f} {:>10.4f}", row.phase, row.pass,
                            time.median, time.p5, time.p95);
        const Spread ratio = spread_of(row.ratios);
        text += row.ratios.empty()
                    ? fmt::format(" {:>8} {:>8} {:>8}", "", "", "")
                    : fmt::format(" {:>8.3f} {:>8.3f} {:>8.3f}", ratio.median, ratio.p5, ratio.p95);
        text += fmt::format(" {:>6}", row.batch);
        if (row.bytes > 0)
            text += fmt::format("  {} bytes", row.bytes);
        else if (row.kind == "rasterises")
            text += "  rasterises";
        text += '\n';
    }
    return text;
}

std::string bench_csv(const Facts& facts, const std::vector<BenchRow>& rows) {
    std::string text = fact_lines(facts, "# ");
    text += "variant,phase,pass,kind,batch,rounds,median_ms,p5_ms,p95_ms,ratio,ratio_p5,"
            "ratio_p95,bytes\n";
    for (const BenchRow& row : rows) {
        const Spread time = spread_of(row.milliseconds);
        text += fmt::format("{},{},{},{},{},{},{:.7g},{:.7g},{:.7g},", csv_field(row.variant),
                            row.phase, csv_field(row.pass), row.kind, row.batch,
                            row.milliseconds.size(), time.median, time.p5, time.p95);
        const Spread ratio = spread_of(row.ratios);
        text += row.ratios.empty()
                    ? std::string(",,")
                    : fmt::format("{:.6g},{:.6g},{:.6g}", ratio.median, ratio.p5, ratio.p95);
        text += row.bytes > 0 ? fmt::format(",{}\n", row.bytes) : std::string(",\n");
    }
    return text;
}

std::string bench_json(const Facts& facts, const std::vector<BenchRow>& rows) {
    const auto spread_json = [](const std::vector<double>& values) -> Json {
        if (values.empty())
            return nullptr;
        const Spread spread = spread_of(values);
        return {{"median", spread.median}, {"p5", spread.p5}, {"p95", spread.p95}};
    };
    Json json = {{"schema", "romascope-bench/1"}};
    for (const auto& [name, value] : facts)
        json["facts"][name] = value;
    json["rows"] = Json::array();
    for (const BenchRow& row : rows)
        json["rows"].push_back({{"variant", row.variant},
                                {"phase", row.phase},
                                {"pass", row.pass},
                                {"kind", row.kind},
                                {"batch", row.batch},
                                {"rounds", row.milliseconds.size()},
                                {"ms", spread_json(row.milliseconds)},
                                {"ratio", spread_json(row.ratios)},
                                {"bytes", row.bytes}});
    return pretty(json);
}

} // namespace romascope
