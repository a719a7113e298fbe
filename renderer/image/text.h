// SPDX-License-Identifier: MIT
// Labels in pictures.
#pragma once

#include "renderer/image/image.h"

#include <string>
#include <string_view>

namespace romascope {

/// Pixels from one line to the next, times the scale.
inline constexpr int kTextLine = 12;

/// Pixels that a line of text is wide.
int text_width(std::string_view text, int scale);

/// Draws a line of text with its upper left corner at (x, y); all channels take `value`. `scale`:
/// pixels per pixel of the font, at least 1. ASCII only: any other character is a question mark.
/// What lies outside the picture is cut off.
void draw_text(Image& image, int x, int y, std::string_view text, int scale, float value);

/// The text, or as much of it from the beginning as fits into `width` pixels with dots behind.
std::string text_that_fits(std::string_view text, int scale, int width);

} // namespace romascope
