// SPDX-License-Identifier: MIT
#include "renderer/base/error.h"
#include "renderer/gl/context_backends.h"

#include <glad/egl.h>
#include <glad/gl.h>

#include <fmt/format.h>

#include <dlfcn.h>

#include <string_view>

namespace romascope {
namespace {

/// EGL's entry points, from the library found at run time.
struct Egl {
    PFNEGLGETPROCADDRESSPROC get_proc_address = nullptr;
    PFNEGLQUERYSTRINGPROC query_string = nullptr;
    PFNEGLGETERRORPROC get_error = nullptr;
    PFNEGLINITIALIZEPROC initialize = nullptr;
    PFNEGLTERMINATEPROC terminate = nullptr;
    PFNEGLBINDAPIPROC bind_api = nullptr;
    PFNEGLCHOOSECONFIGPROC choose_config = nullptr;
    PFNEGLCREATECONTEXTPROC create_context = nullptr;
    PFNEGLDESTROYCONTEXTPROC destroy_context = nullptr;
    PFNEGLMAKECURRENTPROC make_current = nullptr;
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display = nullptr;
    PFNEGLQUERYDEVICESEXTPROC query_devices = nullptr;            ///< may be missing
    PFNEGLQUERYDEVICESTRINGEXTPROC query_device_string = nullptr; ///< may be missing

    bool client_extension(std::string_view name) const {
        return contains(query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS), name);
    }
    static bool contains(const char* list, std::string_view name) {
        return list &&
               fmt::format(" {} ", list).find(fmt::format(" {} ", name)) != std::string::npos;
    }
};

Egl load_egl() {
    void* handle = nullptr;
    for (const char* name : {"libEGL.so.1", "libEGL.so"}) {
        handle = dlopen(name, RTLD_NOW | RTLD_LOCAL); // never closed: drivers leave threads behind
        if (handle)
            break;
    }
    if (!handle)
        throw Error("libEGL.so.1 is not installed (Debian: libegl1)");
    Egl egl;
    egl.get_proc_address =
        reinterpret_cast<PFNEGLGETPROCADDRESSPROC>(dlsym(handle, "eglGetProcAddress"));
    if (!egl.get_proc_address)
        throw Error("libEGL lacks eglGetProcAddress");
    const auto load = [&]<class Function>(const char* name, Function& function, bool needed) {
        void* symbol = dlsym(handle, name);
        function = symbol ? reinterpret_cast<Function>(symbol)
                          : reinterpret_cast<Function>(egl.get_proc_address(name));
        if (!function && needed)
            throw Error(fmt::format("libEGL lacks {}", name));
    };
    load("eglQueryString", egl.query_string, true);
    load("eglGetError", egl.get_error, true);
    load("eglInitialize", egl.initialize, true);
    load("eglTerminate", egl.terminate, true);
    load("eglBindAPI", egl.bind_api, true);
    load("eglChooseConfig", egl.choose_config, true);
    load("eglCreateContext", egl.create_context, true);
    load("eglDestroyContext", egl.destroy_context, true);
    load("eglMakeCurrent", egl.make_current, true);
    load("eglGetPlatformDisplayEXT", egl.get_platform_display, true);
    load("eglQueryDevicesEXT", egl.query_devices, false);
    load("eglQueryDeviceStringEXT", egl.query_device_string, false);
    return egl;
}

const Egl& egl_library() {
    static const Egl egl = load_egl();
    return egl;
}

std::vector<EGLDeviceEXT> device_handles(const Egl& egl) {
    const bool enumerates = egl.client_extension("EGL_EXT_device_base") ||
                            egl.client_extension("EGL_EXT_device_enumeration");
    if (!enumerates || !egl.query_devices)
        return {};
    EGLint count = 0;
    if (!egl.query_devices(0, nullptr, &count) || count <= 0)
        return {};
    std::vector<EGLDeviceEXT> devices(static_cast<size_t>(count));
    egl.query_devices(count, devices.data(), &count);
    devices.resize(static_cast<size_t>(count));
    return devices;
}

EglDevice describe(const Egl& egl, EGLDeviceEXT handle) {
    EglDevice device;
    if (!egl.query_device_string)
        return {"unnamed", false};
    const char* extensions = egl.query_device_string(handle, EGL_EXTENSIONS);
    device.software = Egl::contains(extensions, "EGL_MESA_device_software");
    const char* file = Egl::contains(extensions, "EGL_EXT_device_drm")
                           ? egl.query_device_string(handle, EGL_DRM_DEVICE_FILE_EXT)
                           : nullptr;
    device.label = device.software ? "software" : file ? file : "no DRM file";
    return device;
}

class EglContext final : public Context {
public:
    EglContext(std::optional<int> device, bool debug) : egl_(egl_library()) {
        open_display(device);
        EGLint major = 0, minor = 0;
        if (!egl_.initialize(display_, &major, &minor))
            throw Error(fmt::format("eglInitialize fails ({:#x})", egl_.get_error()));
        const char* version = egl_.query_string(display_, EGL_VERSION);
        version_ = version ? version : fmt::format("{}.{}", major, minor);
        try {
            make_context(debug);
        } catch (...) {
            egl_.terminate(display_);
            throw;
        }
    }
    ~EglContext() override {
        egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        egl_.destroy_context(display_, context_);
        egl_.terminate(display_);
    }

