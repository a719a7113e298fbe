// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/tracers/occupancy/grid_tracer.h"
#include "renderer/tracers/occupancy/leaving_knobs.h"

namespace romascope {

inline const Knob<int> kSamplesCount{
    {.key = "samples.count",
     .unit = "per ray",
     .help = "Cells that are looked up along a ray, evenly from its start to its end or to where "
             "it leaves the map.",
     .source = "any small number: few see little, many are no faster than going from cell to cell"},
    16,
    1,
    256};
inline const Knob<double> kSamplesNormalOffset = normal_offset_knob(
    "samples.normal_offset", "fewest wrong rays, see docs/user/error-split.md", 0.5);
inline const Knob<int> kSamplesEscape =
    escape_knob("samples.escape", "fewest wrong rays, see docs/user/error-split.md", 2);

std::vector<const KnobBase*> samples_knobs();

/// A fixed number of samples of the base occupancy map along a ray (Reinbothe et al. 2009).
class SamplesTracer final : public GridTracer {
public:
    SamplesTracer()
        : GridTracer("tracers/samples/samples_tracer.glsl", kSamplesNormalOffset, kSamplesEscape,
                     {&kSamplesCount}) {}
};

std::unique_ptr<Tracer> make_samples_tracer();

} // namespace romascope
