// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/program.h"
#include "renderer/passes/frame_context.h"

namespace romascope {

inline const Knob<bool> kMean{
    {.key = "mean.enabled",
     .unit = "",
     .help =
         "Show the mean of all frames since something changed; else the last frame alone, which is "
         "what a game would show.",
     .source = "a still picture should become clean"},
    true};

/// Mean of all frames since the last reset, for a still camera and scene.
class RunningMean {
public:
    /// `value`: RGBA32F, or one channel of any format. A change of size or format starts anew.
    void add(const FrameContext& frame, const Texture& value);
    /// The value alone, in place of all before it: a copy in 32-bit floats, so that a window and a
    /// file have the same numbers whatever its format. What it costs is told as "last frame".
    void take(const FrameContext& frame, const Texture& value);
    void reset() { count_ = 0; }
    const Texture& mean() const { return mean_; }
    uint32_t count() const { return count_; }
    StructureBytes bytes() const { return {name_, mean_.bytes()}; }

    /// `format`: GL_R32F or GL_RGBA32F.
    static ShaderVariant variant(GLenum format);

private:
    void write(const FrameContext& frame, const Texture& value);

    const char* name_ = "running mean";
    ProgramSlot program_;
    Texture mean_;
    uint32_t count_ = 0;
};

} // namespace romascope
