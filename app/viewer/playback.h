// SPDX-License-Identifier: MIT
#pragma once

namespace romascope {

/// The course of an animation's time. Times in seconds.
class Playback {
public:
    bool playing() const { return playing_; }
    void play(bool on) { playing_ = on; }
    void toggle() { playing_ = !playing_; }

    /// The time after `elapsed` seconds of the clock on the wall, or after one frame where `fps` is
    /// above 0: an animation of `duration` starts over at its end. Stands where it does not play.
    double advanced(double time, double elapsed, double fps, double duration) const;

private:
    bool playing_ = false;
};

} // namespace romascope
