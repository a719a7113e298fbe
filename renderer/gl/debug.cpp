// SPDX-License-Identifier: MIT
#include "renderer/gl/debug.h"

#include "renderer/base/error.h"

#include <fmt/format.h>
#include <glad/gl.h>

namespace romascope {

struct DebugLogAccess {
    static void GLAD_API_PTR receive(GLenum, GLenum type, GLuint id, GLenum severity, GLsizei,
                                     const GLchar* text, const void* log) {
        if (severity != GL_DEBUG_SEVERITY_HIGH && severity != GL_DEBUG_SEVERITY_MEDIUM)
            return;
        // NVIDIA: 131185 tells where a buffer was placed, 131218 that a shader was recompiled for
        // the state it is used with. Neither is an error.
        if (id == 131185 || id == 131218 || type == GL_DEBUG_TYPE_PERFORMANCE)
            return;
        auto* self = static_cast<DebugLog*>(const_cast<void*>(log));
        self->messages_.push_back(fmt::format("GL message {}: {}", id, text));
    }
};

DebugLog::DebugLog() {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(DebugLogAccess::receive, this);
}

DebugLog::~DebugLog() { glDebugMessageCallback(nullptr, nullptr); }

DebugGroup::DebugGroup(const std::string& name) {
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, static_cast<GLsizei>(name.size()),
                     name.data());
}

DebugGroup::~DebugGroup() { glPopDebugGroup(); }

void check_gl_error(const char* where) {
    const GLenum code = glGetError();
    if (code == GL_NO_ERROR)
        return;
    const char* name = code == GL_OUT_OF_MEMORY                   ? "out of memory"
                       : code == GL_INVALID_OPERATION             ? "invalid operation"
                       : code == GL_INVALID_VALUE                 ? "invalid value"
                       : code == GL_INVALID_ENUM                  ? "invalid enumerant"
                       : code == GL_INVALID_FRAMEBUFFER_OPERATION ? "incomplete framebuffer"
                                                                  : "unknown error";
    throw Error(fmt::format("OpenGL reports '{}' ({:#x}) in {}", name, code, where));
}

} // namespace romascope
