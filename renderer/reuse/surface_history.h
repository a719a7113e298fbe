// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/passes/gbuffer.h"

namespace romascope {

inline const Knob<double> kHistoryPlaneDistance{
    {.key = "history.plane_distance",
     .unit = "pixels",
     .help =
         "How far from the tangent plane of a surface what the previous frame showed may lie to "
         "be the same surface, as seen at its distance; temporal.enabled and taa.enabled.",
     .source = "a step of less than a pixel is not seen as one"},
    1.0,
    0.01,
    100.0};
inline const Knob<double> kHistoryNormalAngle{
    {.key = "history.normal_angle",
     .unit = "degrees",
     .help =
         "How far the normal of what the previous frame showed may be turned away to be the same "
         "surface; temporal.enabled and taa.enabled.",
     .source = "a body that turns once a second turns by 15 degrees in a frame of a 24th"},
    25.0,
    1.0,
    180.0};

/// A distance in pixels as metres for a surface one unit deep.
float pixels_at_unit_depth(const View& view, double pixels);

/// Sets plane_limit and normal_limit, see shaders/reuse/edges.h; in pixels and degrees.
void set_edge_uniforms(const Program& program, const View& view, double plane_distance,
                       double normal_angle);

/// The visible surfaces of the frame before, and the view they were seen in: the host's side of
/// shaders/reuse/previous_surface.glsl.
class SurfaceHistory {
public:
    /// Copies what the frame has seen, at its end.
    void remember(const GBuffer& gbuffer, const View& view);
    void forget() { remembered_ = false; }
    /// Forgets, and holds nothing any more.
    void release() { *this = {}; }
    /// Whether there is a frame before, of that size.
    bool is_of(glm::ivec2 size) const { return remembered_ && view_.size == size; }

    /// Binds the G-buffer and what was before it and sets uniforms, the view's among them. Nothing
    /// that was before is read unless is_of(view.size).
    void bind(const Program& program, const FrameContext& frame, const View& view,
              const GBuffer& gbuffer) const;
    StructureBytes bytes() const { return {"previous surfaces", depth_.bytes() + normal_.bytes()}; }

private:
    Texture depth_, normal_;
    View view_;
    bool remembered_ = false;
};

} // namespace romascope
