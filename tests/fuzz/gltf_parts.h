// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace romascope::fuzz {

/// A glTF file taken apart, so that its pieces can be changed and put together again.
struct GltfParts {
    bool glb = false;     ///< binary container; otherwise text with the buffer as a data URI
    nlohmann::json json;  ///< nested at most kMaxDepth deep
    bool has_bin = false; ///< false: there is no chunk, or buffers[0] is no data URI
    std::string bin;      ///< bytes of buffers[0]
};

/// What is nested deeper is not taken apart: writing JSON is recursive.
inline constexpr int kMaxDepth = 200;

/// Nothing where the file is too broken for that.
std::optional<GltfParts> take_apart(std::string_view file);

/// The file again, with lengths of container and chunks that fit. `fit_buffer`: buffers[0] says the
/// size of `bin`, whatever it said before.
std::string put_together(GltfParts parts, bool fit_buffer);

std::string to_base64(std::string_view bytes);
/// Stops at the first character that is not of base64.
std::string from_base64(std::string_view text);

} // namespace romascope::fuzz
