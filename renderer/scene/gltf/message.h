// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace romascope::gltf {

/// Throws Error (kBadInput) "ELEMENT: reason"; the importer puts the file in front.
[[noreturn]] void refuse(const std::string& element, const std::string& reason);

/// What a message may show of a text that comes from a file: one line of sane length without
/// control characters.
std::string one_line(const std::string& text);

} // namespace romascope::gltf
