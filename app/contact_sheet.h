// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/image/image.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace romascope {

/// A picture of many scenes: for each a row with a label above a few tiles of one size. Scenes may
/// stand in several columns.
class ContactSheet {
public:
    /// `captions`: of the tiles of each row, from left to right; tell what they show.
    ContactSheet(size_t scenes, int columns, int tile_width, int tile_height,
                 std::vector<std::string> captions);

    /// Bytes that a sheet of this size takes, with what writing it takes.
    static size_t bytes_needed(size_t scenes, int columns, int tile_width, int tile_height,
                               size_t tiles);

    /// Adds the next scene. Tiles have the size given and 1 or 3 channels; less than there are
    /// captions leave room. `text` is written where there are no tiles.
    void add(const std::string& label, const std::vector<Image>& tiles,
             const std::string& text = {});

    const Image& picture() const { return picture_; }

private:
    struct Layout {
        int scale, gap, strip, head; ///< pixels; `strip` is the label's height
        int row_width, row_height, columns, rows;
        Layout(size_t scenes, int columns, int tile_width, int tile_height, size_t tiles);
        int width() const { return columns * (row_width + gap) + gap; }
        int height() const { return head + rows * (row_height + gap); }
    };

    int tile_width_, tile_height_;
    size_t tiles_;
    Layout layout_;
    Image picture_;
    size_t next_ = 0;
};

} // namespace romascope
