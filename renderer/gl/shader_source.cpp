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

} // namespace

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
    if (!folder_.empty())
        return read_text_file(folder_ / file);
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
    out.text += fmt::format("#line 1 {}\n", number);
    std::istringstream lines(text);
    std::string line;
    for (int line_number = 1; std::getline(lines, line); ++line_number) {
        std::string path = included_path(line);
        if (path.empty()) {
            // Headers shared with C++ carry a pragma that GLSL compilers warn about.
            out.text += line.starts_with("#pragma once") ? "\n" : line + "\n";
            continue;
        }
        if (const auto chosen = variant.includes.find(path); chosen != variant.includes.end())
            path = chosen->second;
        if (path.starts_with("shaders/")) // as the C++ side writes it
            path = path.substr(8);
        if (std::find(out.files.begin(), out.files.end(), path) == out.files.end())
            append(variant, path, fmt::format("{}:{}", file, line_number), out);
        out.text += fmt::format("#line {} {}\n", line_number + 1, number);
    }
}

std::string name_files_in_log(const std::string& log, const std::vector<std::string>& files) {
    static const std::regex place(R"(\b(\d+)(?::(\d+)(?:\(\d+\))?|\((\d+)\)))");
    std::string out;
    auto from = log.cbegin();
    for (std::sregex_iterator it(log.begin(), log.end(), place), end; it != end; ++it) {
        const std::smatch& match = *it;
        out.append(from, match[0].first);
        from = match[0].second;
        size_t number = files.size();
        const std::string digits = match[1];
        std::from_chars(digits.data(), digits.data() + digits.size(), number);
        if (number < files.size())
            out += fmt::format("{}:{}", files[number],
                               match[2].matched ? match[2].str() : match[3].str());
        else
            out += match[0];
    }
    out.append(from, log.cend());
    return out;
}

} // namespace romascope
