// SPDX-License-Identifier: MIT
#include "app/split/split_report.h"

#include "app/json.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>

namespace romascope {
namespace {

/// Per cent of all rays.
double percent(int64_t count, const Tally& tally) {
    return tally.rays == 0 ? 0.0
                           : 100.0 * static_cast<double>(count) / static_cast<double>(tally.rays);
}

double percent(uint64_t count, const Tally& tally) {
    return percent(static_cast<int64_t>(count), tally);
}

struct NamedTally {
    std::string scene;
    Tally tally;
};

std::vector<NamedTally> tallies_of(const std::vector<std::string>& scenes,
                                   const SplitResult& result) {
    std::vector<NamedTally> tallies;
    for (size_t i = 0; i < scenes.size(); ++i)
        tallies.push_back({scenes[i], result.scenes[i]});
    if (scenes.size() > 1)
        tallies.push_back({"all", result.all()});
    return tallies;
}

std::string table_line(const std::string& name, const Tally& tally,
                       const std::function<double(const StepErrors&)>& value, bool sign) {
    std::string line = fmt::format("  {:<24}", name);
    for (const StepErrors& step : tally.steps) {
        const double share = value(step);
        line += sign ? fmt::format(" {:>+14.3f}", share) : fmt::format(" {:>14.3f}", share);
    }
    return line + "\n";
}

std::string table_block(const Tally& tally) {
    const auto share = [&](auto count) {
        return [&tally, count](const StepErrors& step) { return percent((step.*count)(), tally); };
    };
    std::string text = table_line("wrong rays, %", tally, share(&StepErrors::wrong), false);
    text += table_line(
        "leaks, %", tally, [&](const StepErrors& step) { return percent(step.leaks, tally); },
        false);
    text += table_line(
        "false shadows, %", tally,
        [&](const StepErrors& step) { return percent(step.false_shadows, tally); }, false);
    return text + table_line("difference, %", tally, share(&StepErrors::difference), true);
}

/// Of a share, in per cent, as if rays were independent.
double standard_error(int64_t count, const Tally& tally) {
    const double share = percent(count, tally) / 100.0;
    return tally.rays > 0
               ? 100.0 * std::sqrt(share * (1.0 - share) / static_cast<double>(tally.rays))
               : 0.0;
}

/// A line for each variant: what compares methods, whether they have candidates or not.
std::string summary(const std::vector<SplitResult>& results) {
    std::string text =
        fmt::format("\n{:>9} {:>6} {:>9} {:>14} {:>12}  of all rays, along their own directions; "
                    "+-: standard error\n",
                    "wrong, %", "+-", "leaks, %", "false shadows", "difference");
    for (const SplitResult& result : results) {
        const Tally tally = result.all();
        const StepErrors& own = tally.of(Step::own_direction);
        text += fmt::format("{:>9.3f} {:>6.3f} {:>9.3f} {:>14.3f} {:>+12.3f}  {}\n",
                            percent(own.wrong(), tally), standard_error(own.wrong(), tally),
                            percent(own.leaks, tally), percent(own.false_shadows, tally),
                            percent(own.difference(), tally), result.variant);
    }
    return text;
}

} // namespace

Tally SplitResult::all() const {
    Tally sum;
    for (const Tally& tally : scenes)
        sum += tally;
    return sum;
}

std::string split_table(const Facts& facts, const std::vector<std::string>& scenes,
                        const std::vector<SplitResult>& results) {
    std::string text = fact_lines(facts);
    text += fmt::format("\n{:<26}", "");
    for (const std::string_view step : kStepNames)
        text += fmt::format(" {:>14}", step);
    text += '\n';
    for (const SplitResult& result : results) {
        const std::vector<NamedTally> tallies = tallies_of(scenes, result);
        text += fmt::format("\n{}, {} rays\n{}", result.variant, tallies.back().tally.rays,
                            table_block(tallies.back().tally));
        if (tallies.size() == 1)
            continue;
        for (size_t i = 0; i + 1 < tallies.size(); ++i) {
            const Tally& tally = tallies[i].tally;
            text += table_line(
                fmt::format("{}: wrong rays", tallies[i].scene), tally,
                [&](const StepErrors& step) { return percent(step.wrong(), tally); }, false);
        }
    }
    return text + summary(results);
}

std::string split_csv(const Facts& facts, const std::vector<std::string>& scenes,
                      const std::vector<SplitResult>& results) {
    std::string text = fact_lines(facts, "# ");
    text += "variant,scene,step,rays,wrong,leaks,false_shadows,difference,wrong_percent,"
            "leaks_percent,false_shadows_percent,difference_percent\n";
    for (const SplitResult& result : results)
        for (const auto& [scene, tally] : tallies_of(scenes, result))
            for (size_t i = 0; i < kStepNames.size(); ++i) {
                const StepErrors& step = tally.steps[i];
                text += fmt::format("{},{},{},{},{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g}\n",
                                    csv_field(result.variant), csv_field(scene), kStepNames[i],
                                    tally.rays, step.wrong(), step.leaks, step.false_shadows,
                                    step.difference(), percent(step.wrong(), tally),
                                    percent(step.leaks, tally), percent(step.false_shadows, tally),
                                    percent(step.difference(), tally));
            }
    return text;
}

std::string split_json(const Facts& facts, const std::vector<std::string>& scenes,
                       const std::vector<SplitResult>& results) {
    Json json = {{"schema", "romascope-split/1"}};
    for (const auto& [name, value] : facts)
        json["facts"][name] = value;
    json["rows"] = Json::array();
    for (const SplitResult& result : results)
        for (const auto& [scene, tally] : tallies_of(scenes, result))
            for (size_t i = 0; i < kStepNames.size(); ++i) {
                const StepErrors& step = tally.steps[i];
                json["rows"].push_back({{"variant", result.variant},
                                        {"scene", scene},
                                        {"step", kStepNames[i]},
                                        {"rays", tally.rays},
                                        {"wrong", step.wrong()},
                                        {"leaks", step.leaks},
                                        {"false_shadows", step.false_shadows},
                                        {"difference", step.difference()}});
            }
    return pretty(json);
}

} // namespace romascope
