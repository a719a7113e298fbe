// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace romascope {

/// Contents of a file. Throws Error (kBadInput) naming the path if it cannot be read.
std::string read_text_file(const std::filesystem::path& path);

/// Writes all bytes or nothing: to a temporary file beside `path`, which is then renamed.
/// Makes missing parent folders; a symbolic link to a file stays one. What is not a plain file
/// (/dev/null, a pipe) is written to directly. Throws Error naming the path and the reason.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);
void write_file_atomically(const std::filesystem::path& path, const std::string& text);

/// Where this user's files go, by the XDG base directory specification: `$XDG_CACHE_HOME/romascope`
/// if that is absolute, or `~/.cache/romascope`; not created. Without a home directory: a folder of
/// this user below the system's temporary directory.
std::filesystem::path cache_directory();
/// The same of `$XDG_CONFIG_HOME` or `~/.config`: what the user has set.
std::filesystem::path config_directory();
/// The same of `$XDG_STATE_HOME` or `~/.local/state`: what the program remembers.
std::filesystem::path state_directory();

} // namespace romascope
