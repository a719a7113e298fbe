// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace romascope::gltf {

/// What the start of a Draco bitstream says it holds.
struct DracoHeader {
    size_t faces = 0;
    size_t vertices = 0; ///< at least that many points; all of them if encoded sequentially
    size_t seamed = 0;   ///< attributes with a connectivity of their own
};

/// Reads as much of the bitstream as tells how much memory decoding it will need: the library
/// itself allocates first and finds out later. Throws Error (kBadInput) for ELEMENT if it is no
/// triangle mesh of Draco's bitstream 1.x or 2.x.
DracoHeader read_draco_header(std::span<const std::byte> bytes, const std::string& element);

} // namespace romascope::gltf
