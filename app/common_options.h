// SPDX-License-Identifier: MIT
// Options that several commands share.
#pragma once

#include "renderer/gl/context.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace romascope {

/// --backend, --egl-device, --gl-debug, --verbose.
struct BackendOptions {
    std::string backend = "auto";
    std::optional<int> egl_device;
#ifdef NDEBUG
    bool debug = false;
#else
    bool debug = true; ///< GL errors by name wherever speed does not count
#endif
    bool verbose = false;

    void add_to(CLI::App& command);
    /// Makes the context; with --verbose tells on stderr what was taken and why.
    std::unique_ptr<Context> make_context() const;
};

/// --shaders FOLDER; refuses, as the command line is read, what is no folder.
void add_shader_folder(CLI::App& command, std::filesystem::path& folder, const std::string& help);

} // namespace romascope
