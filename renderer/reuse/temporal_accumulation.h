// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/reuse/surface_history.h"

#include <limits>

namespace romascope {

inline const Knob<bool> kTemporal{
    {.key = "temporal.enabled",
     .unit = "",
     .help =
         "Average ambient occlusion over frames along the way of each surface, while camera and "
         "scene move.",
     .source = "off: a method is judged by what it gives itself"},
    false};
inline const Knob<int> kTemporalLength{
    {.key = "temporal.length",
     .unit = "frames",
     .help = "The most frames that a pixel's history counts for.",
     .source = "noise of a sixth (the root of 32) is hard to see; 10 in Zeng et al. 2023"},
    32,
    1,
    4096};
inline const Knob<int> kTemporalFastLength{
    {.key = "temporal.fast_length",
     .unit = "frames",
     .help = "Frames of the short history that the long one is held to.",
     .source = "as few as still tell a change from noise, together with the neighbours"},
    4,
    1,
    64};
inline const Knob<double> kTemporalClamp{
    {.key = "temporal.clamp",
     .unit = "standard deviations",
     .help = "By how much of its noise the long history may differ from the short one; inf: it may "
             "differ by anything.",
     .source = "simulated: at 2 a still picture loses nothing, and a change is seen in 8 frames"},
    2.0,
    0.0,
    std::numeric_limits<double>::infinity()};

/// Averages a value per pixel over frames, by reprojection. History that another surface left, by
/// distance from the tangent plane and by normal, is not used; a long history is held to a short
/// one.
class TemporalAccumulation {
public:
    /// `value`: one channel, in [0, 1]; of this view's size.
    void run(const FrameContext& frame, const View& view, const GBuffer& gbuffer,
             const SurfaceHistory& before, const Texture& value);
    /// What comes next begins anew.
    void reset() { has_history_ = false; }
    /// Holds nothing any more, until the next run.
    void release();
    bool has_history() const { return has_history_; }

    const Texture& result() const { return result_; } ///< R16
    /// RGBA32F: the mean, a mean of few frames, the mean of squares, frames in the mean.
    const Texture& history() const { return history_; }
    StructureBytes bytes() const {
        return {"temporal history", accumulated_.bytes() + history_.bytes() + result_.bytes()};
    }

    static ShaderVariant variant(bool motion);
    static ShaderVariant clamp_variant(bool clamped);

private:
    ProgramSlot program_, clamp_program_;
    Texture accumulated_, history_, result_;
    bool has_history_ = false;
};

} // namespace romascope
