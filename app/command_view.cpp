// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/common_options.h"
#include "app/frame_run.h"
#include "app/scene_files.h"
#include "app/settings_options.h"
#include "app/viewer/start_settings.h"
#include "app/viewer/viewer.h"
#include "renderer/base/error.h"
#include "renderer/scene/gltf/import.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace romascope {
namespace {

namespace fs = std::filesystem;

struct ViewOptions {
    std::string scene = kDefaultScene;
    SettingsOptions settings;
    ViewerOptions viewer;
    bool no_panel = false;
    bool defaults = false;
};

int view(const ViewOptions& options) {
    Settings settings(all_knobs());
    settings.set(kFrames, kFramesToRest);
    if (!options.defaults && load_start_settings(settings))
        fmt::print(stderr, "notice: starting with the settings of {}\n",
                   start_settings_file().string());
    settings = options.settings.apply_to(settings);
    check_tracer(settings);
    const fs::path file = find_scene(options.scene);
    Scene scene = load_gltf(file, options.viewer.memory.limit());
    const Showing names_are_known(scene, settings); // before there is a window

    ViewerOptions viewer_options = options.viewer;
    viewer_options.panel = !options.no_panel;
    viewer_options.exact_size = !options.settings.size.empty() || !settings.is_default(kWidth) ||
                                !settings.is_default(kHeight);
    viewer_options.technique = options.settings.technique;
    Viewer viewer(viewer_options, settings, file, std::move(scene));
    viewer.run();
    return 0;
}

} // namespace

Command add_view_command(CLI::App& app) {
    auto options = std::make_shared<ViewOptions>();
    CLI::App* command =
        app.add_subcommand("view", "Look at a scene in a window and turn every knob; F1 helps");
    command
        ->add_option("SCENE", options->scene, "a .gltf or .glb file, or a built-in scene by name")
        ->type_name("")
        ->capture_default_str();
    options->settings.add_to(
        *command, "size of the window in pixels, like 1280x720",
        fmt::format("frames after which the picture rests; else {}", kFramesToRest));
    add_shader_folder(*command, options->viewer.shaders,
                      "read shaders from this folder, and again whenever they change");
    command
        ->add_option("--screenshots", options->viewer.screenshots,
                     "folder for screenshots; else romascope/ in your pictures")
        ->type_name("FOLDER");
    command->add_flag("--no-panel", options->no_panel,
                      "start with the picture alone; Tab shows more");
    command->add_flag("--defaults", options->defaults, "pass over the settings you had it keep");
    command
        ->add_option("--ui-map", options->viewer.ui_map,
                     "for tests: keep telling in this file where the widgets are, as JSON")
        ->type_name("FILE");
    command->add_flag("--gl-debug", options->viewer.gl_debug, "show the driver's debug messages");
    options->viewer.memory.add_to(*command);
    return [options] { return view(*options); };
}

} // namespace romascope
