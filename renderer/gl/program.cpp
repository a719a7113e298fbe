// SPDX-License-Identifier: MIT
#include "renderer/gl/program.h"

#include <fmt/format.h>

#include <glm/gtc/type_ptr.hpp>

namespace romascope {
namespace {

std::string log_of(GLuint id, bool program) {
    GLint length = 0;
    if (program)
        glGetProgramiv(id, GL_INFO_LOG_LENGTH, &length);
    else
        glGetShaderiv(id, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<size_t>(std::max(length, 1)), '\0');
    if (program)
        glGetProgramInfoLog(id, length, nullptr, log.data());
    else
        glGetShaderInfoLog(id, length, nullptr, log.data());
    log.resize(log.find('\0') == std::string::npos ? log.size() : log.find('\0'));
    while (!log.empty() && (log.back() == '\n' || log.back() == ' '))
        log.pop_back();
    return log;
}

void delete_shader(GLuint id) { glDeleteShader(id); }

using ShaderHandle = GlHandle<delete_shader>;

ShaderHandle compile(const ShaderVariant& variant, const ShaderStage& stage,
                     const ExpandedShader& source) {
    ShaderHandle shader(glCreateShader(stage.type));
    const char* text = source.text.c_str();
    glShaderSource(shader.id(), 1, &text, nullptr);
    glCompileShader(shader.id());
    GLint ok = 0;
    glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &ok);
    if (!ok)
        throw Error(fmt::format("shader '{}' ({}) does not compile: {}", variant.name, stage.file,
                                name_files_in_log(log_of(shader.id(), false), source.files)));
    return shader;
}

std::string file_names(const ShaderVariant& variant) {
    std::vector<std::string> names;
    for (const ShaderStage& stage : variant.stages)
        names.push_back(stage.file);
    return fmt::format("{}", fmt::join(names, ", "));
}

} // namespace

Program::Program(const ShaderVariant& variant, const std::vector<ExpandedShader>& sources)
    : handle_(glCreateProgram()) {
    std::vector<ShaderHandle> shaders;
    for (size_t i = 0; i < sources.size(); ++i) {
        shaders.push_back(compile(variant, variant.stages[i], sources[i]));
        glAttachShader(id(), shaders.back().id());
    }
    glLinkProgram(id());
    GLint ok = 0;
    glGetProgramiv(id(), GL_LINK_STATUS, &ok);
    if (!ok)
        throw Error(fmt::format("shader '{}' ({}) does not link: {}", variant.name,
                                file_names(variant), log_of(id(), true)));
    for (const ShaderHandle& shader : shaders)
        glDetachShader(id(), shader.id());
    if (variant.stages.front().type == GL_COMPUTE_SHADER)
        glGetProgramiv(id(), GL_COMPUTE_WORK_GROUP_SIZE, glm::value_ptr(group_size_));
    glObjectLabel(GL_PROGRAM, id(), static_cast<GLsizei>(variant.name.size()), variant.name.data());
}

void Program::dispatch_covering(glm::ivec3 total) const {
    const glm::uvec3 groups((total + group_size_ - 1) / group_size_);
    glDispatchCompute(groups.x, groups.y, groups.z);
}

void Program::set(const char* name, int value) const {
    glProgramUniform1i(id(), location(name), value);
}
void Program::set(const char* name, GLuint value) const {
    glProgramUniform1ui(id(), location(name), value);
}
void Program::set(const char* name, float value) const {
    glProgramUniform1f(id(), location(name), value);
}
void Program::set(const char* name, glm::vec3 value) const {
    glProgramUniform3fv(id(), location(name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, glm::ivec2 value) const {
    glProgramUniform2iv(id(), location(name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, glm::ivec3 value) const {
    glProgramUniform3iv(id(), location(name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, const glm::mat4& value) const {
    glProgramUniformMatrix4fv(id(), location(name), 1, GL_FALSE, glm::value_ptr(value));
}

GLint Program::location(const char* name) const {
    const auto known = locations_.find(std::string_view(name));
    if (known != locations_.end())
        return known->second;
    return locations_.emplace(name, glGetUniformLocation(id(), name)).first->second;
}

const Program& ProgramSlot::get(const ShaderLibrary& library, const ShaderVariant& variant) {
    if (variant_ != variant)
        compile(library, variant); // throws with the old program still in place
    else if (generation_ != library.generation())
        follow_files(library);
    return program_;
}

void ProgramSlot::compile(const ShaderLibrary& library, const ShaderVariant& variant) {
    if (refusal_ && refusal_->generation == library.generation() && refusal_->variant == variant)
        throw refusal_->error;
    try {
        std::vector<ExpandedShader> sources = library.expand(variant);
        program_ = Program(variant, sources);
        sources_ = std::move(sources);
    } catch (const Error& error) {
        refusal_ = {variant, library.generation(), error};
        throw;
    }
    variant_ = variant;
    generation_ = library.generation();
    refusal_.reset();
}

void ProgramSlot::follow_files(const ShaderLibrary& library) {
    generation_ = library.generation();
    try {
        std::vector<ExpandedShader> sources = library.expand(*variant_);
        if (sources == sources_)
            return;
        program_ = Program(*variant_, sources);
        sources_ = std::move(sources);
    } catch (const Error& error) {
        library.add_fault(error.what());
    }
}

} // namespace romascope
