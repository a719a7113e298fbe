// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/reuse/atrous_filter.h"
#include "renderer/reuse/taa.h"
#include "renderer/reuse/temporal_accumulation.h"

namespace romascope {

/// Every knob of the stages in ScreenReuse.
std::vector<const KnobBase*> screen_reuse_knobs();

/// The stages that reuse what other pixels and frames have, in any combination: temporal
/// accumulation and a-trous filter for one value per pixel, TAA for the picture made of it.
class ScreenReuse {
public:
    /// Whether a stage looks at the previous frame, so wants to know how surfaces have moved.
    static bool looks_back(const Settings& settings);
    /// What the stages hold, per pixel, of a scene that moves or not.
    static size_t bytes_per_pixel(const Settings& settings, bool moves);

    /// `value`: one channel, in [0, 1]. Returns it if no stage is on, else R16.
    const Texture& filter(const FrameContext& frame, const View& view, const GBuffer& gbuffer,
                          const Texture& value);
    /// Returns the picture itself if TAA is off, else what Taa::run does.
    const Texture& antialias(const FrameContext& frame, const View& view, const GBuffer& gbuffer,
                             const Texture& picture);
    /// Keeps what the next frame looks back at; after the stages.
    void end_frame(const FrameContext& frame, const View& view, const GBuffer& gbuffer);

    /// Draws how long each pixel's history is, to a picture of RGBA32F.
    void draw_history(const FrameContext& frame, const View& view, const GBuffer& gbuffer,
                      const Texture& picture);

    /// The next frame has no history; of the picture alone: it is of something else.
    void reset();
    void reset_picture() { taa_.reset(); }
    std::vector<StructureBytes> bytes() const;

    static ShaderVariant history_view_variant();

private:
    SurfaceHistory before_;
    TemporalAccumulation temporal_;
    AtrousFilter atrous_;
    Taa taa_;
    ProgramSlot history_view_;
};

} // namespace romascope
