// SPDX-License-Identifier: MIT
#include "renderer/gl/context.h"

#include "renderer/base/error.h"
#include "renderer/gl/context_backends.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <cstdlib>
#include <functional>

namespace romascope {
namespace {

std::string gl_string(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text ? reinterpret_cast<const char*>(text) : "";
}

std::string renderer_line() {
    return fmt::format("OpenGL {}, {}", gl_string(GL_VERSION), gl_string(GL_RENDERER));
}

/// A way to get a context, in the order in which `automatic` tries them.
struct Candidate {
    std::string name;
    std::function<std::unique_ptr<Context>(bool debug)> make;
};

bool has_display() {
    const auto set = [](const char* name) {
        const char* value = std::getenv(name);
        return value && *value;
    };
    return set("DISPLAY") || set("WAYLAND_DISPLAY");
}

void add_egl(std::vector<Candidate>& list, std::vector<std::string>& refusals) {
    std::vector<EglDevice> devices;
    try {
        devices = list_egl_devices();
    } catch (const Error& error) {
        refusals.push_back(fmt::format("egl: {}", error.what()));
        return;
    }
    const auto add_devices = [&](bool software) {
        for (size_t i = 0; i < devices.size(); ++i)
            if (devices[i].software == software)
                list.push_back(
                    {fmt::format("egl device {} ({})", i, devices[i].label),
                     [i](bool debug) { return create_egl_context(static_cast<int>(i), debug); }});
    };
    const size_t before = list.size();
    add_devices(false);
    if (list.size() == before)
        refusals.push_back("egl: no hardware device");
    list.push_back(
        {"egl surfaceless", [](bool debug) { return create_egl_context(std::nullopt, debug); }});
    add_devices(true);
}

std::unique_ptr<Context> first_that_works(const std::vector<Candidate>& candidates,
                                          std::vector<std::string> refusals, bool debug,
                                          std::string* story) {
    for (const Candidate& candidate : candidates) {
        try {
            std::unique_ptr<Context> context = candidate.make(debug);
            require_version();
            if (story) {
                if (!GLAD_GL_VERSION_4_6)
                    refusals.push_back("OpenGL 4.6: this driver offers less");
                for (const Candidate* next = &candidate + 1;
                     next < candidates.data() + candidates.size(); ++next)
                    refusals.push_back(next->name + ": not needed");
                *story = fmt::format(
                    "using {}: {}{}", context->description(), renderer_line(),
                    refusals.empty() ? "" : fmt::format(" ({})", fmt::join(refusals, "; ")));
            }
            return context;
        } catch (const Error& error) {
            refusals.push_back(fmt::format("{}: {}", candidate.name, error.what()));
        }
    }
    throw Error(fmt::format("no OpenGL 4.5 context can be made: {}", fmt::join(refusals, "; ")));
}

std::unique_ptr<Context> context_of_device(int index, bool debug, std::string* story) {
    const std::vector<EglDevice> devices = list_egl_devices();
    if (index < 0 || index >= static_cast<int>(devices.size()))
        throw Error(fmt::format("there is no EGL device {}: this machine has {} (see 'romascope "
                                "info')",
                                index, devices.size()),
                    kBadInput);
    std::unique_ptr<Context> context = create_egl_context(index, debug);
    require_version();
    const std::string renderer = gl_string(GL_RENDERER);
    if (is_software_renderer(renderer) && !devices[static_cast<size_t>(index)].software)
        throw Error(
            fmt::format("EGL device {} ({}) was asked for, but its driver gave the software "
                        "renderer {}: is the vendor's library installed?",
                        index, devices[static_cast<size_t>(index)].label, renderer));
    if (story)
        *story = fmt::format("using {}, as asked: {}", context->description(), renderer_line());
    return context;
}

} // namespace

void require_version() {
    if (GLAD_GL_VERSION_4_5)
        return;
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    std::vector<std::string> missing = {"ARB_compute_shader",
                                        "ARB_shader_image_load_store",
                                        "ARB_shader_storage_buffer_object",
                                        "ARB_framebuffer_no_attachments",
                                        "ARB_buffer_storage",
                                        "ARB_clip_control",
                                        "ARB_direct_state_access"};
    for (GLint i = 0; i < count; ++i) {
        const GLubyte* extension = glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
        std::erase(missing, reinterpret_cast<const char*>(extension) + 3);
    }
    throw Error(
        fmt::format("OpenGL 4.5 core is needed, the driver offers {}{}", renderer_line(),
                    missing.empty() ? "" : fmt::format(" and lacks {}", fmt::join(missing, ", "))));
}

const std::vector<std::string>& backend_names() {
    static const std::vector<std::string> names = {"auto", "window", "egl", "osmesa"};
    return names;
}

std::string_view name_of(Backend backend) { return backend_names()[static_cast<size_t>(backend)]; }

Backend backend_from_name(std::string_view name) {
    const auto& names = backend_names();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
        throw Error(
            fmt::format("unknown backend '{}': choose one of {}", name, fmt::join(names, ", ")),
            kBadInput);
    return static_cast<Backend>(found - names.begin());
}

bool is_software_renderer(std::string_view renderer) {
    for (const char* name : {"llvmpipe", "softpipe", "swrast", "SWR", "Software Rasterizer"})
        if (renderer.find(name) != std::string_view::npos)
            return true;
    return false;
}

std::string_view current_renderer() {
    const GLubyte* text = glGetString(GL_RENDERER);
    return text ? reinterpret_cast<const char*>(text) : "";
}

std::unique_ptr<Context> create_context(const ContextRequest& request, std::string* story) {
    if (request.egl_device) {
        if (request.backend != Backend::automatic && request.backend != Backend::egl)
            throw Error(fmt::format("--egl-device needs the egl backend, not '{}'",
                                    name_of(request.backend)),
                        kBadInput);
        return context_of_device(*request.egl_device, request.debug, story);
    }
    std::vector<Candidate> candidates;
    std::vector<std::string> refusals;
    const bool automatic = request.backend == Backend::automatic;
    if (request.backend == Backend::window || (automatic && has_display()))
        candidates.push_back({"window", create_window_context});
    else if (automatic)
        refusals.emplace_back("window: neither DISPLAY nor WAYLAND_DISPLAY is set");
    if (request.backend == Backend::egl || automatic)
        add_egl(candidates, refusals);
    if (request.backend == Backend::osmesa || automatic)
        candidates.push_back({"osmesa", create_osmesa_context});
    return first_that_works(candidates, std::move(refusals), request.debug, story);
}

std::vector<BackendState> probe_backends() {
    std::vector<Candidate> candidates;
    std::vector<std::string> refusals;
    std::vector<BackendState> states;
    if (has_display())
        candidates.push_back({"window", create_window_context});
    else
        states.push_back({"window", false, "neither DISPLAY nor WAYLAND_DISPLAY is set"});
    add_egl(candidates, refusals);
    if (!refusals.empty())
        states.push_back({"egl", false, refusals.front()});
    candidates.push_back({"osmesa", create_osmesa_context});
    for (const Candidate& candidate : candidates) {
        try {
            const std::unique_ptr<Context> context = candidate.make(false);
            require_version();
            states.push_back({candidate.name, true, renderer_line()});
        } catch (const Error& error) {
            states.push_back({candidate.name, false, error.what()});
        }
    }
    return states;
}

} // namespace romascope
