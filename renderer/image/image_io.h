// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/image/image.h"

#include <filesystem>

namespace romascope {

/// Throws Error (kBadInput) naming the formats that write_image knows if the name ends in none of
/// them. For telling the user before the work instead of after it.
void check_image_extension(const std::filesystem::path& path);

/// Writes a picture, all of it or nothing; missing parent folders are made. The end of the name
/// (case does not count) chooses the format:
/// - `.png`: encoded to sRGB, 8 bits, clamped to [0, 1]; grey for 1 channel, RGB for 3.
/// - `.hdr`: linear Radiance RGBE; 1 channel is written as 3 equal ones. The three values of a
///   pixel share one exponent, so each is rounded to within 1/255 of the pixel's largest;
///   negative values and NaN become 0, infinity the largest value there is.
/// Throws Error for another ending, an empty image, or what the file system says.
void write_image(const std::filesystem::path& path, const Image& image);

/// Reads a .png (8 or 16 bits), .jpg or .hdr, whatever its name, as linear values. PNG and JPEG are
/// taken as sRGB, whatever colour profile they carry. Grey gives 1 channel, everything else 3;
/// alpha is dropped. Throws Error (kBadInput) with the path and the reason if it cannot be read,
/// is cut off or is damaged.
Image read_image(const std::filesystem::path& path);

} // namespace romascope
