// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/image/image.h"

#include <cstddef>

namespace romascope {

/// Mean absolute change of a picture from each frame to the next that the truth does not explain,
/// over all pixels and channels, on linear values.
class Flicker {
public:
    /// The next frame, and what it should show. Both as error_figures takes them, and of the same
    /// size as those before; throws as it does.
    void add(const Image& truth, const Image& picture);
    /// 0 until there are two frames.
    double value() const { return pairs_ ? sum_ / static_cast<double>(pairs_) : 0.0; }

private:
    Image last_error_;
    double sum_ = 0;
    size_t pairs_ = 0;
};

} // namespace romascope
