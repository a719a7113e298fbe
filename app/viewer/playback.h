// SPDX-License-Identifier: MIT
#pragma once

namespace romascope {

/// The same place in an animation that starts over at its end, in [0, duration); 0 if it has none.
double wrapped_time(double time, double duration);

/// The course of an animation's time. Times in seconds.
class Playback {
public:
    bool playing() const { return playing_; }
    void play(bool on) { playing_ = on; }

    /// The time after `elapsed` seconds of the clock on the wall, or after one frame where `fps` is
    /// above 0: an animation of `duration` starts over at its end. Stands where it does not play.
    double advanced(double time, double elapsed, double fps, double duration) const;

private:
    bool playing_ = false;
};

} // namespace romascope
