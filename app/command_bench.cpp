// SPDX-License-Identifier: MIT
#include "app/bench/bench_report.h"
#include "app/commands.h"
#include "app/common_options.h"
#include "app/frame_run.h"
#include "app/output_files.h"
#include "app/progress.h"
#include "app/scene_files.h"
#include "app/scene_options.h"
#include "app/settings_options.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/gl/capabilities.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <memory>
#include <thread>

namespace romascope {
namespace {

namespace fs = std::filesystem;

struct BenchOptions {
    std::string scene = kDefaultScene;
    std::vector<std::string> variations;
    std::string baseline;
    double seconds = 20.0;
    fs::path csv, json;
    SettingsOptions settings;
    SceneOptions memory;
    BackendOptions backend;
};

/// What is measured unless it is said otherwise: every tracer, one ray.
Settings bench_settings(const BenchOptions& options) {
    Settings settings(all_knobs());
    settings.set(kTracer, "");
    settings.set(kWidth, 640);
    settings.set(kHeight, 360);
    settings.set(kAoRays, 1);
    settings = options.settings.apply_to(settings);
    check_one_moment(settings);
    check_technique(settings, options.settings.technique);
    return settings;
}

std::string date_now() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    return fmt::format("{:04}-{:02}-{:02} {:02}:{:02} UTC", utc.tm_year + 1900, utc.tm_mon + 1,
                       utc.tm_mday, utc.tm_hour, utc.tm_min);
}

Facts facts_of(const Scene& scene, const fs::path& file, const Settings& settings,
               const Camera& camera, const BenchTimes& times, const std::string& baseline) {
    const DriverFacts driver = query_driver();
    const std::string clock(name_of(times.clock));
    return {{"program", program_fact()},
            {"date", date_now()},
            {"machine",
             fmt::format("{}, {} threads", processor_fact(), std::thread::hardware_concurrency())},
            {"renderer", driver.renderer},
            {"driver", driver.version},
            {"clock",
             fmt::format("{}; passes under {} ms in batches of {}", clock, kShortPassMs, kBatch)},
            {"scene", fmt::format("{}, {} triangles", file.string(), scene.triangle_count())},
            {"camera", camera.name},
            {"size", fmt::format("{}x{}", settings.get(kWidth), settings.get(kHeight))},
            {"settings", settings_fact(settings)},
            {"rounds", fmt::format("{}, after a warm-up", times.rounds)},
            {"baseline", baseline}};
}

/// All variants are held at once.
void check_memory_of_all(const Scene& scene, const std::vector<BenchVariant>& variants,
                         const SceneOptions& memory) {
    size_t left = memory.left_beside(scene);
    for (const BenchVariant& variant : variants) {
        check_memory(scene, variant.settings, left, memory.max_memory.has_value());
        const size_t held =
            make_tracer(variant.settings.get(kTracer))->bytes_needed(variant.settings);
        left -= std::min(held, left);
    }
}

int bench(const BenchOptions& options) {
    const Settings settings = bench_settings(options);
    const std::vector<BenchVariant> variants = expand_variants(
        settings, options.variations.empty() ? default_variations(settings, options.settings)
                                             : parse_variations(settings, options.variations));
    const size_t baseline = options.baseline.empty() ? 0 : find_variant(variants, options.baseline);
    if (!(options.seconds > 0.0 && options.seconds <= 3600.0))
        throw Error("--seconds takes more than 0, up to 3600", kBadInput);
    const fs::path file = find_scene(options.scene);
    std::vector<fs::path> inputs = options.settings.configs;
    inputs.push_back(file);
    check_output_files({options.csv, options.json}, inputs);
    const Scene scene = options.memory.load(file);
    const Showing showing(scene, settings);

    const std::unique_ptr<Context> context = options.backend.make_context();
    if (query_driver().software)
        check_memory_of_all(scene, variants, options.memory);
    Benchmark benchmark(scene, showing.pose(), showing.camera(), variants);
    for (const std::string& notice : notices_of(variants, scene))
        tell_notice(file, notice);
    Progress progress("measured");
    benchmark.warm_up();
    const bool counted = !options.settings.frames.empty() || !settings.is_default(kFrames);
    const int rounds = counted ? settings.get(kFrames) : 0;
    const BenchTimes times = benchmark.run(
        rounds, options.seconds, [&](double share) { progress.done(std::min(share, 1.0)); });

    const std::string& name = variants[baseline].name;
    const Facts facts = facts_of(scene, file, settings, showing.camera(), times, name);
    const std::vector<BenchRow> rows = bench_rows(times, baseline);
    if (!options.csv.empty())
        write_file_atomically(options.csv, bench_csv(facts, rows));
    if (!options.json.empty())
        write_file_atomically(options.json, bench_json(facts, rows));
    fmt::print("{}", bench_table(facts, rows, name));
    return 0;
}

} // namespace

Command add_bench_command(CLI::App& app) {
    auto options = std::make_shared<BenchOptions>();
    CLI::App* command = app.add_subcommand(
        "bench", "Times of tracers side by side: what building and tracing each costs");
    command
        ->add_option("SCENE", options->scene, "a .gltf or .glb file, or a built-in scene by name")
        ->type_name("")
        ->capture_default_str();
    command
        ->add_option("--vary", options->variations,
                     "measure with each of these values of a setting, technique.tracer among them; "
                     "may be repeated")
        ->type_name("KEY=A,B,C")
        ->allow_extra_args(false);
    command
        ->add_option("--baseline", options->baseline,
                     "the variant that ratios are to, as the table names it, or a part of that; "
                     "else the first")
        ->type_name("NAME");
    options->settings.add_to(*command, "width and height in pixels; else 640x360",
                             "rounds to measure; else as many as --seconds has",
                             SettingsOptions::Moments::one);
    command->add_option("--seconds", options->seconds, "how long to measure, after a warm-up")
        ->type_name("S")
        ->capture_default_str();
    command->add_option("--csv", options->csv, "write the table as CSV too")->type_name("FILE");
    command->add_option("--json", options->json, "write the table as JSON too")->type_name("FILE");
    options->memory.add_to(*command);
    options->backend.add_to(*command);
    return [options] { return bench(*options); };
}

} // namespace romascope