    Backend backend() const override { return Backend::egl; }
    std::string description() const override { return description_; }
    std::string egl_version() const override { return version_; }

private:
    void open_display(std::optional<int> device) {
        if (device) {
            const auto handles = device_handles(egl_);
            EGLDeviceEXT handle = handles.at(static_cast<size_t>(*device));
            display_ = egl_.get_platform_display(EGL_PLATFORM_DEVICE_EXT, handle, nullptr);
            description_ = fmt::format("EGL device {} ({})", *device, describe(egl_, handle).label);
        } else {
            if (!egl_.client_extension("EGL_MESA_platform_surfaceless"))
                throw Error("EGL_MESA_platform_surfaceless is missing");
            display_ = egl_.get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
            description_ = "EGL surfaceless";
        }
        if (display_ == EGL_NO_DISPLAY)
            throw Error(fmt::format("no EGL display ({:#x})", egl_.get_error()));
    }

    void make_context(bool debug) {
        const char* extensions = egl_.query_string(display_, EGL_EXTENSIONS);
        if (!Egl::contains(extensions, "EGL_KHR_surfaceless_context"))
            throw Error("EGL_KHR_surfaceless_context is missing");
        if (!egl_.bind_api(EGL_OPENGL_API))
            throw Error("this EGL offers no desktop OpenGL");
        EGLConfig config = nullptr; // EGL_NO_CONFIG_KHR
        if (!Egl::contains(extensions, "EGL_KHR_no_config_context")) {
            const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                     EGL_NONE};
            EGLint count = 0;
            if (!egl_.choose_config(display_, wanted, &config, 1, &count) || count == 0)
                throw Error("no EGL configuration renders desktop OpenGL");
        }
        for (const auto& [major, minor] : kGlVersions) {
            const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                         major,
                                         EGL_CONTEXT_MINOR_VERSION,
                                         minor,
                                         EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                         EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                         EGL_CONTEXT_OPENGL_DEBUG,
                                         debug ? EGL_TRUE : EGL_FALSE,
                                         EGL_NONE};
            context_ = egl_.create_context(display_, config, EGL_NO_CONTEXT, attributes);
            if (context_ != EGL_NO_CONTEXT)
                break;
        }
        if (context_ == EGL_NO_CONTEXT)
            throw Error(
                fmt::format("it gives no OpenGL 4.5 core context ({:#x})", egl_.get_error()));
        const auto fail = [&](const char* why) {
            egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            egl_.destroy_context(display_, context_);
            throw Error(why);
        };
        if (!egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
            fail("its context cannot be made current without a surface");
        if (!gladLoadGL([](const char* name) { return egl_library().get_proc_address(name); }))
            fail("the OpenGL functions cannot be loaded");
    }

    const Egl& egl_;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
    std::string description_;
    std::string version_;
};

} // namespace

std::vector<EglDevice> list_egl_devices() {
    const Egl& egl = egl_library();
    std::vector<EglDevice> devices;
    for (EGLDeviceEXT handle : device_handles(egl))
        devices.push_back(describe(egl, handle));
    return devices;
}

std::unique_ptr<Context> create_egl_context(std::optional<int> device, bool debug) {
    return std::make_unique<EglContext>(device, debug);
}

} // namespace romascope
