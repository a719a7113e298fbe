// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/common_options.h"
#include "app/output_files.h"
#include "app/report.h"
#include "app/scene_files.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/frame/pipeline.h"
#include "renderer/image/image_io.h"
#include "renderer/metrics/compare.h"
#include "renderer/reference/ao_reference.h"
#include "renderer/scene/gltf/import.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>

namespace romascope {
namespace {

namespace fs = std::filesystem;

struct RenderOptions {
    std::string scene = kDefaultScene;
    fs::path output, report, reference_output, error_map, shaders;
    std::string technique, camera, size, frames, seed;
    std::vector<std::string> assignments;
    std::vector<fs::path> configs;
    std::optional<int> reference_samples;
    bool print_config = false;
    bool table = false;
    bool no_cache = false;
    BackendOptions backend;
};

void set_size(Settings& settings, const std::string& text) {
    const size_t x = text.find('x');
    const auto is_malformed = [](const std::string& number) {
        return number.find_first_not_of("-0123456789") != std::string::npos || number.empty();
    };
    if (x == std::string::npos || is_malformed(text.substr(0, x)) ||
        is_malformed(text.substr(x + 1)))
        throw Error(fmt::format("--size '{}' is not of the form WIDTHxHEIGHT, like 1280x720", text),
                    kBadInput);
    settings.set_text(kWidth.key(), text.substr(0, x));
    settings.set_text(kHeight.key(), text.substr(x + 1));
}

/// Defaults, then the technique, then the files in their order, then the command line.
Settings effective_settings(const RenderOptions& options) {
    Settings settings(all_knobs());
    if (!options.technique.empty())
        apply_technique(settings, options.technique);
    for (const fs::path& config : options.configs)
        settings.load_toml(config);
    if (!options.camera.empty())
        settings.set(kCamera, options.camera);
    if (!options.size.empty())
        set_size(settings, options.size);
    if (!options.frames.empty())
        settings.set_text(kFrames.key(), options.frames);
    if (!options.seed.empty())
        settings.set_text(kSeed.key(), options.seed);
    for (const std::string& assignment : options.assignments)
        settings.set_assignment(assignment);
    return settings;
}

/// What can be refused before any work is done.
void check_outputs(const RenderOptions& options, const Settings& settings) {
    const bool wants_reference = !options.reference_output.empty() || !options.error_map.empty();
    if (options.output.empty() && options.report.empty() && !options.table && !wants_reference)
        throw Error("nothing to do: give -o FILE, --report FILE or --table", kBadInput);
    for (const fs::path& picture : {options.output, options.reference_output, options.error_map})
        if (!picture.empty())
            check_image_extension(picture);
    if (wants_reference && !options.reference_samples)
        throw Error("--reference-output and --error-map need --reference N", kBadInput);
    if (options.reference_samples &&
        (*options.reference_samples < 1 || *options.reference_samples > kMaxReferenceSamples))
        throw Error(
            fmt::format("--reference takes 1 to {} samples per pixel", kMaxReferenceSamples),
            kBadInput);
    make_tracer(settings.get(kTracer)); // refuses a name there is not
    if (options.reference_samples && settings.get(kView) != PictureKind::ambient_occlusion)
        throw Error("--reference is ambient occlusion: it needs frame.view=ambient_occlusion",
                    kBadInput);
}

/// What a frame, the read-back and the encoder take per pixel on a software rasteriser, where all
/// of it is the program's memory. Measured at 8000x4000: 43 bytes, with a composed view 78.
constexpr double kBytesPerPixel = 45, kComposedBytesPerPixel = 80;

/// The system promises more memory than it has and ends who uses it; better refuse in time.
void check_memory(const Settings& settings) {
    std::ifstream facts("/proc/meminfo");
    std::string name, unit;
    double kibibytes = 0, available = 0;
    while (facts >> name >> kibibytes && std::getline(facts, unit))
        if (name == "MemAvailable:")
            available = kibibytes * 1024;
    const bool composed = settings.get(kView) != PictureKind::ambient_occlusion;
    const double needed = 1.0 * settings.get(kWidth) * settings.get(kHeight) *
                          (composed ? kComposedBytesPerPixel : kBytesPerPixel);
    if (available > 0 && needed > available)
        throw Error(fmt::format("a picture of {}x{} needs about {:.1f} GiB on this software "
                                "renderer, {:.1f} GiB are free: choose a smaller --size",
                                settings.get(kWidth), settings.get(kHeight), needed / (1 << 30),
                                available / (1 << 30)));
}

/// On one line of a terminal that is written over and over.
void show_progress(const char* what, double fraction) {
    fmt::print(stderr, "\r{} {:3.0f} %{}", what, 100.0 * fraction, fraction >= 1.0 ? "\n" : "");
    std::fflush(stderr);
}

/// Tells how far the frames are, on a terminal, where they take longer than one is glad to wait.
class FrameProgress {
public:
    explicit FrameProgress(int frames) : frames_(frames) {}
    void done(int frame) {
        const auto now = std::chrono::steady_clock::now();
        const bool last = frame == frames_;
        if (!terminal_ || (last ? !shown_ : now - told_ < std::chrono::seconds(1)))
            return;
        told_ = now;
        shown_ = true;
        show_progress("frames", static_cast<double>(frame) / frames_);
    }

private:
    const bool terminal_ = isatty(STDERR_FILENO);
    const int frames_;
    bool shown_ = false;
    std::chrono::steady_clock::time_point told_ = std::chrono::steady_clock::now();
};

/// What the frames show: the pose and the camera of each in turn, made anew only as time goes on.
class Showing {
public:
    Showing(const Scene& scene, const Settings& settings)
        : scene_(scene), settings_(settings), pose_(pose_of_frame(scene, settings, 0)),
          camera_(chosen_camera(scene, settings, pose_)) {}
    void go_to(int frame) {
        if (frame == 0 || settings_.get(kFps) == 0.0 || scene_.motion.empty())
            return;
        pose_ = pose_of_frame(scene_, settings_, frame);
        camera_ = chosen_camera(scene_, settings_, pose_);
    }
    const Pose& pose() const { return pose_; }
    const Camera& camera() const { return camera_; }

private:
    const Scene& scene_;
    const Settings& settings_;
    Pose pose_;
    Camera camera_;
};

AoReference compute_reference(const Scene& scene, const Camera& camera, const Settings& settings,
                              const RenderOptions& options) {
    AoQuery query;
    query.camera = camera;
    query.size = {settings.get(kWidth), settings.get(kHeight)};
    query.samples = *options.reference_samples;
    query.radius = ambient_occlusion_radius(settings);
    query.pixel_jitter = settings.get(kAntialias);
    // The truth does not follow the seed of what it judges.
    return ambient_occlusion_reference(
        scene, query,
        isatty(STDERR_FILENO) ? [](double fraction) { show_progress("reference", fraction); }
                              : std::function<void(double)>{},
        {.use_cache = !options.no_cache});
}

ReportErrors judge(const AoReference& truth, const Image& picture, int samples) {
    ReportErrors errors{samples, truth.seconds, truth.from_cache};
    errors.flip = metric_value(Metric::flip, truth.visibility, picture);
    errors.rmse = metric_value(Metric::rmse, truth.visibility, picture);
    errors.mae = metric_value(Metric::mae, truth.visibility, picture);
    errors.bias = metric_value(Metric::bias, truth.visibility, picture);
    return errors;
}

int render(const RenderOptions& options) {
    const Settings settings = effective_settings(options);
    if (options.print_config) {
        fmt::print("{}", settings.to_toml());
        return 0;
    }
    check_outputs(options, settings);
    const fs::path file = find_scene(options.scene);
    std::vector<fs::path> inputs = options.configs;
    inputs.push_back(file);
    check_output_files(
        {options.output, options.report, options.reference_output, options.error_map}, inputs);
    Scene scene = load_gltf(file);
    Showing showing(scene, settings);

    const std::unique_ptr<Context> context = options.backend.make_context();
    const DriverFacts driver = query_driver();
    if (driver.software)
        check_memory(settings);
    std::optional<DebugLog> log;
    if (options.backend.debug)
        log.emplace();
    Pipeline pipeline(scene,
                      options.shaders.empty() ? ShaderLibrary() : ShaderLibrary(options.shaders));
    FrameProgress progress(settings.get(kFrames));
    for (int frame = 0; frame < settings.get(kFrames); ++frame) {
        if (frame == 1)
            pipeline.timer().clear(); // the first frame compiled the shaders
        showing.go_to(frame);
        pipeline.set_pose(showing.pose());
        pipeline.render(settings, showing.camera());
        progress.done(frame + 1);
    }
    pipeline.timer().finish();
    const Image picture = pipeline.picture();
    check_gl_error("reading the picture");
    if (log && !log->messages().empty())
        throw Error(log->messages().front());

    const Camera camera = showing.camera();
    if (!scene.motion.empty())
        apply_pose(scene, showing.pose()); // what follows is about the last frame
    ReportFacts facts{options.technique, file.string(), &scene, &settings, camera};
    facts.backend = context->description();
    facts.driver = driver;
    facts.clock = pipeline.timer().clock();
    facts.timings = pipeline.timer().timings();
    facts.bytes = pipeline.bytes();
    if (options.reference_samples) {
        const AoReference truth = compute_reference(scene, camera, settings, options);
        facts.errors = judge(truth, picture, *options.reference_samples);
        if (!options.reference_output.empty())
            write_image(options.reference_output, truth.visibility);
        if (!options.error_map.empty())
            write_image(options.error_map,
                        metric_picture(Metric::flip, truth.visibility, picture).picture);
    }
    if (!options.output.empty())
        write_image(options.output, picture);
    if (!options.report.empty())
        write_file_atomically(options.report, report_json(facts));
    if (options.table)
        fmt::print("{}", report_table(facts));
    else if (facts.errors && options.report.empty())
        fmt::print("{}", error_table(*facts.errors)); // asked for, and nobody would be told
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
    command
        ->add_option("--technique", options->technique,
                     "methods and values by name, see 'romascope info --techniques'")
        ->type_name("NAME");
    // One value each time: another word after it is the scene.
    command->add_option("--config", options->configs, "TOML file of settings; may be repeated")
        ->type_name("FILE")
        ->allow_extra_args(false);
    command
        ->add_option("--set", options->assignments,
                     "a setting, see 'romascope info --knobs'; may be repeated")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command
        ->add_option("--camera", options->camera,
                     "a camera of the scene, or eye/target/vertical fov like 1,2,3/0,0,0/60")
        ->type_name("CAMERA");
    command->add_option("--size", options->size, "width and height in pixels, like 1280x720")
        ->type_name("WxH");
    command->add_option("--frames", options->frames, "frames to accumulate")->type_name("N");
    command->add_option("--seed", options->seed, "of every random choice")->type_name("N");
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
    command->add_flag("--no-cache", options->no_cache, "compute the reference anew");
    command->add_flag("--print-config", options->print_config,
                      "print the settings in effect as TOML and stop");
    command
        ->add_option("--shaders", options->shaders,
                     "read shaders from this folder instead of the program")
        ->check(CLI::ExistingDirectory);
    options->backend.add_to(*command);
    return [options] { return render(*options); };
}

} // namespace romascope
