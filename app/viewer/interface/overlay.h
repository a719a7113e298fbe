// SPDX-License-Identifier: MIT
#pragma once

#include "app/viewer/interface/interface_state.h"
#include "app/viewer/messages.h"

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace romascope {

class UiMap;

/// Seconds that a message stays; none: until it is dismissed. While the panel is hidden, notices
/// are not shown, and the rest not for long, but for errors.
std::optional<double> seconds_shown(Severity severity, bool panel);

/// What lies over the picture: messages, the newest on top, and the help.
class Overlay {
public:
    /// `left`: where the picture is free, from the left, in ImGui's units.
    void draw(const Messages& messages, InterfaceState& state, float left, UiMap& map);
    /// Seconds until the next message goes away by itself.
    std::optional<double> seconds_to_change() const { return seconds_to_change_; }

private:
    void draw_messages(const Messages& messages, bool panel, float left, UiMap& map);
    bool is_dismissed(const Message& message) const;

    using Time = std::chrono::steady_clock::time_point;
    std::vector<std::pair<Time, std::string>> dismissed_;
    std::optional<double> seconds_to_change_;
};

/// The keys and gestures, made from their list.
void draw_help(bool& open, UiMap& map);

} // namespace romascope
