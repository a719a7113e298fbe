// SPDX-License-Identifier: MIT
#include "app/contact_sheet.h"

#include "renderer/image/text.h"

#include <algorithm>
#include <cassert>

namespace romascope {
namespace {

constexpr float kBackground = 0.01f, kLabel = 0.85f, kCaption = 0.35f; ///< linear

void paste(Image& picture, const Image& tile, int left, int top) {
    for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x)
            for (int c = 0; c < picture.channels; ++c)
                picture.at(left + x, top + y, c) = tile.at(x, y, std::min(c, tile.channels - 1));
}

/// Cuts a text into lines that fit, between words where there are any.
std::vector<std::string> wrapped(const std::string& text, int scale, int width) {
    std::vector<std::string> lines;
    size_t begin = 0;
    while (begin < text.size()) {
        size_t count = text.size() - begin;
        while (count > 1 && text_width(text.substr(begin, count), scale) > width) {
            const size_t space = text.rfind(' ', begin + count - 1);
            count = space != text.npos && space > begin ? space - begin : count - 1;
        }
        lines.push_back(text.substr(begin, count));
        begin += count;
        while (begin < text.size() && text[begin] == ' ')
            ++begin;
    }
    return lines;
}

} // namespace

ContactSheet::Layout::Layout(size_t scenes, int columns_, int tile_width, int tile_height,
                             size_t tiles)
    // Letters are read at the same ease on small and large tiles.
    : scale(std::clamp(tile_height / 130, 1, 8)), gap(4 * scale), strip(kTextLine * scale),
      head(gap + strip + gap), row_width(static_cast<int>(tiles) * (tile_width + gap) - gap),
      row_height(strip + tile_height),
      columns(std::min(columns_, std::max(static_cast<int>(scenes), 1))),
      rows((static_cast<int>(scenes) + columns - 1) / columns) {}

size_t ContactSheet::bytes_needed(size_t scenes, int columns, int tile_width, int tile_height,
                                  size_t tiles) {
    const Layout layout(scenes, columns, tile_width, tile_height, tiles);
    // Three floats for each pixel; three bytes before and after they are compressed.
    return static_cast<size_t>(layout.width()) * static_cast<size_t>(layout.height()) *
           (3 * sizeof(float) + 2 * 3);
}

ContactSheet::ContactSheet(size_t scenes, int columns, int tile_width, int tile_height,
                           std::vector<std::string> captions)
    : tile_width_(tile_width), tile_height_(tile_height), tiles_(captions.size()),
      layout_(scenes, columns, tile_width, tile_height, captions.size()),
      picture_(layout_.width(), layout_.height(), 3) {
    std::ranges::fill(picture_.data, kBackground);
    for (int column = 0; column < layout_.columns; ++column)
        for (size_t tile = 0; tile < tiles_; ++tile)
            draw_text(picture_,
                      layout_.gap + column * (layout_.row_width + layout_.gap) +
                          static_cast<int>(tile) * (tile_width_ + layout_.gap),
                      layout_.gap, text_that_fits(captions[tile], layout_.scale, tile_width_),
                      layout_.scale, kCaption);
}

void ContactSheet::add(const std::string& label, const std::vector<Image>& tiles,
                       const std::string& text) {
    assert(next_ < static_cast<size_t>(layout_.columns) * layout_.rows);
    assert(tiles.size() <= tiles_);
    const int place = static_cast<int>(next_++);
    const int left = layout_.gap + place % layout_.columns * (layout_.row_width + layout_.gap);
    int top = layout_.head + place / layout_.columns * (layout_.row_height + layout_.gap);
    draw_text(picture_, left, top, text_that_fits(label, layout_.scale, layout_.row_width),
              layout_.scale, kLabel);
    top += layout_.strip;
    int tile_left = left;
    for (const Image& tile : tiles) {
        assert(tile.width == tile_width_ && tile.height == tile_height_);
        paste(picture_, tile, tile_left, top);
        tile_left += tile_width_ + layout_.gap;
    }
    const int bottom = top + tile_height_;
    for (const std::string& line :
         wrapped(text, layout_.scale, left + layout_.row_width - tile_left)) {
        if (top + layout_.strip > bottom)
            break;
        draw_text(picture_, tile_left, top, line, layout_.scale, kLabel);
        top += layout_.strip;
    }
}

} // namespace romascope
