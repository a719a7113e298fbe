// SPDX-License-Identifier: MIT
#include "renderer/base/error.h"
#include "renderer/gl/context_backends.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <dlfcn.h>

#include <array>
#include <cstdint>

namespace romascope {
namespace {

// From the OSMesa interface (GL/osmesa.h of Mesa); the library is looked for at run time only.
using OsmesaContext = void*;
using OsmesaProc = void (*)();
constexpr int kOsmesaFormat = 0x22;
constexpr int kOsmesaDepthBits = 0x30;
constexpr int kOsmesaProfile = 0x33;
constexpr int kOsmesaCoreProfile = 0x34;
constexpr int kOsmesaMajorVersion = 0x36;
constexpr int kOsmesaMinorVersion = 0x37;

class OsmesaLibrary {
public:
    OsmesaLibrary() {
        for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
            handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
            if (handle_)
                break;
        }
        if (!handle_)
            throw Error("libOSMesa.so.8 is not installed (Debian: libosmesa6)");
        load("OSMesaCreateContextAttribs", create_context);
        load("OSMesaMakeCurrent", make_current);
        load("OSMesaDestroyContext", destroy_context);
        load("OSMesaGetProcAddress", get_proc_address);
    }
    // The library stays loaded: Mesa leaves threads and exit handlers behind.

    OsmesaContext (*create_context)(const int* attributes, OsmesaContext share) = nullptr;
    unsigned char (*make_current)(OsmesaContext, void* buffer, GLenum type, int width,
                                  int height) = nullptr;
    void (*destroy_context)(OsmesaContext) = nullptr;
    OsmesaProc (*get_proc_address)(const char* name) = nullptr;

private:
    template <class Function>
    void load(const char* name, Function& function) {
        function = reinterpret_cast<Function>(dlsym(handle_, name));
        if (!function)
            throw Error(fmt::format("libOSMesa lacks {}", name));
    }
    void* handle_ = nullptr;
};

class OsmesaContextOwner final : public Context {
public:
    explicit OsmesaContextOwner() {
        // OSMesa knows no debug flag for contexts; KHR_debug works on a plain one.
        for (const auto& [major, minor] : kGlVersions) {
            const int attributes[] = {kOsmesaFormat,
                                      GL_RGBA,
                                      kOsmesaDepthBits,
                                      0,
                                      kOsmesaProfile,
                                      kOsmesaCoreProfile,
                                      kOsmesaMajorVersion,
                                      major,
                                      kOsmesaMinorVersion,
                                      minor,
                                      0,
                                      0};
            context_ = library_.create_context(attributes, nullptr);
            if (context_)
                break;
        }
        if (!context_)
            throw Error("OSMesa gives no OpenGL 4.5 core context");
        if (!library_.make_current(context_, pixels_.data(), GL_UNSIGNED_BYTE, kSide, kSide)) {
            library_.destroy_context(context_);
            throw Error("OSMesa's context cannot be made current");
        }
        static const OsmesaLibrary* loader = nullptr;
        loader = &library_;
        if (!gladLoadGL([](const char* name) { return loader->get_proc_address(name); })) {
            library_.destroy_context(context_);
            throw Error("the OpenGL functions cannot be loaded from OSMesa");
        }
    }
    ~OsmesaContextOwner() override { library_.destroy_context(context_); }

    Backend backend() const override { return Backend::osmesa; }
    std::string description() const override { return "OSMesa"; }

private:
    static constexpr int kSide = 4;
    OsmesaLibrary library_;
    OsmesaContext context_ = nullptr;
    std::array<uint8_t, kSide * kSide * 4> pixels_{}; ///< OSMesa wants a buffer; nothing draws here
};

} // namespace

std::unique_ptr<Context> create_osmesa_context(bool) {
    return std::make_unique<OsmesaContextOwner>();
}

} // namespace romascope
