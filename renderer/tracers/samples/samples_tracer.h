// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/tracers/occupancy/grid_tracer.h"

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
inline const Knob<double> kSamplesNormalOffset{
    {.key = "samples.normal_offset",
     .unit = "cells",
     .help = "How far a ray starts off its surface, along the normal.",
     .source = "as roma.normal_offset"},
    1.5,
    0.0,
    8.0};
inline const Knob<int> kSamplesEscape{
    {.key = "samples.escape",
     .unit = "cells",
     .help = "How many occupied cells a ray may pass at its very start, where it leaves its own "
             "surface.",
     .source = "as roma.escape"},
    0,
    0,
    4};

std::vector<const KnobBase*> samples_knobs();

/// A fixed number of samples of the base occupancy map along a ray (Reinbothe et al. 2009).
class SamplesTracer final : public GridTracer {
public:
    std::string shader_file() const override { return "tracers/samples/samples_tracer.glsl"; }
    std::vector<ShaderDefine> shader_defines(const Settings& settings) const override;
};

std::unique_ptr<Tracer> make_samples_tracer();

} // namespace romascope
