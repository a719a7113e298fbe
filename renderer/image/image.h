// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace romascope {

/// A picture of linear floats in memory: `channels` (1 or 3) values per pixel, interleaved, rows
/// from the top down.
struct Image {
    int width = 0;
    int height = 0;
    int channels = 0;
    std::vector<float> data; ///< width * height * channels values

    Image() = default;
    Image(int w, int h, int c)
        : width(w), height(h), channels(c), data(static_cast<size_t>(w) * h * c) {}

    float& at(int x, int y, int c) { return data[index(x, y, c)]; }
    float at(int x, int y, int c) const { return data[index(x, y, c)]; }

private:
    size_t index(int x, int y, int c) const {
        return (static_cast<size_t>(y) * width + x) * channels + c;
    }
};

} // namespace romascope
