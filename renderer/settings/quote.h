// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace romascope {

/// In single quotes, on one line, and not endless: what a user gave, for use in an error.
std::string quote(std::string_view text);

/// Whether the bytes are UTF-8 without overlong forms and surrogates, as TOML asks.
bool is_utf8(std::string_view text);

} // namespace romascope
