// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/tracers/occupancy/invocations.h"
#include "renderer/tracers/occupancy/leaving_knobs.h"

namespace romascope {

enum class RomaAlignment { rotate, shear };
enum class RomaFit { box, cube };
enum class RomaSampling { snap, candidates };

inline const Knob<RomaAlignment> kRomaAlignment{
    {.key = "roma.alignment",
     .unit = "",
     .help =
         "How the occupancy map is aligned with a candidate: rotated, each cell of a turned map "
         "taking the nearest of the base map, as published; or sheared, slices moved by whole "
         "cells, which loses none.",
     .source = "measured: the shear is built faster and has fewer wrong rays, see "
               "docs/user/error-split.md; rotate: Zeng et al. 2023, Algorithm 1"},
    RomaAlignment::shear,
    {"rotate", "shear"}};
inline const Knob<RomaFit> kRomaFit{
    {.key = "roma.fit",
     .unit = "",
     .help = "With roma.alignment rotate, what a turned map covers: a box that fits the scene at "
             "that turn, or the cube that encloses it at any, whose cells are larger.",
     .source = "box: its cells are smaller; cube: Zeng et al. 2023, Algorithm 1, turns one cube"},
    RomaFit::box,
    {"box", "cube"}};
inline const Knob<int> kRomaTaps{
    {.key = "roma.taps",
     .unit = "cells",
     .help = "With roma.alignment shear, how many cells of a slice are joined to one: the one at "
             "mid-slice, those at both faces, or all that the middle of a column passes.",
     .source = "measured: more taps leak less through thin cells, and darken"},
    1,
    1,
    3};
inline const Knob<int> kRomaAngularResolution{
    {.key = "roma.angular_resolution",
     .unit = "strata per side",
     .help = "Candidate directions per frame, as the square root of their number.",
     .source = "Zeng et al. 2023, section 6"},
    4,
    2,
    16};
inline const Knob<bool> kRomaDirectionJitter{
    {.key = "roma.direction_jitter",
     .unit = "",
     .help = "New candidate directions every frame, each at random in its stratum; else the middle "
             "of each stratum.",
     .source = "Zeng et al. 2023, section 4.3"},
    true};
inline const Knob<double> kRomaNormalOffset = normal_offset_knob(
    "roma.normal_offset",
    "How far a ray starts off its surface, along the normal. With roma.alignment shear, a cell is "
    "one of the occupancy map; with rotate, one of the cube that encloses the scene at any turn, "
    "as published, which is longer: 1.7 times in a cubic scene, 1.2 times in one twice as long "
    "as wide and high.",
    "fewest wrong rays, see docs/user/error-split.md; 1.5: Zeng et al. 2023, section 6", 0.5);
inline const Knob<int> kRomaEscape = escape_knob(
    "roma.escape", "fewest wrong rays, see docs/user/error-split.md; 0: as published", 2);
inline const Knob<RomaSampling> kRomaSampling{
    {.key = "roma.sampling",
     .unit = "",
     .help = "How rays become candidates: snapped to the candidate of their stratum, as published, "
             "or chosen among the candidates by cosine, each turned to the side of the normal.",
     .source = "candidates: no ray falls below its surface"},
    RomaSampling::candidates,
    {"snap", "candidates"}};
inline const Knob<bool> kRomaSnap{
    {.key = "roma.snap",
     .unit = "",
     .help = "Rays are snapped to candidates, which takes constant time; else they keep their "
             "direction and pass from column to column, and roma.sampling has no meaning.",
     .source = "Zeng et al. 2023, section 4.2: for rays over the whole hemisphere"},
    true};
inline const Knob<int> kRomaIterations{
    {.key = "roma.iterations",
     .unit = "columns",
     .help = "With roma.snap off, how many columns a ray may pass; what is left of it goes on "
             "snapped, and is counted.",
     .source = "Zeng et al. 2023, section 4.2: enough for soft shadows"},
    8,
    1,
    64};
inline const Knob<Invocations> kRomaInvocations{
    {.key = "roma.invocations",
     .unit = "",
     .help = "Which way the maps are generated, with the same result: by many small invocations of "
             "the shader, by few large ones without barriers, or whichever suits the device.",
     .source = "measured: a GPU wants many small invocations, a CPU few without barriers"},
    Invocations::device,
    {"device", "many", "few"}};

} // namespace romascope
