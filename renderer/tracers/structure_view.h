// SPDX-License-Identifier: MIT
// What views of structures have in common: the knobs that pick one and a place in it.
#pragma once

#include "renderer/gl/program.h"
#include "renderer/settings/settings.h"

#include <string>
#include <vector>

namespace romascope {

class Tracer;

enum class ViewAxis { x, y, z };

inline const Knob<std::string> kViewStructure{
    {.key = "view.structure",
     .unit = "",
     .help = "Which view of the visibility structure frame.view=structure shows, by its name: "
             "occupancy_slice, and what else the tracer has; empty: its first.",
     .source = "every tracer has a first"},
    ""};
inline const Knob<ViewAxis> kViewAxis{
    {.key = "view.axis",
     .unit = "",
     .help = "The axis of the world that slices of the occupancy map lie across.",
     .source = "y is up: a slice is a floor plan"},
    ViewAxis::y,
    {"x", "y", "z"}};
inline const Knob<double> kViewSlice{
    {.key = "view.slice",
     .unit = "",
     .help = "Where a structure is cut for its view, as a fraction of its length across the cut.",
     .source = "the middle"},
    0.5,
    0.0,
    1.0};
inline const Knob<int> kViewMap{
    {.key = "view.map",
     .unit = "",
     .help = "Which of a structure's maps is shown, counted from 0; beyond the last: the last.",
     .source = "the first"},
    0,
    0,
    255};

/// Those that say what a view of a structure shows and change no structure.
std::vector<const KnobBase*> structure_view_knobs();

/// The name of the view that the settings ask of the tracer. Throws Error (kBadInput) that names
/// those it has, if it lacks that one.
std::string chosen_structure_view(const Tracer& tracer, const Settings& settings);

/// The host's part of shaders/tracers/cells.glsl.
void set_cell_view_uniforms(const Program& program, const Settings& settings,
                            const Texture& picture);

} // namespace romascope
