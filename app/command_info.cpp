// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/common_options.h"
#include "app/scene_files.h"
#include "renderer/frame/technique.h"
#include "renderer/gl/capabilities.h"
#include "renderer/scene/gltf/import.h"
#include "renderer/tracers/tracer.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace romascope {
namespace {

struct InfoOptions {
    BackendOptions backend;
    bool knobs = false, techniques = false, tracers = false, scenes = false;
};

void print_techniques() {
    for (const Technique& technique : techniques())
        fmt::print("{:<12} {}\n", technique.name, technique.description);
}

void print_tracers() {
    for (const TracerEntry& tracer : tracers())
        fmt::print("{:<12} {}\n", tracer.name, tracer.description);
}

void print_scenes() {
    for (const BuiltInScene& built_in : built_in_scenes()) {
        const Scene scene = load_gltf(built_in.file);
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
    if (options.knobs)
        fmt::print("{}", knobs_as_text(all_knobs()));
    if (options.techniques)
        print_techniques();
    if (options.tracers)
        print_tracers();
    if (options.scenes)
        print_scenes();
    if (!options.knobs && !options.techniques && !options.tracers && !options.scenes)
        print_driver(options.backend);
    return 0;
}

} // namespace

Command add_info_command(CLI::App& app) {
    auto options = std::make_shared<InfoOptions>();
    CLI::App* command =
        app.add_subcommand("info", "The driver and what it can do; knobs, techniques, scenes");
    command->add_flag("--knobs", options->knobs, "every setting: range, default, meaning, source");
    command->add_flag("--techniques", options->techniques, "named choices of methods and values");
    command->add_flag("--tracers", options->tracers, "visibility structures, for technique.tracer");
    command->add_flag("--scenes", options->scenes, "scenes that come with the program");
    options->backend.add_to(*command);
    return [options] { return info(*options); };
}

} // namespace romascope
