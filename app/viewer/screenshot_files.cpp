// SPDX-License-Identifier: MIT
#include "app/viewer/screenshot_files.h"

#include "renderer/base/files.h"

#include <fmt/chrono.h>

#include <cstdlib>
#include <ctime>
#include <fstream>

namespace romascope {
namespace fs = std::filesystem;
namespace {

/// $XDG_PICTURES_DIR of the file that desktops keep; empty if it is not told.
fs::path pictures_of_user_dirs(const std::string& home) {
    std::ifstream file(config_directory().parent_path() / "user-dirs.dirs");
    const std::string key = "XDG_PICTURES_DIR=\"", home_word = "$HOME";
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with(key) || !line.ends_with('"') || line.size() <= key.size())
            continue;
        std::string value = line.substr(key.size(), line.size() - key.size() - 1);
        if (value.starts_with(home_word))
            value = home + value.substr(home_word.size());
        if (value.starts_with('/') && value != home && value != home + "/")
            return value;
    }
    return {};
}

fs::path pictures_folder() {
    if (const char* folder = std::getenv("XDG_PICTURES_DIR"); folder && *folder == '/')
        return folder;
    const char* home = std::getenv("HOME");
    if (!home || *home != '/')
        return {};
    if (fs::path folder = pictures_of_user_dirs(home); !folder.empty())
        return folder;
    std::error_code code;
    const fs::path usual = fs::path(home) / "Pictures";
    return fs::is_directory(usual, code) ? usual : fs::path();
}

} // namespace

fs::path screenshot_folder() {
    const fs::path pictures = pictures_folder();
    return pictures.empty() ? state_directory() / "screenshots" : pictures / "romascope";
}

fs::path new_screenshot_file(const fs::path& folder, const fs::path& scene_file) {
    const std::string stem = fmt::format("{}-{:%Y%m%d-%H%M%S}", scene_file.stem().string(),
                                         fmt::localtime(std::time(nullptr)));
    fs::path file = folder / (stem + ".png");
    std::error_code code;
    for (int i = 2; fs::exists(file, code); ++i)
        file = folder / fmt::format("{}-{}.png", stem, i);
    return file;
}

} // namespace romascope
