// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string_view>

namespace romascope {

/// Text files that travel inside the program, by their path below the folder they come from.
/// The functions that return them are written by cmake/EmbedText.cmake.
using EmbeddedTexts = std::map<std::string_view, std::string_view, std::less<>>;

const EmbeddedTexts& embedded_shaders(); ///< shaders/**
const EmbeddedTexts& embedded_config();  ///< config/*.toml

} // namespace romascope
