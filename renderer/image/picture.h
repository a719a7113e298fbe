// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/base/memory.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace romascope {

enum class PictureFormat { png, jpeg, hdr, unknown };

/// By content. stb_image would also take formats whose test lets almost any file pass (TGA).
PictureFormat picture_format(std::string_view bytes);

/// Whether a JPEG has its end marker: stb_image fills the missing part of a cut-off one with grey.
bool jpeg_has_end(std::string_view bytes);

/// A decoded picture, row by row from the top; red in the lowest byte, 255 where a format knows no
/// alpha. Values are as stored.
struct Picture {
    int width = 0, height = 0; ///< 1 to kMaxPictureSide
    std::vector<uint32_t> texels;
};

inline constexpr int kMaxPictureSide = 16384;

/// Decodes a PNG or JPEG, told apart by its first bytes. Before anything is decoded, its size is
/// checked, and that so few bytes can hold so many pixels; the texels and what decoding needs
/// besides are taken from the budget, the latter for that time only.
/// Throws Error (kBadInput) "WHAT: reason" for anything else, or if it is cut off or damaged.
Picture decode_picture(std::span<const std::byte> bytes, const std::string& what,
                       MemoryBudget& budget);

} // namespace romascope
