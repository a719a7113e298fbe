// SPDX-License-Identifier: MIT
// Options that several commands share.
#pragma once

#include "renderer/gl/context.h"

#include <memory>
#include <string>

namespace CLI {
class App;
}

namespace romascope {

/// --backend, --egl-device, --gl-debug, --verbose.
struct BackendOptions {
    std::string backend = "auto";
    int egl_device = -1; ///< below 0: not asked for
    bool debug = false;
    bool verbose = false;

    void add_to(CLI::App& command);
    /// Makes the context; with --verbose tells on stderr what was taken and why.
    std::unique_ptr<Context> make_context() const;
};

} // namespace romascope
