// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/tracers/occupancy/grid_tracer.h"
#include "renderer/tracers/occupancy/leaving_knobs.h"

namespace romascope {

inline const Knob<double> kDdaNormalOffset =
    normal_offset_knob("dda.normal_offset", "fewest wrong rays, see docs/user/error-split.md", 1.0);
inline const Knob<int> kDdaEscape =
    escape_knob("dda.escape", "fewest wrong rays, see docs/user/error-split.md", 2);

std::vector<const KnobBase*> dda_knobs();

/// Rays from cell to cell through the base occupancy map (Amanatides and Woo 1987): the exact
/// answer for its cells.
class DdaTracer final : public GridTracer {
public:
    DdaTracer() : GridTracer("tracers/dda/dda_tracer.glsl", kDdaNormalOffset, kDdaEscape) {}
};

std::unique_ptr<Tracer> make_dda_tracer();

} // namespace romascope
