// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/settings/knob.h"
#include "renderer/tracers/occupancy/invocations.h"

namespace romascope {

enum class OccupancyAxes { all, z };
enum class OccupancyBuilder { raster, compute };
enum class OccupancyCoverage { thin, conservative };

inline const Knob<int> kOccupancyResolution{
    {.key = "occupancy.resolution",
     .unit = "cells",
     .help = "Cells of the occupancy map along the longest side of the scene.",
     .source = "Zeng et al. 2023, section 6"},
    128,
    32,
    256};
inline const Knob<double> kOccupancyJitter{
    {.key = "occupancy.jitter",
     .unit = "cells",
     .help = "How far the occupancy map is shifted at random from frame to frame.",
     .source = "Zeng et al. 2023, section 4.3: objects are jittered for each map"},
    1.0,
    0.0,
    1.0};
inline const Knob<OccupancyBuilder> kOccupancyBuilder{
    {.key = "occupancy.builder",
     .unit = "",
     .help =
         "How the occupancy map is made: rasterised along the axes, as published, or triangle by "
         "triangle in compute.",
     .source = "measured: compute is several times faster, with the same share of wrong rays; "
               "raster: Zeng et al. 2023, section 6"},
    OccupancyBuilder::compute,
    {"raster", "compute"}};
inline const Knob<OccupancyCoverage> kOccupancyCoverage{
    {.key = "occupancy.coverage",
     .unit = "",
     .help = "Cells that a triangle occupies when built in compute: thin, where it crosses a line "
             "through the cell's centre, which leaves no way through a closed surface from face to "
             "face; or conservative, all that it touches.",
     .source = "Laine 2013; Schwarz and Seidel 2010"},
    OccupancyCoverage::thin,
    {"thin", "conservative"}};
inline const Knob<OccupancyAxes> kOccupancyAxes{
    {.key = "occupancy.axes",
     .unit = "",
     .help = "Directions the scene is rasterised along: all three, or z alone, which leaves holes "
             "in steep surfaces.",
     .source = "Zeng et al. 2023, section 6"},
    OccupancyAxes::all,
    {"all", "z"}};
inline const Knob<Invocations> kOccupancyInvocations{
    {.key = "occupancy.invocations",
     .unit = "",
     .help = "Which way the map is built in compute, with the same result: by many small "
             "invocations of the shader, by few large ones without barriers, or whichever suits "
             "the device.",
     .source = "measured: a GPU wants many small invocations, a CPU few without barriers"},
    Invocations::device,
    {"device", "many", "few"}};

} // namespace romascope
