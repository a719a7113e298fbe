// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/reuse/surface_history.h"

#include <array>

namespace romascope {

inline const Knob<bool> kTaa{
    {.key = "taa.enabled",
     .unit = "",
     .help =
         "Temporal antialiasing: shift the picture by part of a pixel from frame to frame, and mix "
         "each frame with what was seen of its surfaces before.",
     .source = "off: errors are measured at pixel centres"},
    false};
inline const Knob<int> kTaaLength{
    {.key = "taa.length",
     .unit = "frames",
     .help = "The most frames that a pixel's history counts for.",
     .source = "a new frame then has a tenth of the picture, as is usual"},
    10,
    1,
    4096};
inline const Knob<double> kTaaClamp{
    {.key = "taa.clamp",
     .unit = "standard deviations",
     .help = "How far from the mean of the 3 x 3 neighbours of a frame, in YCoCg of linear light, "
             "history may lie.",
     .source = "1 in Salvi 2016, An Excursion in Temporal Supersampling"},
    1.0,
    0.0,
    100.0};

/// Temporal antialiasing of a picture. Who draws the frames shifts them by View::offset.
class Taa {
public:
    /// `picture`: RGBA32F, or one channel of any format; of this view's size. Returns the outcome:
    /// RGBA32F, whose fourth channel counts frames, or R32F.
    const Texture& run(const FrameContext& frame, const View& view, const GBuffer& gbuffer,
                       const SurfaceHistory& before, const Texture& picture);
    /// What comes next begins anew.
    void reset() { has_history_ = false; }
    /// Holds nothing any more, until the next run.
    void release();
    StructureBytes bytes() const {
        return {"taa history", history_[0].bytes() + history_[1].bytes() + result_.bytes()};
    }

    static ShaderVariant variant(bool single_channel, bool motion);

private:
    ProgramSlot program_;
    std::array<Texture, 2> history_; ///< the last frame's at 0
    Texture result_;                 ///< of a single channel
    GLenum format_ = 0;              ///< of the picture
    bool has_history_ = false;
};

} // namespace romascope
