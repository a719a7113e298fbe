// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/base/error.h"
#include "renderer/gl/objects.h"
#include "renderer/gl/shader_source.h"

#include <glm/glm.hpp>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace romascope {

/// A linked GL program. Throws Error with the driver's message, by file and line, if it does not
/// compile or link.
class Program {
public:
    Program() = default;
    Program(const ShaderLibrary& library, const ShaderVariant& variant)
        : Program(variant, library.expand(variant)) {}
    /// `sources`: of the variant's stages.
    Program(const ShaderVariant& variant, const std::vector<ExpandedShader>& sources);

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
    GLint location(const char* name) const;
    GlHandle<delete_program> handle_;
    mutable std::map<std::string, GLint, std::less<>> locations_; ///< that were asked for
    glm::ivec3 group_size_{1};                                    ///< of a compute program
};

/// The program of a pass: compiled when first needed and whenever its variant changes, or the text
/// of its files.
class ProgramSlot {
public:
    /// Throws Error if the variant does not compile, again and again until the library has another
    /// generation. A program that is in use and whose files change for the worse stays; the library
    /// is told of the fault, once in each generation.
    const Program& get(const ShaderLibrary& library, const ShaderVariant& variant);

private:
    struct Refusal {
        ShaderVariant variant;
        unsigned generation;
        Error error;
    };
    void compile(const ShaderLibrary& library, const ShaderVariant& variant);
    void follow_files(const ShaderLibrary& library);

    std::optional<ShaderVariant> variant_;
    unsigned generation_ = 0; ///< in which the files were last looked at
    std::vector<ExpandedShader> sources_;
    Program program_;
    std::optional<Refusal> refusal_;
};

} // namespace romascope
