// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace romascope {

enum class Backend { automatic, window, egl, osmesa };

/// "auto", "window", "egl", "osmesa", in the order of the enumerators.
const std::vector<std::string>& backend_names();
std::string_view name_of(Backend backend);
/// Throws Error (kBadInput) that lists the names.
Backend backend_from_name(std::string_view name);

struct ContextRequest {
    Backend backend = Backend::automatic;
    /// Index into the EGL devices that `romascope info` lists; implies EGL.
    std::optional<int> egl_device;
    /// GL debug output. On by default in debug builds and wherever a test asks.
    bool debug = false;
};

/// A current OpenGL core context of version 4.5 or later, without any surface to draw to: every
/// picture goes to a framebuffer object. One exists at a time; the thread that made it uses it.
class Context {
public:
    virtual ~Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    virtual Backend backend() const = 0;
    /// How the context came to be, e.g. "EGL device 0 (/dev/dri/card0)".
    virtual std::string description() const = 0;
    /// E.g. "1.5 Mesa Project"; empty where the backend is not EGL.
    virtual std::string egl_version() const { return {}; }

protected:
    Context() = default;
};

/// Makes a context and makes it current; loads the GL functions.
///
/// `automatic` takes the window system where a display is set in the environment, then EGL (first
/// hardware devices, then surfaceless or a software device), then OSMesa. `story`, if given,
/// receives one line that tells what was taken and why nothing before it was.
///
/// Throws Error if none works or the version is below 4.5, naming what each lacks, and Error
/// (kBadInput) for a device that does not exist. If a device was asked for by its number and that
/// device is not a software renderer, a software renderer is an error.
std::unique_ptr<Context> create_context(const ContextRequest& request,
                                        std::string* story = nullptr);

/// Throws Error if the current context is older than 4.5, naming what it lacks.
void require_version();

/// What a backend offers, found by trying it.
struct BackendState {
    std::string name; ///< e.g. "egl device 1"
    bool usable = false;
    std::string detail; ///< renderer and version, or the reason why it cannot be used
};

/// Tries every backend and every EGL device in turn, one context at a time. No context may be
/// current.
std::vector<BackendState> probe_backends();

/// True for the renderer strings of llvmpipe, softpipe and other CPU rasterisers.
bool is_software_renderer(std::string_view renderer);

/// GL_RENDERER of the current context; empty if the driver gives none.
std::string_view current_renderer();

/// Whether the current context renders on the CPU.
inline bool is_software_context() { return is_software_renderer(current_renderer()); }

} // namespace romascope
