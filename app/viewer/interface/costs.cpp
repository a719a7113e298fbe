// SPDX-License-Identifier: MIT
#include "app/viewer/interface/costs.h"

#include "app/viewer/interface/ui_map.h"
#include "app/viewer/session.h"
#include "renderer/base/memory.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cmath>

namespace romascope {
namespace {

using Clock = std::chrono::steady_clock;

/// Numbers that change faster cannot be read.
constexpr std::chrono::duration<double> kBetween{0.25};
constexpr float kNumberWidth = 5.2f; ///< of a column, in heights of the font

void text_right(const std::string& text) {
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::fmax(room, 0.0f));
    ImGui::TextUnformatted(text.c_str());
}

bool begin_table(const char* id, int numbers) {
    if (!ImGui::BeginTable(id, 1 + numbers, ImGuiTableFlags_SizingFixedFit))
        return false;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
    for (int i = 0; i < numbers; ++i)
        ImGui::TableSetupColumn("number", ImGuiTableColumnFlags_WidthFixed,
                                ImGui::GetFontSize() * kNumberWidth);
    return true;
}

void row(const std::string& name, std::initializer_list<std::string> numbers) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name.c_str());
    for (const std::string& number : numbers) {
        ImGui::TableNextColumn();
        text_right(number);
    }
}

void heading(const std::string& name, std::initializer_list<std::string> numbers) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    row(name, numbers);
    ImGui::PopStyleColor();
}

void sum_row(std::initializer_list<std::string> numbers) {
    row("sum", numbers);
    ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, ImGui::GetColorU32(ImGuiCol_Header));
}

std::string milliseconds(double value) {
    return std::isfinite(value) ? fmt::format("{:.3f}", value) : "...";
}

} // namespace

void Costs::measure(Session& session) {
    Pipeline& pipeline = *session.pipeline();
    clock_ = name_of(pipeline.timer().clock());
    passes_.clear();
    for (const PassTiming& timing : pipeline.timer().timings())
        if (!timing.milliseconds.empty())
            passes_.push_back(
                {timing.pass, timing.rasterises, timing.median(), timing.percentile_95()});
    structures_ = pipeline.bytes();
    counts_.clear();
    if (session.frame_count() > 0)
        counts_ = pipeline.counts();
    measured_ = Clock::now();
}

std::optional<double> Costs::seconds_to_change() const {
    if (is_newest_)
        return std::nullopt;
    const std::chrono::duration<double> passed = Clock::now() - measured_;
    return std::fmax(0.0, (kBetween - passed).count());
}

void Costs::draw(Session& session, UiMap& map) {
    if (!session.has_scene()) {
        ImGui::TextDisabled("No scene.");
        return;
    }
    const std::string frames =
        fmt::format("{} of {} frames", session.frame_count(), session.settings().get(kFrames));
    ImGui::Text("%s%s", frames.c_str(),
                session.failed()    ? ", failed"
                : session.at_rest() ? ", at rest"
                                    : "");
    map.note("frames");
    const bool due = Clock::now() - measured_ >= kBetween;
    if (due)
        measure(session);
    is_newest_ = due && session.at_rest();
    draw_passes();
    draw_structures();
    draw_counts();
}

void Costs::draw_passes() const {
    if (passes_.empty() || !begin_table("##passes", 2))
        return;
    heading("milliseconds", {"median", "95 %"});
    double sum = 0.0;
    bool any_rasterises = false;
    for (const Pass& pass : passes_) {
        row(pass.rasterises ? pass.name + " *" : pass.name,
            {milliseconds(pass.median), milliseconds(pass.percentile_95)});
        sum += pass.median;
        any_rasterises = any_rasterises || pass.rasterises;
    }
    sum_row({milliseconds(sum), ""});
    ImGui::EndTable();
    ImGui::TextDisabled("by %s", clock_.c_str());
    if (any_rasterises)
        ImGui::TextDisabled("* draws triangles");
}

void Costs::draw_structures() const {
    if (structures_.empty() || !begin_table("##structures", 1))
        return;
    heading("memory", {""});
    size_t sum = 0;
    for (const StructureBytes& structure : structures_) {
        row(structure.name, {format_bytes(structure.bytes)});
        sum += structure.bytes;
    }
    sum_row({format_bytes(sum)});
    ImGui::EndTable();
}

void Costs::draw_counts() const {
    if (counts_.empty() || !begin_table("##counts", 1))
        return;
    heading("counted in the last frame", {""});
    for (const NamedCount& count : counts_)
        row(count.name, {count.of ? fmt::format("{:.1f} %  {}", count.share(), count.count)
                                  : fmt::format("{}", count.count)});
    ImGui::EndTable();
}

} // namespace romascope
