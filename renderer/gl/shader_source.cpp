// SPDX-License-Identifier: MIT
#include "renderer/gl/shader_source.h"

#include "renderer/base/embedded_text.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <regex>
#include <sstream>
#include <utility>

namespace romascope {
namespace {

/// The path in a line `#include "path"`, or empty.
std::string included_path(const std::string& line) {
    const size_t word = line.find_first_not_of(" \t");
    if (word == std::string::npos || line.compare(word, 10, "#include \"") != 0)
        return {};
    const size_t begin = word + 10;
    const size_t end = line.find('"', begin);
    return end == std::string::npos ? std::string{} : line.substr(begin, end - begin);
}

/// Whether a line ends a group of lines that may have been left out, with the #line in it.
bool ends_group(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    return line.starts_with("#else") || line.starts_with("#elif") || line.starts_with("#endif");
}

} // namespace

void ShaderLibrary::add(const std::string& file, const std::string& text) {
    added_[file] = text;
    ++shared_->generation;
}

bool ShaderLibrary::refresh() {
    bool changed = false;
    for (auto& [file, seen] : shared_->seen) {
        const std::optional<Stamp> now = stamp(file);
        changed = changed || now != seen;
        seen = now;
    }
    if (changed)
        ++shared_->generation;
    return changed;
}

void ShaderLibrary::add_fault(const std::string& what) const {
    if (std::ranges::find(shared_->faults, what) == shared_->faults.end())
        shared_->faults.push_back(what);
}

std::vector<std::string> ShaderLibrary::take_faults() const {
    return std::exchange(shared_->faults, {});
}

std::optional<ShaderLibrary::Stamp> ShaderLibrary::stamp(const std::string& file) const {
    std::error_code time_code, size_code;
    const Stamp found{std::filesystem::last_write_time(folder_ / file, time_code),
                      std::filesystem::file_size(folder_ / file, size_code)};
    return time_code || size_code ? std::nullopt : std::optional(found);
}

std::vector<ExpandedShader> ShaderLibrary::expand(const ShaderVariant& variant) const {
    std::vector<ExpandedShader> stages;
    for (const ShaderStage& stage : variant.stages)
        stages.push_back(expand(variant, stage));
    return stages;
}

ExpandedShader ShaderLibrary::expand(const ShaderVariant& variant, const ShaderStage& stage) const {
    ExpandedShader out;
    out.text = "#version 450 core\n";
    for (const ShaderDefine& define : variant.defines)
        out.text += fmt::format("#define {} {}\n", define.name, define.value);
    append(variant, stage.file, "program '" + variant.name + "'", out);
    return out;
}

std::string ShaderLibrary::read(const std::string& file) const {
    if (const auto own = added_.find(file); own != added_.end())
        return own->second;
    if (!folder_.empty()) {
        // Before it is read: what changes in between is seen at the next look. Only refresh() moves
        // a stamp on, as programs of the older text may be in use.
        shared_->seen.try_emplace(file, stamp(file));
        return read_text_file(folder_ / file);
    }
    const auto found = embedded_shaders().find(file);
    if (found == embedded_shaders().end())
        throw Error("there is no such shader file");
    return std::string(found->second);
}

void ShaderLibrary::append(const ShaderVariant& variant, const std::string& file,
                           const std::string& from, ExpandedShader& out) const {
    std::string text;
    try {
        text = read(file);
    } catch (const Error& error) {
        throw Error(fmt::format("{}: cannot include {}: {}", from, file, error.what()));
    }
    const size_t number = out.files.size();
    out.files.push_back(file);
    const auto set_line = [&](int line) {
        out.text += fmt::format("#line {}\n", static_cast<int>(number) * kLinesPerFile + line);
    };
    set_line(1);
    std::istringstream lines(text);
    std::string line;
    bool included = false;
    for (int line_number = 1; std::getline(lines, line); ++line_number) {
        std::string path = included_path(line);
        if (path.empty()) {
            // Headers shared with C++ carry a pragma that GLSL compilers warn about.
            out.text += line.starts_with("#pragma once") ? "\n" : line + "\n";
            if (included && ends_group(line))
                set_line(line_number + 1);
            continue;
        }
        if (const auto chosen = variant.includes.find(path); chosen != variant.includes.end())
            path = chosen->second;
        if (path.starts_with("shaders/")) // as the C++ side writes it
            path = path.substr(8);
        if (std::find(out.files.begin(), out.files.end(), path) == out.files.end())
            append(variant, path, fmt::format("{}:{}", file, line_number), out);
        set_line(line_number + 1);
        included = true;
    }
}

std::string name_files_in_log(const std::string& log, const std::vector<std::string>& files) {
    static const std::regex place(R"(\b0(?::(\d+)(?:\(\d+\))?|\((\d+)\)))");
    std::string out;
    auto from = log.cbegin();
    for (std::sregex_iterator it(log.begin(), log.end(), place), end; it != end; ++it) {
        const std::smatch& match = *it;
        out.append(from, match[0].first);
        from = match[0].second;
        const std::string digits = match[1].matched ? match[1] : match[2];
        int line = 0;
        std::from_chars(digits.data(), digits.data() + digits.size(), line);
        const auto number = static_cast<size_t>(line / kLinesPerFile);
        out += number < files.size() ? fmt::format("{}:{}", files[number], line % kLinesPerFile)
                                     : match[0].str();
    }
    out.append(from, log.cend());
    return out;
}

} // namespace romascope
