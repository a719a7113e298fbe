// SPDX-License-Identifier: MIT
// The report of a render: what was done, what it cost, how far off it is. The schema is documented
// in docs/user/report.md; kReportSchema changes with it.
#pragma once

#include "renderer/gl/capabilities.h"
#include "renderer/gl/timer.h"
#include "renderer/passes/frame_context.h"
#include "renderer/scene/scene.h"
#include "renderer/settings/settings.h"

#include <optional>
#include <string>
#include <vector>

namespace romascope {

inline constexpr const char* kReportSchema = "romascope-report/1";

/// Errors against the reference.
struct ReportErrors {
    int samples = 0;                   ///< of the reference, per pixel
    double reference_seconds = 0;      ///< of all truths that were made use of
    bool reference_from_cache = false; ///< all of them, before the run
    double flip = 0, rmse = 0, mae = 0, bias = 0;
    std::optional<double> flicker; ///< see Flicker
    std::optional<int> lag;        ///< frames; none after a jump: see LagWatch::value
};

/// A sudden change: from a frame on, counted from 0, the scene stands at another moment.
struct TimeJump {
    int frame = 0;
    double seconds = 0;
};

/// What went wrong in any frame of a flight.
struct FlightFacts {
    std::vector<std::string> stops; ///< cameras that it went through
    /// Pixels, of all frames together, that were black or not finite; of ambient occlusion alone,
    /// where the background is white.
    std::optional<uint64_t> black_pixels;
    std::vector<NamedCount> most; ///< of each count the largest of a frame
};

/// Everything a report holds, gathered while rendering.
struct ReportFacts {
    std::string technique; ///< empty if none was named
    std::string scene_file;
    const Scene* scene = nullptr;
    const Settings* settings = nullptr;
    Camera camera;
    std::string backend; ///< how the context came to be
    DriverFacts driver;
    TimerClock clock = TimerClock::none;
    std::vector<PassTiming> timings;
    std::vector<StructureBytes> bytes;
    std::vector<NamedCount> counts; ///< of the last frame
    std::optional<FlightFacts> flight;
    std::optional<TimeJump> jump;
    std::optional<ReportErrors> errors;
};

/// Pretty-printed JSON, keys in a fixed order.
std::string report_json(const ReportFacts& facts);

/// The errors for people, a line each; empty if there are none.
std::string error_table(const ReportFacts& facts);

/// The same for people: a table of passes, structures and errors.
std::string report_table(const ReportFacts& facts);

} // namespace romascope
