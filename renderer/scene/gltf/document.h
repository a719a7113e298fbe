// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace tinygltf {
class Model;
}

namespace romascope::gltf {

/// Throws Error (kBadInput) "ELEMENT: reason"; load_gltf puts the file in front.
[[noreturn]] void refuse(const std::string& element, const std::string& reason);

/// Parses `content` (of the file at `path`) with tinygltf, which neither validates what it reads
/// nor limits what it follows: so the depth of its JSON is checked before, images are not decoded,
/// and files outside the folder of `path` are not opened. What the model refers to is not yet
/// checked: indices and spans in it may point anywhere.
/// Throws Error (kBadInput) without the file's name.
void parse(const std::string& content, const std::filesystem::path& path, tinygltf::Model& model);

} // namespace romascope::gltf
