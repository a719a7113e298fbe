// SPDX-License-Identifier: MIT
#include "app/viewer/playback.h"

#include <cmath>

namespace romascope {

double wrapped_time(double time, double duration) {
    if (duration <= 0.0)
        return 0.0;
    const double rest = std::fmod(time, duration);
    return rest < 0.0 ? rest + duration : rest;
}

double Playback::advanced(double time, double elapsed, double fps, double duration) const {
    if (!playing_ || duration <= 0.0)
        return time;
    return wrapped_time(time + (fps > 0.0 ? 1.0 / fps : elapsed), duration);
}

} // namespace romascope
