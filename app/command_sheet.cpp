// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/common_options.h"
#include "app/contact_sheet.h"
#include "app/frame_run.h"
#include "app/output_files.h"
#include "app/scene_files.h"
#include "app/scene_options.h"
#include "app/settings_options.h"
#include "renderer/base/error.h"
#include "renderer/base/memory.h"
#include "renderer/frame/notices.h"
#include "renderer/image/image_io.h"
#include "renderer/scene/pose.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <new>

namespace romascope {
namespace {

namespace fs = std::filesystem;

struct SheetOptions {
    std::vector<std::string> scenes; ///< none: those that come with the program
    fs::path output;
    SettingsOptions settings;
    SceneOptions memory;
    int reference_samples = 64;
    int columns = 1;
    bool no_cache = false;
    BackendOptions backend;
};

/// Exit status where a scene was refused and the sheet was written all the same.
constexpr int kSomeRefused = 1;
constexpr int kMostColumns = 16;
constexpr size_t kTiles = 3; ///< of a scene

/// What a sheet shows of each scene, unless it is said otherwise.
Settings sheet_settings(const SheetOptions& options) {
    Settings settings(all_knobs());
    if (options.settings.technique.empty())
        apply_technique(settings, "roma");
    settings.set(kWidth, 480);
    settings.set(kHeight, 270);
    settings.set(kFrames, 16);
    return options.settings.apply_to(settings);
}

/// The settings of the tile that shows the scene itself.
Settings with_view(Settings settings) {
    if (settings.get(kView) == PictureKind::ambient_occlusion)
        settings.set(kView, PictureKind::lit);
    return settings;
}

Settings with_ambient_occlusion(Settings settings) {
    settings.set(kView, PictureKind::ambient_occlusion);
    return settings;
}

/// At rest many figures stand with their arms stretched out, and at the start of an animation, too.
void choose_time(Settings& settings, const Scene& scene) {
    const int animation = find_animation(scene, settings.get(kAnimation));
    if (animation >= 0 && settings.is_default(kTime) && settings.is_default(kFps))
        settings.set(kTime,
                     0.25 * scene.motion.animations[static_cast<size_t>(animation)].duration);
}

/// "lit view", "base color view".
std::string caption_of_view(const Settings& settings) {
    std::string name = to_text(with_view(settings).value(kView));
    std::ranges::replace(name, '_', ' ');
    return name + " view";
}

/// One scene's row.
struct Row {
    std::string label;
    std::vector<Image> tiles;
};

std::string label_of(const Scene& scene, const Settings& settings, const ReportErrors& errors) {
    std::string text = fmt::format("{}, {} triangles", scene.name, scene.triangle_count());
    if (!scene.motion.animations.empty())
        text += fmt::format(", {:.4g} s", settings.get(kTime));
    return text + fmt::format(": MAE {:.4f}, FLIP {:.3f}", errors.mae, errors.flip);
}

Row show(const fs::path& file, Settings settings, const SheetOptions& options, bool software) {
    Scene scene = options.memory.load(file);
    choose_time(settings, scene);
    const Settings view = with_view(settings);
    const Settings occlusion = with_ambient_occlusion(settings);
    if (software)
        check_memory(scene, view, options.memory.left_beside(scene),
                     options.memory.max_memory.has_value());
    Row row;
    Showing showing(scene, settings);
    {
        Pipeline pipeline(scene, ShaderLibrary());
        for (const std::string& notice : notices_of(settings, scene))
            tell_notice(file, notice);
        row.tiles.push_back(render_frames(pipeline, view, showing).picture);
        row.tiles.push_back(render_frames(pipeline, occlusion, showing).picture);
    }
    if (!scene.motion.empty())
        apply_pose(scene, showing.pose());
    const AoReference truth =
        truth_of(scene, showing.camera(), occlusion, options.reference_samples, !options.no_cache);
    row.tiles.push_back(truth.visibility);
    row.label = label_of(scene, settings, judge(truth, row.tiles[1], options.reference_samples));
    return row;
}

void check_options(const SheetOptions& options, const Settings& settings,
                   const std::vector<fs::path>& files) {
    check_image_extension(options.output);
    check_tracer(settings);
    check_reference(with_ambient_occlusion(settings), options.reference_samples);
    if (options.columns < 1 || options.columns > kMostColumns)
        throw Error(fmt::format("--columns takes 1 to {}", kMostColumns), kBadInput);
    std::vector<fs::path> inputs = options.settings.configs;
    inputs.insert(inputs.end(), files.begin(), files.end());
    check_output_files({options.output}, inputs);
    MemoryBudget(options.memory.limit())
        .take(ContactSheet::bytes_needed(files.size(), options.columns, settings.get(kWidth),
                                         settings.get(kHeight), kTiles),
              1, fmt::format("the sheet of {} scenes", files.size()));
}

std::vector<fs::path> files_of(const SheetOptions& options) {
    if (!options.scenes.empty())
        return find_scenes(options.scenes);
    std::vector<fs::path> files;
    for (const BuiltInScene& scene : built_in_scenes())
        files.push_back(scene.file);
    return files;
}

int make_sheet(const SheetOptions& options) {
    const Settings settings = sheet_settings(options);
    const std::vector<fs::path> files = files_of(options);
    check_options(options, settings, files);
    const std::unique_ptr<Context> context = options.backend.make_context();
    const bool software = query_driver().software;
    std::optional<DebugLog> log;
    if (options.backend.debug)
        log.emplace();
    ContactSheet sheet(files.size(), options.columns, settings.get(kWidth), settings.get(kHeight),
                       {caption_of_view(settings),
                        fmt::format("ambient occlusion: {}, {} frames", settings.get(kTracer),
                                    settings.get(kFrames)),
                        fmt::format("truth: {} samples per pixel", options.reference_samples)});
    int status = 0;
    for (const fs::path& file : files) {
        const auto refuse = [&](const std::string& why) {
            fmt::print(stderr, "romascope: {}\n", why);
            sheet.add(file.stem().string(), {}, why);
            status = kSomeRefused;
        };
        try {
            const Row row = show(file, settings, options, software);
            sheet.add(row.label, row.tiles);
            fmt::print("{}\n", row.label);
            std::fflush(stdout);
        } catch (const Error& error) {
            refuse(error.what());
        } catch (const std::bad_alloc&) {
            refuse(file.string() + ": out of memory");
        }
    }
    if (log && !log->messages().empty())
        throw Error(log->messages().front());
    write_image(options.output, sheet.picture());
    return status;
}

} // namespace

Command add_sheet_command(CLI::App& app) {
    auto options = std::make_shared<SheetOptions>();
    CLI::App* command = app.add_subcommand(
        "sheet", "A contact sheet: of each scene a view, its ambient occlusion and the truth");
    command
        ->add_option("SCENE", options->scenes,
                     ".gltf or .glb files, built-in scenes by name, or folders: all files below; "
                     "without any, all built-in scenes")
        ->type_name("...");
    command
        ->add_option("-o,--output", options->output,
                     "picture: .png (sRGB) or .hdr (linear floats); missing folders are made")
        ->type_name("FILE")
        ->required();
    options->settings.add_to(*command, "width and height of a tile in pixels; else 480x270",
                             "frames to accumulate; else 16");
    command->add_option("--reference", options->reference_samples, "samples per pixel of the truth")
        ->type_name("N")
        ->capture_default_str();
    command->add_option("--columns", options->columns, "scenes beside each other")
        ->type_name("N")
        ->capture_default_str();
    command->add_flag("--no-cache", options->no_cache, "compute the truth anew");
    options->memory.add_to(*command);
    options->backend.add_to(*command);
    return [options] { return make_sheet(*options); };
}

} // namespace romascope
