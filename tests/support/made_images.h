// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/image/image.h"

#include <random>
#include <vector>

namespace romascope {

inline Image flat(int width, int height, std::vector<float> color) {
    Image image(width, height, static_cast<int>(color.size()));
    for (size_t i = 0; i < image.data.size(); ++i)
        image.data[i] = color[i % color.size()];
    return image;
}

inline Image random_image(int width, int height, int channels, unsigned seed, float low = 0,
                          float high = 1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(low, high);
    Image image(width, height, channels);
    for (float& v : image.data)
        v = value(random);
    return image;
}

} // namespace romascope
