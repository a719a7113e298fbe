// SPDX-License-Identifier: MIT
#include "app/scene_files.h"

#include "renderer/base/did_you_mean.h"
#include "renderer/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace romascope {
namespace fs = std::filesystem;
namespace {

fs::path asset_folder() {
    std::vector<fs::path> places;
    if (const char* chosen = std::getenv("ROMASCOPE_ASSETS"); chosen && *chosen)
        places.emplace_back(chosen);
    std::error_code code;
    const fs::path program = fs::read_symlink("/proc/self/exe", code);
    if (!code) {
        places.push_back(program.parent_path() / "assets");
        places.push_back(program.parent_path() / "../share/romascope/assets");
    }
    places.emplace_back(ROMASCOPE_ASSET_DIR);
    for (const fs::path& place : places)
        if (fs::is_directory(place, code))
            return place;
    return {};
}

bool is_scene_file(const fs::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return extension == ".gltf" || extension == ".glb";
}

std::vector<fs::path> scenes_below(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code code;
    constexpr auto kSkip = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator at(folder, kSkip, code), end; !code && at != end;
         at.increment(code))
        if (is_scene_file(at->path()) && at->is_regular_file(code))
            files.push_back(at->path());
    if (code)
        throw Error(fmt::format("cannot read {}: {}", folder.string(), code.message()), kBadInput);
    if (files.empty())
        throw Error(fmt::format("there is no .gltf or .glb file in {}", folder.string()),
                    kBadInput);
    std::ranges::sort(files);
    return files;
}

} // namespace

std::vector<BuiltInScene> built_in_scenes() {
    std::vector<BuiltInScene> scenes;
    std::error_code code;
    for (const auto& entry : fs::directory_iterator(asset_folder(), code))
        if (entry.path().extension() == ".glb")
            scenes.push_back({entry.path().stem().string(), entry.path()});
    std::sort(scenes.begin(), scenes.end(),
              [](const BuiltInScene& a, const BuiltInScene& b) { return a.name < b.name; });
    return scenes;
}

fs::path find_scene(const std::string& file_or_name) {
    std::error_code code;
    if (fs::is_regular_file(file_or_name, code))
        return file_or_name;
    std::vector<std::string> names;
    for (const BuiltInScene& scene : built_in_scenes()) {
        if (scene.name == file_or_name)
            return scene.file;
        names.push_back(scene.name);
    }
    if (fs::exists(file_or_name, code)) // a folder or the like; reading it says so
        return file_or_name;
    // What looks like a path is one that does not exist; a bare word may be a name misspelt.
    const fs::path path(file_or_name);
    if (path.has_extension() || path.has_parent_path() || names.empty())
        throw Error(fmt::format("there is no scene file '{}'", file_or_name), kBadInput);
    throw Error(fmt::format("there is no scene '{}'{} (built in: {}; or give a "
                            ".gltf or .glb file)",
                            file_or_name, did_you_mean(file_or_name, names),
                            fmt::join(names, ", ")),
                kBadInput);
}

std::vector<fs::path> find_scenes(const std::vector<std::string>& words) {
    std::vector<fs::path> files;
    for (const std::string& word : words) {
        std::error_code code;
        if (!fs::is_directory(word, code))
            files.push_back(find_scene(word));
        else
            for (fs::path& file : scenes_below(word))
                files.push_back(std::move(file));
    }
    return files;
}

} // namespace romascope
