// SPDX-License-Identifier: MIT
#include "renderer/metrics/inputs.h"

#include "renderer/base/error.h"

#include <cmath>
#include <string>

namespace romascope {
namespace {

std::string size_text(const Image& image) {
    return std::to_string(image.width) + "x" + std::to_string(image.height) + " with " +
           std::to_string(image.channels) + (image.channels == 1 ? " channel" : " channels");
}

void check_finite(const Image& image, const std::string& role) {
    const size_t channels = static_cast<size_t>(image.channels);
    const size_t width = static_cast<size_t>(image.width);
    for (size_t i = 0; i < image.data.size(); ++i) {
        if (std::isfinite(image.data[i]))
            continue;
        const size_t pixel = i / channels;
        throw Error("cannot compare: the " + role + " image holds " +
                        (std::isnan(image.data[i]) ? "NaN" : "infinity") + " at pixel (" +
                        std::to_string(pixel % width) + ", " + std::to_string(pixel / width) +
                        "), channel " + std::to_string(i % channels),
                    kBadInput);
    }
}

} // namespace

void check_comparable(const Image& reference, const Image& test) {
    const auto supported = [](const Image& image) {
        return image.width > 0 && image.height > 0 && (image.channels == 1 || image.channels == 3);
    };
    if (reference.width != test.width || reference.height != test.height || !supported(reference) ||
        !supported(test))
        throw Error("cannot compare: the reference image is " + size_text(reference) +
                        ", the test image is " + size_text(test) +
                        "; both need the same size, and 1 or 3 channels each",
                    kBadInput);
    check_finite(reference, "reference");
    check_finite(test, "test");
}

} // namespace romascope
