// SPDX-License-Identifier: MIT
#pragma once

#include "app/split/split_scene.h"
#include "app/split/tally.h"
#include "renderer/image/image.h"

#include <vector>

namespace romascope {

/// What `SplitPictures::of` gives, from left to right.
inline const std::vector<std::string> kSplitCaptions = {
    "truth", "voxelisation", "snapping", "resampling", "whole", "own direction"};

/// Where the errors of each step lie in the picture of a camera: of a pixel's rays the share of
/// leaks is red, that of false shadows blue, on the truth in dark grey.
class SplitPictures {
public:
    /// How many pixels of a picture show one of this many, per side, so that labels fit over small
    /// ones: an integer.
    static int magnification(glm::ivec2 size);

    SplitPictures(const SplitScene& scene, glm::ivec2 size);
    /// Answers about one ray from each of the scene's points.
    void add(const std::vector<ChainAnswers>& answers);
    /// Linear, 3 channels, magnified.
    std::vector<Image> of(size_t camera) const;

private:
    const SplitScene& scene_;
    glm::ivec2 size_;
    std::vector<Tally> points_;
};

} // namespace romascope
