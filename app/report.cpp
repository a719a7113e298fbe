// SPDX-License-Identifier: MIT
#include "app/report.h"

#include "app/build_facts.h"
#include "app/json.h"
#include "app/scene_facts.h"
#include "renderer/frame/technique.h"
#include "renderer/scene/pose.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace romascope {
namespace {

/// JSON has no infinities; they are written as the text that --set takes.
Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(to_text(KnobValue(value)));
}

Json settings_json(const Settings& settings) {
    Json json = Json::object();
    for (const KnobBase* knob : settings.table().all()) {
        const KnobValue value = settings.value(*knob);
        const std::string key(knob->key());
        if (const double* real = std::get_if<double>(&value))
            json[key] = number(*real);
        else
            std::visit([&](const auto& plain) { json[key] = plain; }, value);
    }
    return json;
}

Json time_json(const Scene& scene, const Settings& settings, const std::optional<TimeJump>& jump) {
    const int animation = find_animation(scene, settings.get(kAnimation));
    const auto& animations = scene.motion.animations;
    return {{"animation",
             animation < 0 ? Json() : Json(animations[static_cast<size_t>(animation)].name)},
            {"first_s", time_of_frame(settings, 0)},
            {"last_s", jump ? jump->seconds : time_of_frame(settings, settings.get(kFrames) - 1)}};
}

Json passes_json(const ReportFacts& facts) {
    Json json = Json::array();
    for (const PassTiming& timing : facts.timings) {
        Json pass = {{"name", timing.pass}, {"rasterises", timing.rasterises}};
        if (timing.milliseconds.empty())
            pass["median_ms"] = pass["p95_ms"] = "n/a";
        else {
            pass["median_ms"] = timing.median();
            pass["p95_ms"] = timing.percentile_95();
        }
        pass["n"] = timing.milliseconds.size();
        json.push_back(std::move(pass));
    }
    return json;
}

std::string count_table(const char* title, const std::vector<NamedCount>& counts) {
    std::string text;
    if (!counts.empty())
        text += fmt::format("\n{:<20} {:>12}\n", title, "count");
    for (const NamedCount& counted : counts)
        text += fmt::format("{:<20} {:>12}{}\n", counted.name, counted.count,
                            counted.of ? fmt::format("  {:.1f} %", counted.share()) : "");
    return text;
}

} // namespace

std::string report_json(const ReportFacts& facts) {
    Json json;
    json["schema"] = kReportSchema;
    json["program"] = {{"version", kVersion}, {"commit", kCommit}};
    json["technique"] = facts.technique.empty() ? Json() : Json(facts.technique);
    json["settings"] = settings_json(*facts.settings);
    json["scene"] = scene_summary(*facts.scene, facts.scene_file);
    json["camera"] = camera_json(facts.camera);
    json["time"] = time_json(*facts.scene, *facts.settings, facts.jump);
    json["driver"] = {{"backend", facts.backend},          {"gl_version", facts.driver.version},
                      {"glsl_version", facts.driver.glsl}, {"vendor", facts.driver.vendor},
                      {"renderer", facts.driver.renderer}, {"software", facts.driver.software}};
    json["clock"] = name_of(facts.clock);
    json["passes"] = passes_json(facts);
    json["bytes"] = Json::object();
    for (const StructureBytes& structure : facts.bytes)
        json["bytes"][structure.name] = structure.bytes;
    json["counts"] = Json::object();
    for (const NamedCount& counted : facts.counts)
        json["counts"][counted.name] = counted.count;
    if (facts.flight) {
        json["flight"] = {{"cameras", facts.flight->stops}};
        if (facts.flight->black_pixels)
            json["flight"]["black_pixels"] = *facts.flight->black_pixels;
        json["flight"]["most"] = Json::object();
        for (const NamedCount& counted : facts.flight->most)
            json["flight"]["most"][counted.name] = counted.count;
    }
    if (facts.jump)
        json["jump"] = {{"frame", facts.jump->frame}, {"seconds", facts.jump->seconds}};
    if (facts.errors) {
        json["errors"] = {{"reference_samples", facts.errors->samples},
                          {"reference_seconds", facts.errors->reference_seconds},
                          {"reference_from_cache", facts.errors->reference_from_cache},
                          {"flip", facts.errors->flip},
                          {"rmse", facts.errors->rmse},
                          {"mae", facts.errors->mae},
                          {"bias", facts.errors->bias}};
        if (facts.errors->flicker)
            json["errors"]["flicker"] = *facts.errors->flicker;
        if (facts.errors->lag)
            json["errors"]["lag_frames"] = *facts.errors->lag;
    }
    return pretty(json);
}

