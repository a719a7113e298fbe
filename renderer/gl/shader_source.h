// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/settings/shader_defines.h"

#include <glad/gl.h>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace romascope {

/// One stage of a program: a file below shaders/.
struct ShaderStage {
    GLenum type = 0; ///< GL_COMPUTE_SHADER, ...
    std::string file;

    bool operator==(const ShaderStage&) const = default;
};

/// Everything that decides what is compiled. Two equal variants are the same program.
struct ShaderVariant {
    std::string name; ///< for people
    std::vector<ShaderStage> stages;
    std::vector<ShaderDefine> defines;
    /// Names in `#include "..."` that the host decides, e.g. "tracer.glsl" -> the chosen tracer.
    std::map<std::string, std::string> includes;

    bool operator==(const ShaderVariant&) const = default;
};

/// Files are told apart in a driver's messages by their line numbers alone: Mesa loses the source
/// string number that #line can give.
inline constexpr int kLinesPerFile = 10000;

/// The text of one stage with its includes put in.
struct ExpandedShader {
    std::string text;
    std::vector<std::string> files; ///< line n of file k counts as line k * kLinesPerFile + n

    bool operator==(const ExpandedShader&) const = default;
};

/// Where shaders are read from: the program itself, or a folder of the same layout, whose files may
/// change while programs of them are in use. Copies share what is known of the files.
class ShaderLibrary {
public:
    ShaderLibrary() = default;
    explicit ShaderLibrary(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Adds a file that lies in neither, such as a test's shader around functions of the project.
    void add(const std::string& file, const std::string& text);

    /// `#version`, the variant's defines, then the stage's file; each `#include "path"` (from the
    /// shader root) is replaced by that file the first time it occurs. Throws Error that names file
    /// and line for a file that does not exist.
    ExpandedShader expand(const ShaderVariant& variant, const ShaderStage& stage) const;
    /// All stages in their order.
    std::vector<ExpandedShader> expand(const ShaderVariant& variant) const;

    /// Looks at the files that programs were made of, by time and size: cheap enough for a few
    /// times a second. True, and a new generation, if one differs, came or went since the last
    /// look.
    bool refresh();
    /// Who was made in another generation may be out of date.
    unsigned generation() const { return shared_->generation; }

    /// Notes why a program could not follow its files; the same line once.
    void add_fault(const std::string& what) const;
    /// What was noted since the last call.
    std::vector<std::string> take_faults() const;

private:
    /// What of a file tells that it is another one.
    struct Stamp {
        std::filesystem::file_time_type time;
        uintmax_t size = 0;
        bool operator==(const Stamp&) const = default;
    };
    struct Shared {
        unsigned generation = 0;
        std::map<std::string, std::optional<Stamp>> seen; ///< empty: could not be read
        std::vector<std::string> faults;
    };

    std::optional<Stamp> stamp(const std::string& file) const;
    std::string read(const std::string& file) const;
    void append(const ShaderVariant& variant, const std::string& file, const std::string& from,
                ExpandedShader& out) const;
    std::filesystem::path folder_; ///< empty: embedded
    std::map<std::string, std::string> added_;
    std::shared_ptr<Shared> shared_ = std::make_shared<Shared>();
};

/// Replaces places in a driver's log, "0:10012(3)" (Mesa), "0(10012)" (NVIDIA) or "0:10012"
/// (glslang), by "file:12".
std::string name_files_in_log(const std::string& log, const std::vector<std::string>& files);

} // namespace romascope
