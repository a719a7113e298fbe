// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/reuse/surface_history.h"

#include <array>

namespace romascope {

inline const Knob<bool> kAtrous{
    {.key = "atrous.enabled",
     .unit = "",
     .help = "Average ambient occlusion over neighbours on the same surface.",
     .source = "off: a method is judged by what it gives itself"},
    false};
inline const Knob<int> kAtrousIterations{
    {.key = "atrous.iterations",
     .unit = "",
     .help =
         "How often the filter runs, each time over twice the distance: reaches 2, 6, 14, 30 or 62 "
         "pixels.",
     .source = "3: on the built-in scenes more lose as much in contacts as they gain in noise"},
    3,
    1,
    5};
inline const Knob<double> kAtrousPlaneDistance{
    {.key = "atrous.plane_distance",
     .unit = "pixels",
     .help = "How far from the tangent plane of a surface a neighbour may lie to be averaged with "
             "it, as "
             "seen at its distance; those that lie off it count less.",
     .source = "a step of less than a pixel is not seen as one"},
    1.0,
    0.01,
    100.0};
inline const Knob<double> kAtrousNormalAngle{
    {.key = "atrous.normal_angle",
     .unit = "degrees",
     .help =
         "How far a neighbour's normal may be turned away to be averaged; those that are turned "
         "count less.",
     .source = "curved surfaces of few triangles have no seams with it"},
    25.0,
    1.0,
    180.0};

/// Averages a value per pixel over neighbours, in a few iterations of an a-trous wavelet transform
/// (Dammertz et al. 2010, Edge-Avoiding A-Trous Wavelet Transform for fast Global Illumination
/// Filtering). Edges are where the distance from the tangent plane or the normal says so; nothing
/// is averaged across them.
class AtrousFilter {
public:
    /// `value`: one channel, in [0, 1]; of this view's size. Returns the outcome, R16.
    const Texture& run(const FrameContext& frame, const View& view, const GBuffer& gbuffer,
                       const Texture& value);
    /// Holds nothing any more, until the next run.
    void release() { filtered_ = {}; }
    StructureBytes bytes() const {
        return {"a-trous filter", filtered_[0].bytes() + filtered_[1].bytes()};
    }

    static ShaderVariant variant();

private:
    ProgramSlot program_;
    std::array<Texture, 2> filtered_;
};

} // namespace romascope
