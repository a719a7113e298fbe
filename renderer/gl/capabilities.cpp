// SPDX-License-Identifier: MIT
#include "renderer/gl/capabilities.h"

#include "renderer/gl/context.h"
#include "renderer/gl/timer.h"

#include <fmt/format.h>
#include <glad/gl.h>

namespace romascope {
namespace {

std::string text_of(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text ? reinterpret_cast<const char*>(text) : "";
}

std::string limit(GLenum name, const char* unit) {
    GLint64 value = 0;
    glGetInteger64v(name, &value);
    return fmt::format("{}{}{}", value, *unit ? " " : "", unit);
}

const char* yes_no(int has) { return has ? "yes" : "no"; }

} // namespace

DriverFacts query_driver() {
    DriverFacts facts{text_of(GL_VERSION), text_of(GL_SHADING_LANGUAGE_VERSION), text_of(GL_VENDOR),
                      text_of(GL_RENDERER)};
    facts.software = is_software_context();
    GLint timestamp_bits = 0;
    glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &timestamp_bits);
    GLint flags = 0;
    glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    facts.capabilities = {
        {"OpenGL 4.5 core", yes_no(GLAD_GL_VERSION_4_5), "needed"},
        {"OpenGL 4.6 core", yes_no(GLAD_GL_VERSION_4_6), "taken where it is offered"},
        {"debug output", "yes",
         flags & GL_CONTEXT_FLAG_DEBUG_BIT ? "GL errors by name (on)"
                                           : "GL errors by name (with --gl-debug)"},
        {"timestamps",
         timestamp_bits ? fmt::format("yes, {} bits", timestamp_bits) : std::string("no"),
         fmt::format("pass times (here: {})", name_of(PassTimer().clock()))},
        {"conservative rasterisation",
         yes_no(GLAD_GL_NV_conservative_raster || GLAD_GL_INTEL_conservative_rasterization),
         "occupancy map without holes (not used yet)"},
        {"fragment shader interlock", yes_no(GLAD_GL_ARB_fragment_shader_interlock),
         "ordered image writes (not used yet)"},
        {"subgroups", yes_no(GLAD_GL_KHR_shader_subgroup), "faster transposes (not used yet)"},
        {"64-bit integers", yes_no(GLAD_GL_ARB_gpu_shader_int64),
         "wider bit operations (not used yet)"},
        {"64-bit atomics", yes_no(GLAD_GL_NV_shader_atomic_int64),
         "wider hash cells (not used yet)"},
        {"shader storage block", limit(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, "bytes"),
         "largest buffer of a structure"},
        {"3D texture side", limit(GL_MAX_3D_TEXTURE_SIZE, "texels"), "occupancy map"},
        {"array texture layers", limit(GL_MAX_ARRAY_TEXTURE_LAYERS, ""), "aligned maps"},
        {"2D texture side", limit(GL_MAX_TEXTURE_SIZE, "texels"), "picture size"},
        {"viewport side", limit(GL_MAX_VIEWPORT_DIMS, "pixels"), "picture size"},
        {"compute shared memory", limit(GL_MAX_COMPUTE_SHARED_MEMORY_SIZE, "bytes"),
         "tiles of a work group"},
        {"compute invocations per group", limit(GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS, ""),
         "work group size"},
    };
    return facts;
}

} // namespace romascope
