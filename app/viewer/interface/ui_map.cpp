// SPDX-License-Identifier: MIT
#include "app/viewer/interface/ui_map.h"

#include "app/json.h"
#include "app/viewer/interface/interface_state.h"
#include "app/viewer/session.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

namespace romascope {
namespace {

constexpr std::chrono::milliseconds kBetweenWrites{100};

const char* name_of(Severity severity) {
    switch (severity) {
    case Severity::info:
        return "info";
    case Severity::notice:
        return "notice";
    case Severity::error:
        break;
    }
    return "error";
}

Json json_of(const KnobValue& value) {
    return std::visit([](const auto& held) { return Json(held); }, value);
}

Json settings_json(const Settings& settings) {
    Json json = Json::object();
    for (const KnobBase* knob : settings.table().all())
        if (!settings.is_default(*knob)) {
            const KnobValue value = settings.value(*knob);
            json[std::string(knob->key())] = json_of(value);
        }
    return json;
}

Json messages_json(const Messages& messages) {
    Json json = Json::array();
    for (const Message& message : messages.all())
        json.push_back({{"severity", name_of(message.severity)},
                        {"text", message.text},
                        {"times", message.times}});
    return json;
}

} // namespace

UiMap::UiMap(std::filesystem::path file)
    : file_(std::move(file)), seen_(std::make_unique<Json>()) {}
UiMap::~UiMap() = default;

void UiMap::begin_frame() { (*seen_)["widgets"] = Json::object(); }

void UiMap::note(std::string_view name) {
    if (file_.empty())
        return;
    const ImVec2 clip_low = ImGui::GetWindowDrawList()->GetClipRectMin();
    const ImVec2 clip_high = ImGui::GetWindowDrawList()->GetClipRectMax();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const float left = std::max(low.x, clip_low.x), right = std::min(high.x, clip_high.x);
    const float top = std::max(low.y, clip_low.y), bottom = std::min(high.y, clip_high.y);
    if (right <= left || bottom <= top)
        return;
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    (*seen_)["widgets"][std::string(name)] = {left * scale.x, top * scale.y, right * scale.x,
                                              bottom * scale.y};
}

void UiMap::note_window(std::string_view name) {
    if (file_.empty())
        return;
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    (*seen_)["widgets"][std::string(name)] = {at.x * scale.x, at.y * scale.y,
                                              (at.x + size.x) * scale.x, (at.y + size.y) * scale.y};
}

void UiMap::finish_frame(Session& session, const InterfaceState& state) {
    if (file_.empty())
        return;
    const ImGuiIO& io = ImGui::GetIO();
    (*seen_)["size"] = {io.DisplaySize.x * io.DisplayFramebufferScale.x,
                        io.DisplaySize.y * io.DisplayFramebufferScale.y};
    (*seen_)["panel"] = state.panel;
    (*seen_)["help"] = state.help;
    (*seen_)["scene"] = session.has_scene() ? session.scene_file().string() : std::string();
    (*seen_)["frames_in_picture"] = session.frame_count();
    (*seen_)["at_rest"] = session.at_rest();
    (*seen_)["settings"] = settings_json(session.settings());
    (*seen_)["messages"] = messages_json(session.messages());
    const std::string now = pretty(*seen_);
    behind_ = now != written_;
    if (behind_ && std::chrono::steady_clock::now() - last_write_ >= kBetweenWrites) {
        written_ = now;
        write(session);
    }
}

void UiMap::write(Session& session) {
    Json numbered = *seen_;
    numbered["frame"] = ImGui::GetFrameCount();
    behind_ = false;
    last_write_ = std::chrono::steady_clock::now();
    try {
        write_file_atomically(file_, pretty(numbered));
    } catch (const Error& error) {
        file_.clear();
        session.messages().tell(Severity::error, error.what());
    }
}

} // namespace romascope
