// SPDX-License-Identifier: MIT
#include "renderer/image/text.h"

#include <stb/stb_easy_font.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

namespace romascope {
namespace {

/// What the font has letters for. A character of UTF-8 becomes one question mark.
std::string in_font(std::string_view text) {
    std::string known;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte & 0xc0) != 0x80) // not a continuation
            known += byte >= 32 && byte < 127 ? c : '?';
    }
    return known;
}

struct Vertex {
    float x, y, z;
    std::array<unsigned char, 4> color;
};
static_assert(sizeof(Vertex) == 16, "layout of stb_easy_font_print");

void fill(Image& image, int x0, int y0, int x1, int y1, float value) {
    for (int y = std::max(y0, 0); y < std::min(y1, image.height); ++y)
        for (int x = std::max(x0, 0); x < std::min(x1, image.width); ++x)
            for (int c = 0; c < image.channels; ++c)
                image.at(x, y, c) = value;
}

} // namespace

int text_width(std::string_view text, int scale) {
    std::string known = in_font(text);
    return stb_easy_font_width(known.data()) * scale;
}

void draw_text(Image& image, int x, int y, std::string_view text, int scale, float value) {
    assert(scale >= 1);
    std::string known = in_font(text);
    // A letter is at most a dozen strokes of four vertices each.
    std::vector<Vertex> strokes(known.size() * 16 * 4);
    const int count = stb_easy_font_print(0.0f, 0.0f, known.data(), nullptr, strokes.data(),
                                          static_cast<int>(strokes.size() * sizeof(Vertex)));
    for (int i = 0; i < count; ++i) {
        const Vertex& first = strokes[static_cast<size_t>(i) * 4];
        const Vertex& last = strokes[static_cast<size_t>(i) * 4 + 2]; // the opposite corner
        fill(image, x + static_cast<int>(first.x) * scale, y + static_cast<int>(first.y) * scale,
             x + static_cast<int>(last.x) * scale, y + static_cast<int>(last.y) * scale, value);
    }
}

std::string text_that_fits(std::string_view text, int scale, int width) {
    std::string known = in_font(text);
    if (text_width(known, scale) <= width)
        return known;
    while (!known.empty() && text_width(known + "...", scale) > width)
        known.pop_back();
    return known.empty() ? known : known + "...";
}

} // namespace romascope
