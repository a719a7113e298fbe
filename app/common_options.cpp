// SPDX-License-Identifier: MIT
#include "app/common_options.h"

#include "renderer/base/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace romascope {

void BackendOptions::add_to(CLI::App& command) {
    command.add_option("--backend", backend, "auto, window, egl or osmesa")
        ->type_name("NAME")
        ->capture_default_str()
        ->check([](const std::string& name) {
            backend_from_name(name); // throws before any work is done
            return std::string();
        });
    command
        .add_option("--egl-device", egl_device,
                    "EGL device by the number that 'romascope info' lists")
        ->type_name("N");
    command.add_flag("--gl-debug", debug, "ask for a debug context; its messages are errors");
    command.add_flag("--verbose", verbose, "tell which backend was taken, and why");
}

void add_shader_folder(CLI::App& command, std::filesystem::path& folder, const std::string& help) {
    command.add_option("--shaders", folder, help)
        ->type_name("FOLDER")
        ->check([](const std::string& name) {
            std::error_code code;
            if (!std::filesystem::is_directory(name, code))
                throw Error(fmt::format("--shaders: there is no folder '{}'", name), kBadInput);
            return std::string();
        });
}

std::unique_ptr<Context> BackendOptions::make_context() const {
    ContextRequest request;
    request.backend = backend_from_name(backend);
    request.egl_device = egl_device;
    request.debug = debug;
    std::string story;
    std::unique_ptr<Context> context = create_context(request, &story);
    if (verbose)
        fmt::print(stderr, "romascope: {}\n", story);
    return context;
}

} // namespace romascope
