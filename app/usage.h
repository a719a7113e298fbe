// SPDX-License-Identifier: MIT
// What a command line that the parser refuses, or would misread, is answered with.
#pragma once

#include <span>
#include <string>

namespace CLI {
class App;
class ParseError;
} // namespace CLI

namespace romascope {

/// Refuses what CLI11 reads in a way that nobody means, or answers in words of its own: an option
/// that lacks values, so that the next option would be one; an option given twice that counts once;
/// a flag with a value. `words`: the command line after the program's name. Throws Error
/// (kBadInput).
void check_option_values(const CLI::App& app, std::span<const char* const> words);

/// The answer to any other command line that was refused: a line that points to the help.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error);

} // namespace romascope
