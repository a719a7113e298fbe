// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/common_options.h"
#include "app/scene_facts.h"
#include "app/scene_files.h"
#include "app/scene_options.h"
#include "renderer/base/error.h"
#include "renderer/frame/technique.h"
#include "renderer/gl/capabilities.h"
#include "renderer/scene/gltf/import.h"
#include "renderer/tracers/tracer.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <optional>

namespace romascope {
namespace {

struct InfoOptions {
    BackendOptions backend;
    SceneOptions memory;
    std::optional<std::string> scene; ///< none: the driver, or what a flag asks for
    bool json = false;
    bool knobs = false, techniques = false, tracers = false, scenes = false;
    bool lists() const { return knobs || techniques || tracers || scenes; }
};

void print_techniques() {
    for (const Technique& technique : techniques())
        fmt::print("{:<12} {}\n", technique.name, technique.description);
}

void print_tracers() {
    for (const TracerEntry& tracer : tracers())
        fmt::print("{:<12} {}\n", tracer.name, tracer.description);
}

void print_scenes(const SceneOptions& memory) {
    for (const BuiltInScene& built_in : built_in_scenes()) {
        const Scene scene = load_gltf(built_in.file, memory.limit());
        std::vector<std::string> cameras;
        for (const Camera& camera : scene.cameras)
            cameras.push_back(camera.name);
        const glm::vec3 size = scene.bounds.extent();
        fmt::print("{:<12} {:>8} triangles, {:.4g} x {:.4g} x {:.4g} m, cameras {}{}\n",
                   built_in.name, scene.triangle_count(), size.x, size.y, size.z,
                   fmt::join(cameras, ", "),
                   built_in.name == kDefaultScene ? " (the default scene)" : "");
    }
}

void print_scene(const InfoOptions& options) {
    const std::string file = find_scene(*options.scene).string();
    const Scene scene = load_gltf(file, options.memory.limit());
    fmt::print("{}", options.json ? scene_json(scene, file) : scene_text(scene, file));
}

void print_driver(const BackendOptions& options) {
    fmt::print("backends\n");
    for (const BackendState& state : probe_backends())
        fmt::print("  {:<28} {:<4} {}\n", state.name, state.usable ? "yes" : "no", state.detail);
    const std::unique_ptr<Context> context = options.make_context();
    const DriverFacts facts = query_driver();
    fmt::print("\nin use        {} (--backend {})\n", context->description(), options.backend);
    fmt::print("GL version    {}\n", facts.version);
    fmt::print("GLSL version  {}\n", facts.glsl);
    fmt::print("EGL version   {}\n",
               context->egl_version().empty() ? "not EGL" : context->egl_version());
    fmt::print("vendor        {}\n", facts.vendor);
    fmt::print("renderer      {}{}\n\n", facts.renderer, facts.software ? " (software)" : "");
    for (const Capability& capability : facts.capabilities)
        fmt::print("  {:<32} {:<18} {}\n", capability.name, capability.value, capability.use);
}

int info(const InfoOptions& options) {
    if (options.scene && options.lists())
        throw Error("give a scene or a list like --knobs, not both", kBadInput);
    if (options.json && !options.scene)
        throw Error("--json tells of a scene: give one", kBadInput);
    if (options.knobs)
        fmt::print("{}", knobs_as_text(all_knobs()));
    if (options.techniques)
        print_techniques();
    if (options.tracers)
        print_tracers();
    if (options.scenes)
        print_scenes(options.memory);
    if (options.scene)
        print_scene(options);
    else if (!options.lists())
        print_driver(options.backend);
    return 0;
}

} // namespace

Command add_info_command(CLI::App& app) {
    auto options = std::make_shared<InfoOptions>();
    CLI::App* command = app.add_subcommand(
        "info", "What a scene is made of; or the driver, knobs, techniques, scenes");
    command
        ->add_option("SCENE", options->scene,
                     "a .gltf or .glb file, or a built-in scene by name; without one the driver")
        ->type_name("");
    command->add_flag("--json", options->json, "what a scene is made of as JSON, in full");
    command->add_flag("--knobs", options->knobs, "every setting: range, default, meaning, source");
    command->add_flag("--techniques", options->techniques, "named choices of methods and values");
    command->add_flag("--tracers", options->tracers, "visibility structures, for technique.tracer");
    command->add_flag("--scenes", options->scenes, "scenes that come with the program");
    options->memory.add_to(*command);
    options->backend.add_to(*command);
    return [options] { return info(*options); };
}

} // namespace romascope
