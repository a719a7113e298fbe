// SPDX-License-Identifier: MIT
#include "app/split/split_picture.h"

#include <algorithm>
#include <cmath>

namespace romascope {
namespace {

constexpr glm::vec3 kLeak(1.0f, 0.08f, 0.02f), kFalseShadow(0.02f, 0.25f, 1.0f);
constexpr float kTruth = 0.2f; ///< brightness of what is open, beneath the errors

/// Single rays out of many are to be seen, too: half the colour at a quarter of the rays.
float strength(uint64_t count, uint64_t rays) {
    return std::sqrt(static_cast<float>(count) / static_cast<float>(rays));
}

glm::vec3 colour(const Tally& point, const StepErrors& step) {
    const float leak = strength(step.leaks, point.rays);
    const float shadow = strength(step.false_shadows, point.rays);
    const float open = static_cast<float>(point.free) / static_cast<float>(point.rays);
    const float rest = std::max(0.0f, 1.0f - leak - shadow);
    return glm::min(leak * kLeak + shadow * kFalseShadow + rest * kTruth * open, glm::vec3(1.0f));
}

/// Pixels that the captions take, and a height that is enough for anyone.
constexpr int kLegibleWidth = 160, kLargeHeight = 640;

void put(Image& image, int factor, glm::ivec2 pixel, glm::vec3 value) {
    for (int y = 0; y < factor; ++y)
        for (int x = 0; x < factor; ++x)
            for (int channel = 0; channel < 3; ++channel)
                image.at(factor * pixel.x + x, factor * pixel.y + y, channel) = value[channel];
}

} // namespace

int SplitPictures::magnification(glm::ivec2 size) {
    const int wanted = (kLegibleWidth + size.x - 1) / size.x;
    return std::clamp(wanted, 1, std::max(kLargeHeight / size.y, 1));
}

SplitPictures::SplitPictures(const SplitScene& scene, glm::ivec2 size)
    : scene_(scene), size_(size), points_(scene.points().size()) {}

void SplitPictures::add(const std::vector<ChainAnswers>& answers) {
    for (size_t i = 0; i < answers.size(); ++i)
        points_[i].add(answers[i]);
}

std::vector<Image> SplitPictures::of(size_t camera) const {
    const int factor = magnification(size_);
    std::vector<Image> pictures(kSplitCaptions.size(),
                                Image(factor * size_.x, factor * size_.y, 3));
    for (size_t i = 0; i < points_.size(); ++i) {
        const SplitPoint& place = scene_.points()[i];
        const Tally& point = points_[i];
        if (static_cast<size_t>(place.camera) != camera || point.rays == 0)
            continue;
        const float open = static_cast<float>(point.free) / static_cast<float>(point.rays);
        const glm::ivec2 pixel(place.pixel % size_.x, place.pixel / size_.x);
        put(pictures[0], factor, pixel, glm::vec3(open));
        for (size_t step = 0; step < point.steps.size(); ++step)
            put(pictures[step + 1], factor, pixel, colour(point, point.steps[step]));
    }
    return pictures;
}

} // namespace romascope
