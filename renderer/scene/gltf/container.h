// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace romascope::gltf {

/// The parts of a .glb or .gltf file, inside its bytes.
struct Container {
    std::string_view json;
    std::optional<std::span<const std::byte>> binary; ///< the BIN chunk
};

/// Tells .glb from .gltf by the first bytes. Unknown chunks and what follows the stated length are
/// skipped. Throws Error (kBadInput) if it is neither, or if a length lies.
Container split_container(std::string_view content);

} // namespace romascope::gltf
