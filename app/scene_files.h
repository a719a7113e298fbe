// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace romascope {

/// A scene that comes with the program.
struct BuiltInScene {
    std::string name; ///< file name without extension
    std::filesystem::path file;
};

/// In alphabetical order. They lie in `assets/` beside the program, in `../share/romascope/assets`,
/// or in the source folder it was built from; the folder $ROMASCOPE_ASSETS goes before all.
std::vector<BuiltInScene> built_in_scenes();

/// The scene that is taken where none is named.
inline constexpr const char* kDefaultScene = "hall";

/// A file as given, or a built-in scene by its name. Throws Error (kBadInput) that suggests the
/// nearest name.
std::filesystem::path find_scene(const std::string& file_or_name);

/// The same for several words, of which one may be a folder: it stands for all .gltf and .glb files
/// in it and below, sorted by path. Throws Error (kBadInput) for a folder without any, too.
std::vector<std::filesystem::path> find_scenes(const std::vector<std::string>& words);

} // namespace romascope
