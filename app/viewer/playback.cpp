// SPDX-License-Identifier: MIT
#include "app/viewer/playback.h"

#include <cmath>

namespace romascope {

double Playback::advanced(double time, double elapsed, double fps, double duration) const {
    if (!playing_ || duration <= 0.0)
        return time;
    return std::fmod(time + (fps > 0.0 ? 1.0 / fps : elapsed), duration);
}

} // namespace romascope
