// SPDX-License-Identifier: MIT
// A knob of each kind.
#pragma once

#include "renderer/settings/settings.h"
#include "tests/support/expect_error.h"

#include <limits>

namespace romascope {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

enum class Sampling { snap, candidates, a_trous };

inline const Knob<int> kResolution{{.key = "occupancy.resolution",
                                    .unit = "cells",
                                    .help = "Cells along the longest side.",
                                    .source = "paper, section 4"},
                                   128,
                                   32,
                                   256};
inline const Knob<double> kRadius{
    {.key = "ao.radius", .unit = "m", .help = "Reach of a ray.", .source = "paper, section 5"},
    kInfinity,
    0.0,
    kInfinity};
inline const Knob<double> kBias{
    {.key = "ao.bias", .help = "Any number."}, 0.1, -kInfinity, kInfinity};
inline const Knob<double> kBlend{
    {.key = "reuse.taa.blend", .help = "Weight of the new."}, 0.1, 0.0, 1.0};
inline const Knob<bool> kAntialias{{.key = "reuse.antialias", .help = "Smooth edges."}, false};
inline const Knob<std::string> kCamera{{.key = "view.camera", .help = "Name of a camera."}, ""};
inline const Knob<Sampling> kSampling{{.key = "roma.sampling", .help = "How rays are drawn."},
                                      Sampling::candidates,
                                      {"snap", "candidates", "a-trous"}};
inline const Knob<int64_t> kSeed{
    {.key = "view.seed", .help = "Seed."}, -1, -(int64_t{1} << 53) + 1, (int64_t{1} << 53) - 1};

inline const KnobTable& knobs() {
    // "reuse.taa" comes before "reuse", to have a table of the file after a table inside it.
    static const KnobTable table(
        {&kResolution, &kRadius, &kBlend, &kBias, &kAntialias, &kCamera, &kSampling, &kSeed});
    return table;
}

} // namespace romascope