std::string error_table(const ReportFacts& facts) {
    if (!facts.errors)
        return {};
    const ReportErrors& errors = *facts.errors;
    std::string text = fmt::format("against {} samples per pixel ({})\n", errors.samples,
                                   errors.reference_from_cache
                                       ? "from the cache"
                                       : fmt::format("{:.1f} s", errors.reference_seconds));
    text += fmt::format("{:<20} {:>12.6f}\n", "FLIP", errors.flip);
    text += fmt::format("{:<20} {:>12.6f}\n", "RMSE", errors.rmse);
    text += fmt::format("{:<20} {:>12.6f}\n", "MAE", errors.mae);
    text += fmt::format("{:<20} {:>+12.6f}\n", "signed bias", errors.bias);
    if (errors.flicker)
        text += fmt::format("{:<20} {:>12.6f}\n", "flicker", *errors.flicker);
    if (errors.lag)
        text += fmt::format("{:<20} {:>12}\n", "lag in frames", *errors.lag);
    else if (facts.jump)
        text += "no lag: the jump changes ambient occlusion nowhere by 0.2\n";
    return text;
}

std::string report_table(const ReportFacts& facts) {
    const Settings& settings = *facts.settings;
    std::string text = fmt::format(
        "{}, {} {}, {}x{}, {} frames, seed {}{}\n\n", facts.scene->name,
        facts.flight ? "flight through" : "camera",
        facts.flight ? fmt::format("{}", fmt::join(facts.flight->stops, ", ")) : facts.camera.name,
        settings.get(kWidth), settings.get(kHeight), settings.get(kFrames), settings.get(kSeed),
        facts.technique.empty() ? "" : fmt::format(", technique {}", facts.technique));
    text += fmt::format("{:<20} {:>12} {:>12} {:>5}\n", "pass", "median ms", "p95 ms", "n");
    double total_ms = 0;
    for (const PassTiming& timing : facts.timings) {
        if (timing.milliseconds.empty()) {
            text += fmt::format("{:<20} {:>12} {:>12} {:>5}\n", timing.pass, "n/a", "n/a", 0);
            continue;
        }
        total_ms += timing.median();
        text += fmt::format("{:<20} {:>12.4f} {:>12.4f} {:>5}{}\n", timing.pass, timing.median(),
                            timing.percentile_95(), timing.milliseconds.size(),
                            timing.rasterises ? "  rasterises" : "");
    }
    text += fmt::format("{:<20} {:>12.4f}\n", "sum of medians", total_ms);
    if (settings.get(kFrames) == 1)
        text += "one frame only: its times include compiling the shaders\n";
    text += fmt::format("clock: {}; {}\n\n{:<20} {:>12}\n", name_of(facts.clock),
                        facts.driver.renderer, "structure", "bytes");
    size_t total_bytes = 0;
    for (const StructureBytes& structure : facts.bytes) {
        text += fmt::format("{:<20} {:>12}\n", structure.name, structure.bytes);
        total_bytes += structure.bytes;
    }
    text += fmt::format("{:<20} {:>12}\n", "sum", total_bytes);
    text += count_table("last frame", facts.counts);
    if (facts.flight) {
        text += count_table("most in a frame", facts.flight->most);
        if (facts.flight->black_pixels)
            text += fmt::format("\n{:<20} {:>12}  in all frames\n", "black pixels",
                                *facts.flight->black_pixels);
    }
    if (facts.errors) {
        text += '\n';
        text += error_table(facts);
    }
    return text;
}

} // namespace romascope
