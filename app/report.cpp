// SPDX-License-Identifier: MIT
#include "app/report.h"

#include "app/build_facts.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace romascope {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no infinities; they are written as the text that --set takes.
Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(to_text(KnobValue(value)));
}

Json vector(glm::vec3 v) { return {v.x, v.y, v.z}; }

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

} // namespace

std::string report_json(const ReportFacts& facts) {
    Json json;
    json["schema"] = kReportSchema;
    json["program"] = {{"version", kVersion}, {"commit", kCommit}};
    json["technique"] = facts.technique.empty() ? Json() : Json(facts.technique);
    json["settings"] = settings_json(*facts.settings);
    json["scene"] = {{"name", facts.scene->name},
                     {"file", facts.scene_file},
                     {"triangles", facts.scene->triangle_count()},
                     {"vertices", facts.scene->positions.size()},
                     {"materials", facts.scene->materials.size()},
                     {"bounds_min_m", vector(facts.scene->bounds.min)},
                     {"bounds_max_m", vector(facts.scene->bounds.max)}};
    json["camera"] = {
        {"name", facts.camera.name},
        {"eye_m", vector(facts.camera.eye)},
        {"forward", vector(facts.camera.forward)},
        {"up", vector(facts.camera.up)},
        {"vertical_fov_degrees", facts.camera.vertical_fov * 180.0 / std::numbers::pi}};
    json["driver"] = {{"backend", facts.backend},          {"gl_version", facts.driver.version},
                      {"glsl_version", facts.driver.glsl}, {"vendor", facts.driver.vendor},
                      {"renderer", facts.driver.renderer}, {"software", facts.driver.software}};
    json["clock"] = name_of(facts.clock);
    json["passes"] = passes_json(facts);
    json["bytes"] = Json::object();
    for (const StructureBytes& structure : facts.bytes)
        json["bytes"][structure.name] = structure.bytes;
    if (facts.errors)
        json["errors"] = {{"reference_samples", facts.errors->samples},
                          {"reference_seconds", facts.errors->reference_seconds},
                          {"reference_from_cache", facts.errors->reference_from_cache},
                          {"flip", facts.errors->flip},
                          {"rmse", facts.errors->rmse},
                          {"mae", facts.errors->mae},
                          {"bias", facts.errors->bias}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string report_table(const ReportFacts& facts) {
    std::string text =
        fmt::format("{:<20} {:>12} {:>12} {:>5}\n", "pass", "median ms", "p95 ms", "n");
    for (const PassTiming& timing : facts.timings) {
        if (timing.milliseconds.empty())
            text += fmt::format("{:<20} {:>12} {:>12} {:>5}\n", timing.pass, "n/a", "n/a", 0);
        else
            text += fmt::format("{:<20} {:>12.4f} {:>12.4f} {:>5}{}\n", timing.pass,
                                timing.median(), timing.percentile_95(), timing.milliseconds.size(),
                                timing.rasterises ? "  rasterises" : "");
    }
    text += fmt::format("clock: {}; {}\n\n{:<20} {:>12}\n", name_of(facts.clock),
                        facts.driver.renderer, "structure", "bytes");
    for (const StructureBytes& structure : facts.bytes)
        text += fmt::format("{:<20} {:>12}\n", structure.name, structure.bytes);
    if (facts.errors)
        text +=
            fmt::format("\nagainst {} samples per pixel ({})\n{:<20} {:>12.6f}\n{:<20} {:>12.6f}\n"
                        "{:<20} {:>12.6f}\n{:<20} {:>+12.6f}\n",
                        facts.errors->samples,
                        facts.errors->reference_from_cache
                            ? "from the cache"
                            : fmt::format("{:.1f} s", facts.errors->reference_seconds),
                        "FLIP", facts.errors->flip, "RMSE", facts.errors->rmse, "MAE",
                        facts.errors->mae, "signed bias", facts.errors->bias);
    return text;
}

} // namespace romascope
