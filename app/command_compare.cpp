// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/output_files.h"
#include "renderer/base/error.h"
#include "renderer/image/image_io.h"
#include "renderer/metrics/compare.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

namespace romascope {
namespace {

struct CompareOptions {
    std::filesystem::path reference, test, error_map;
    std::string metric;
    std::optional<double> max;
};

/// Exit status where a figure is above its bound.
constexpr int kAboveBound = 1;

int compare(const CompareOptions& options) {
    // Everything that can be refused is refused before anything is read or written.
    std::optional<Metric> only;
    if (!options.metric.empty())
        only = metric_from_name(options.metric);
    if (!options.error_map.empty())
        check_image_extension(options.error_map);
    check_output_files({options.error_map}, {options.reference, options.test});
    if (options.max && !(*options.max >= 0.0))
        throw Error("--max needs a number of at least 0", kBadInput);
    const Image reference = read_image(options.reference);
    const Image test = read_image(options.test);

    int status = 0;
    for (const MetricInfo& info : metric_table()) {
        if (only && *only != info.metric)
            continue;
        const double value = metric_value(info.metric, reference, test);
        fmt::print("{} {:.9g}\n", info.name, value);
        // Bias has a sign; its size is what is bounded.
        if (options.max && std::abs(value) > *options.max) {
            fmt::print(stderr, "romascope: {} is {:.9g}, above the bound {:.9g}\n", info.name,
                       value, *options.max);
            status = kAboveBound;
        }
    }
    if (!options.error_map.empty()) {
        const Metric shown = only.value_or(Metric::flip);
        const MetricPicture map = metric_picture(shown, reference, test);
        write_image(options.error_map, map.picture);
        fmt::print("error map {} ({}, full scale {:.4g})\n", options.error_map.string(),
                   metric_name(shown), map.scale);
    }
    return status;
}

} // namespace

Command add_compare_command(CLI::App& app) {
    auto options = std::make_shared<CompareOptions>();
    CLI::App* command = app.add_subcommand(
        "compare", "Errors of a picture against a reference: FLIP, RMSE, MAE, signed bias");
    command->add_option("REFERENCE", options->reference, "the right picture, .png or .hdr")
        ->type_name("FILE")
        ->required();
    command->add_option("TEST", options->test, "the picture to judge, of the same size")
        ->type_name("FILE")
        ->required();
    command->add_option("--metric", options->metric, "flip, rmse, mae or bias; else all of them")
        ->type_name("NAME");
    command
        ->add_option("--error-map", options->error_map,
                     "picture of the error by the metric (FLIP if none is named)")
        ->type_name("FILE");
    command
        ->add_option("--max", options->max,
                     "exit with status 1 if a figure (of a bias, its size) is above this")
        ->type_name("VALUE");
    return [options] { return compare(*options); };
}

} // namespace romascope
