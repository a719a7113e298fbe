// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/reuse/screen_reuse.h"

#include <string>
#include <vector>

namespace romascope {

// What a frame is made of and how it is seen; the methods' own knobs stand in their folders.

inline const Knob<std::string> kTracer{{.key = "technique.tracer",
                                        .unit = "",
                                        .help = "The visibility structure that rays are traced in.",
                                        .source = "what this program is for"},
                                       "roma"};
inline const Knob<bool> kAntialias{
    {.key = "frame.antialias",
     .unit = "",
     .help = "Shift the picture by part of a pixel from frame to frame, so that the mean of the "
             "frames covers whole pixels instead of their centres.",
     .source = "off: errors are measured at pixel centres"},
    false};
inline const Knob<int> kWidth{
    {.key = "render.width", .unit = "pixels", .help = "Width of the picture.", .source = "720p"},
    1280,
    1,
    16384};
inline const Knob<int> kHeight{
    {.key = "render.height", .unit = "pixels", .help = "Height of the picture.", .source = "720p"},
    720,
    1,
    16384};
inline const Knob<int> kFrames{{.key = "render.frames",
                                .unit = "frames",
                                .help = "Frames that are accumulated into the picture.",
                                .source = "one frame is what a method costs"},
                               1,
                               1,
                               1000000};
inline const Knob<int64_t> kSeed{
    {.key = "render.seed",
     .unit = "",
     .help = "Seed of every random choice: the same seed gives the same picture.",
     .source = "any number will do"},
    0,
    0,
    4294967295};
inline const Knob<std::string> kCamera{
    {.key = "render.camera",
     .unit = "",
     .help =
         "A camera of the scene by name, or eye/target/vertical fov (metres, metres, degrees) like "
         "1,2,3/0,0,0/60; empty: the scene's first.",
     .source = "the first camera shows the scene best"},
    ""};

inline const Knob<double> kTime{
    {.key = "render.time",
     .unit = "s",
     .help = "Where in its animation the scene stands in the first frame; animations start over at "
             "their end.",
     .source = "the start"},
    0.0,
    0.0,
    1e6};
inline const Knob<double> kFps{
    {.key = "render.fps",
     .unit = "frames per second",
     .help = "How many frames show a second of the animation; 0: time stands still, so that frames "
             "accumulate.",
     .source = "a picture is of one moment"},
    0.0,
    0.0,
    1e6};
inline const Knob<std::string> kAnimation{
    {.key = "render.animation",
     .unit = "",
     .help =
         "The animation of the scene that plays, by name or by number from 0; empty: the first; "
         "none: all stands as without animation.",
     .source = "most files have one"},
    ""};

/// Whether pixels of the frames lie elsewhere in each, all over the area of a pixel in the end.
inline bool is_antialiased(const Settings& settings) {
    return settings.get(kAntialias) || settings.get(kTaa);
}

/// Seconds into the animation that frame `frame`, counted from 0, shows.
double time_of_frame(const Settings& settings, int frame);

/// Every knob of the program, from all methods.
const KnobTable& all_knobs();

/// A named choice of methods and values: one file in config/.
struct Technique {
    std::string name;
    std::string description; ///< the file's first comment line
};

/// In alphabetical order.
const std::vector<Technique>& techniques();

/// Loads the technique's values into the settings. Throws Error (kBadInput) with the nearest name.
void apply_technique(Settings& settings, const std::string& name);

/// From whatever technique the settings have to that one: what apply_technique makes of the
/// defaults, for all that tracers can be told and all that any technique sets; the rest stays.
/// Throws Error (kBadInput) with the nearest name.
void change_technique(Settings& settings, const std::string& name);

} // namespace romascope
