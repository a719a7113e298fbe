// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/base/memory.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace romascope::gltf {

bool is_data_uri(std::string_view uri);

/// "a%20b" is "a b"; a % without two hexadecimal digits stays.
std::string percent_decoded(std::string_view text);

/// What the URIs of a glTF file name: data in the URI itself, or files in its folder and below.
class Resources {
public:
    /// `asset`: the path of the glTF file.
    explicit Resources(const std::filesystem::path& asset);

    /// All bytes behind `uri`, or the first `size`. The memory is taken from `budget` before.
    /// Throws Error (kBadInput) for ELEMENT if the URI is malformed, absolute, has a scheme other
    /// than data:, leaves the folder (also by a symbolic link), names no plain file that can be
    /// read, or holds less than `size` bytes.
    std::vector<std::byte> read(const std::string& uri, std::optional<size_t> size,
                                MemoryBudget& budget, const std::string& element) const;

private:
    std::filesystem::path file(const std::string& uri, const std::string& element) const;

    std::filesystem::path folder_; ///< canonical
};

} // namespace romascope::gltf
