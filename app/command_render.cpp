// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/common_options.h"
#include "app/flicker_watch.h"
#include "app/frame_run.h"
#include "app/lag_watch.h"
#include "app/output_files.h"
#include "app/report.h"
#include "app/scene_files.h"
#include "app/scene_options.h"
#include "app/settings_options.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/frame/notices.h"
#include "renderer/image/image_io.h"
#include "renderer/metrics/compare.h"
#include "renderer/scene/pose.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <utility>

namespace romascope {
namespace {

namespace fs = std::filesystem;

struct RenderOptions {
    std::string scene = kDefaultScene;
    fs::path output, report, reference_output, error_map, shaders;
    SettingsOptions settings;
    SceneOptions memory;
    std::vector<std::string> path;
    std::optional<std::pair<int, double>> jump; ///< frame, seconds
    std::optional<int> reference_samples;
    bool print_config = false;
    bool table = false;
    bool no_cache = false;
    bool flicker = false;
    BackendOptions backend;
};

void check_jump(std::pair<int, double> jump, const Settings& settings, bool flies) {
    if (settings.get(kFrames) < 2)
        throw Error("--jump needs at least --frames 2: there are frames before it and after it",
                    kBadInput);
    if (jump.first < 1 || jump.first >= settings.get(kFrames))
        throw Error(fmt::format("--jump {} {}: it needs frames before and after it: its frame is "
                                "from 1 to {}, one below --frames",
                                jump.first, jump.second, settings.get(kFrames) - 1),
                    kBadInput);
    if (!(jump.second >= 0.0) || !std::isfinite(jump.second))
        throw Error(
            fmt::format("--jump {} {}: a time is 0 seconds or more", jump.first, jump.second),
            kBadInput);
    if (flies || settings.get(kFps) != 0.0)
        throw Error("--jump is the only change: give neither --path nor --fps", kBadInput);
}

/// What can be refused before any work is done.
void check_outputs(const RenderOptions& options, const Settings& settings) {
    const bool wants_reference = !options.reference_output.empty() || !options.error_map.empty();
    if (options.output.empty() && options.report.empty() && !options.table &&
        !options.reference_samples && !wants_reference)
        throw Error("nothing to do: give -o FILE, --report FILE, --table or --reference N",
                    kBadInput);
    for (const fs::path& picture : {options.output, options.reference_output, options.error_map})
        if (!picture.empty())
            check_image_extension(picture);
    if (wants_reference && !options.reference_samples)
        throw Error("--reference-output and --error-map need --reference N", kBadInput);
    if (options.flicker && !options.reference_samples)
        throw Error(
            "--flicker needs --reference N: it is the change that the truth does not explain",
            kBadInput);
    if (options.flicker && settings.get(kFrames) < 2)
        throw Error("--flicker needs at least --frames 2", kBadInput);
    if (!options.path.empty() && settings.get(kFrames) < 2)
        throw Error("--path needs at least --frames 2: all frames together fly it", kBadInput);
    if (!options.path.empty() && !options.settings.camera.empty())
        throw Error("--camera stands still, --path flies: give one of them", kBadInput);
    if (std::ranges::find(options.path, "") != options.path.end())
        throw Error("--path needs the name of a camera, eye/target/degrees, or all", kBadInput);
    if (options.jump)
        check_jump(*options.jump, settings, !options.path.empty());
    check_tracer(settings);
    if (options.reference_samples)
        check_reference(settings, *options.reference_samples);
    options.memory.limit();
}

int render(const RenderOptions& options) {
    const Settings settings = options.settings.apply_to(Settings(all_knobs()));
    if (options.print_config) {
        fmt::print("{}", settings.to_toml());
        return 0;
    }
    check_outputs(options, settings);
    const fs::path file = find_scene(options.scene);
    std::vector<fs::path> inputs = options.settings.configs;
    inputs.push_back(file);
    check_output_files(
        {options.output, options.report, options.reference_output, options.error_map}, inputs);
    Scene scene = options.memory.load(file);
    Showing showing(scene, settings, options.path);
    if (options.jump) {
        const bool rests = find_animation(scene, settings.get(kAnimation)) < 0;
        if (scene.motion.parts.empty() || rests)
            throw Error(
                fmt::format(
                    "{}: nothing in it moves{}, so --jump has nothing to show", file.string(),
                    rests && !scene.motion.animations.empty() ? " with --animation none" : ""),
                kBadInput);
        showing.jump({options.jump->first, options.jump->second});
        if (showing.jumps_in_vain())
            tell_notice(file, "stands after --jump as before it: nothing changes");
    }
    if (showing.is_asked_in_vain())
        tell_notice(file, "has no animation: --time and --fps change nothing");

    const std::unique_ptr<Context> context = options.backend.make_context();
    const DriverFacts driver = query_driver();
    const bool judges_lag = options.jump && options.reference_samples;
    if (driver.software)
        check_memory(scene, settings, options.memory.left_beside(scene),
                     options.memory.max_memory.has_value(), judges_lag ? 2 : 1);
    std::optional<DebugLog> log;
    if (options.backend.debug)
        log.emplace();
    const auto shaders = [&] {
        return options.shaders.empty() ? ShaderLibrary() : ShaderLibrary(options.shaders);
    };
    Pipeline pipeline(scene, shaders());
    for (const std::string& notice : notices_of(settings, scene))
        tell_notice(file, notice);
    std::optional<Truths> truths;
    if (options.reference_samples)
        truths.emplace(scene, settings, showing, *options.reference_samples, !options.no_cache);
    std::optional<LagWatch> lag;
    if (judges_lag)
        lag.emplace(scene, settings, showing, *truths, options.jump->first, shaders());
    std::optional<FlickerWatch> flicker;
    if (options.flicker)
        flicker.emplace(*truths, settings.get(kFrames));
    std::optional<FlightWatch> flight;
    if (!options.path.empty())
        flight.emplace(showing, settings);
    const FrameRun run = render_frames(pipeline, settings, showing, [&](int frame) {
        if (flight)
            (*flight)(pipeline);
        if (flicker)
            (*flicker)(pipeline, frame);
        if (lag)
            (*lag)(pipeline, frame);
    });
    if (log && !log->messages().empty())
        throw Error(log->messages().front());

    const Camera camera = showing.camera();
    if (!scene.motion.empty())
        apply_pose(scene, showing.pose()); // what follows is about the last frame
    ReportFacts facts{options.settings.technique, file.string(), &scene, &settings, camera};
    facts.backend = context->description();
    facts.driver = driver;
    facts.clock = run.clock;
    facts.timings = run.timings;
    facts.bytes = run.bytes;
    facts.counts = run.counts;
    if (options.jump)
        facts.jump = TimeJump{options.jump->first, options.jump->second};
    if (flight)
        facts.flight = flight->facts();
    if (truths) {
        const AoReference& truth = truths->now();
        facts.errors = judge(truth, run.picture, *options.reference_samples);
        facts.errors->reference_seconds = truths->seconds();
        facts.errors->reference_from_cache = truths->from_cache();
        if (flicker)
            facts.errors->flicker = flicker->value();
        if (lag)
            facts.errors->lag = lag->value();
        if (!options.reference_output.empty())
            write_image(options.reference_output, truth.visibility);
        if (!options.error_map.empty())
            write_image(options.error_map,
                        metric_picture(Metric::flip, truth.visibility, run.picture).picture);
    }
    if (!options.output.empty())
        write_image(options.output, run.picture);
    if (!options.report.empty())
        write_file_atomically(options.report, report_json(facts));
    for (const std::string& notice : notices_of(settings, run.counts))
        tell_notice(file, notice);
    if (options.table)
        fmt::print("{}", report_table(facts));
    else if (options.report.empty())
        fmt::print("{}", error_table(facts)); // else nobody would be told what was asked for
    return 0;
}

} // namespace

Command add_render_command(CLI::App& app) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App* command = app.add_subcommand("render", "Render a scene to a file, without a window");
    command
        ->add_option("SCENE", options->scene, "a .gltf or .glb file, or a built-in scene by name")
        ->type_name("")
        ->capture_default_str();
    command
        ->add_option("-o,--output", options->output,
                     "picture: .png (sRGB) or .hdr (linear floats); missing folders are made")
        ->type_name("FILE");
    options->settings.add_to(*command, "width and height in pixels, like 1280x720",
                             "frames to accumulate");
    command->add_option("--report", options->report, "JSON of settings, times, bytes and errors")
        ->type_name("FILE");
    command->add_flag("--table", options->table, "print times, bytes and errors");
    command
        ->add_option("--reference", options->reference_samples,
                     "judge against ground truth with so many samples per pixel")
        ->type_name("N");
    command->add_option("--reference-output", options->reference_output, "picture of the truth")
        ->type_name("FILE");
    command->add_option("--error-map", options->error_map, "picture of FLIP against the truth")
        ->type_name("FILE");
    command
        ->add_option("--path", options->path,
                     "fly through cameras in turn; repeated for each, or all: those of the scene")
        ->type_name("CAMERA")
        ->allow_extra_args(false);
    command
        ->add_option("--jump", options->jump,
                     "from FRAME on, counted from 0, the scene stands at another moment; with "
                     "--reference: for how many frames pictures lag behind that")
        ->type_name("FRAME SECONDS");
    command->add_flag("--flicker", options->flicker,
                      "with --reference: how much frames change that the truth does not");
    command->add_flag("--no-cache", options->no_cache, "compute the reference anew");
    command->add_flag("--print-config", options->print_config,
                      "print the settings in effect as TOML and stop");
    add_shader_folder(*command, options->shaders,
                      "read shaders from this folder instead of the program");
    options->memory.add_to(*command);
    options->backend.add_to(*command);
    return [options] { return render(*options); };
}

} // namespace romascope
