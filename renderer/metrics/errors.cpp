// SPDX-License-Identifier: MIT
#include "renderer/metrics/errors.h"

#include "renderer/metrics/inputs.h"

#include <algorithm>
#include <cmath>

namespace romascope {

ErrorFigures error_figures(const Image& reference, const Image& test) {
    check_comparable(reference, test);
    const int channels = std::max(reference.channels, test.channels);
    const size_t pixels = static_cast<size_t>(reference.width) * reference.height;
    ErrorFigures figures;
    double squares = 0;
    for (size_t i = 0; i < pixels; ++i) {
        for (int c = 0; c < channels; ++c) {
            const double difference = static_cast<double>(channel_value(test, i, c)) -
                                      static_cast<double>(channel_value(reference, i, c));
            squares += difference * difference;
            figures.mae += std::abs(difference);
            figures.bias += difference;
            figures.max_abs = std::max(figures.max_abs, std::abs(difference));
        }
    }
    const double count = static_cast<double>(pixels) * channels;
    figures.rmse = std::sqrt(squares / count);
    figures.mae /= count;
    figures.bias /= count;
    return figures;
}

Image difference_map(const Image& reference, const Image& test) {
    check_comparable(reference, test);
    Image map(reference.width, reference.height, std::max(reference.channels, test.channels));
    for (size_t i = 0; i < map.data.size(); ++i) {
        const size_t pixel = i / static_cast<size_t>(map.channels);
        const int c = static_cast<int>(i % static_cast<size_t>(map.channels));
        map.data[i] = channel_value(test, pixel, c) - channel_value(reference, pixel, c);
    }
    return map;
}

} // namespace romascope
