// SPDX-License-Identifier: MIT
#include "app/output_files.h"

#include "renderer/base/error.h"

#include <fmt/format.h>

#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace romascope {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
    throw Error(fmt::format("cannot write {}: {}", path.string(), why), kBadInput);
}

/// Whether the path is or may become a plain file: /dev/null and pipes take anything, and often.
bool is_plain(const fs::path& path) {
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    return !fs::exists(status) || fs::is_regular_file(status);
}

void check_writable(const fs::path& path) {
    std::error_code code;
    if (fs::is_directory(path, code))
        refuse(path, "it is a folder");
    // A plain file is replaced, so its folder counts; missing folders are made.
    fs::path changed = is_plain(path) ? fs::absolute(path, code).parent_path() : path;
    while (!fs::exists(changed, code) && changed.has_relative_path())
        changed = changed.parent_path();
    if (is_plain(path) && !fs::is_directory(changed, code))
        refuse(path, fmt::format("{} is not a folder", changed.string()));
    if (access(changed.c_str(), W_OK) != 0)
        refuse(path, std::strerror(errno));
}

bool same_file(const fs::path& a, const fs::path& b) {
    std::error_code code;
    const auto whole = [&](const fs::path& path) {
        // A relative path of which nothing exists would stay relative.
        return fs::weakly_canonical(fs::absolute(path, code), code);
    };
    return whole(a) == whole(b);
}

} // namespace

void check_output_files(const std::vector<fs::path>& outputs, const std::vector<fs::path>& inputs) {
    for (size_t i = 0; i < outputs.size(); ++i) {
        if (outputs[i].empty())
            continue;
        check_writable(outputs[i]);
        if (!is_plain(outputs[i]))
            continue;
        for (const fs::path& input : inputs)
            if (same_file(outputs[i], input))
                refuse(outputs[i], "it is an input of the same command");
        for (size_t j = 0; j < i; ++j)
            if (!outputs[j].empty() && same_file(outputs[i], outputs[j]))
                refuse(outputs[i], "two outputs have this name");
    }
}

} // namespace romascope
