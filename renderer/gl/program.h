// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/objects.h"
#include "renderer/gl/shader_source.h"

#include <glm/glm.hpp>

#include <optional>

namespace romascope {

/// A linked GL program. Throws Error with the driver's message, by file and line, if it does not
/// compile or link.
class Program {
public:
    Program() = default;
    Program(const ShaderLibrary& library, const ShaderVariant& variant);

    void use() const { glUseProgram(handle_.id()); }
    /// Runs a compute program, which must be in use, over at least `total` invocations.
    void dispatch_covering(glm::ivec3 total) const;
    GLuint id() const { return handle_.id(); }

    // Uniforms by name; a name that the compiler removed is passed over.
    void set(const char* name, int value) const;
    void set(const char* name, GLuint value) const;
    void set(const char* name, float value) const;
    void set(const char* name, glm::vec3 value) const;
    void set(const char* name, glm::ivec2 value) const;
    void set(const char* name, glm::ivec3 value) const;
    void set(const char* name, const glm::mat4& value) const;

private:
    GLint location(const char* name) const { return glGetUniformLocation(handle_.id(), name); }
    GlHandle<delete_program> handle_;
    glm::ivec3 group_size_{1}; ///< of a compute program
};

/// The program of a pass: compiled when first needed and whenever its variant changes.
class ProgramSlot {
public:
    const Program& get(const ShaderLibrary& library, const ShaderVariant& variant);

private:
    std::optional<ShaderVariant> variant_;
    Program program_;
};

} // namespace romascope
