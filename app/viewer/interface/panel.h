// SPDX-License-Identifier: MIT
#pragma once

#include "app/scene_files.h"
#include "app/viewer/interface/costs.h"
#include "app/viewer/interface/interface_state.h"
#include "app/viewer/interface/knob_list.h"

#include <optional>
#include <string>
#include <vector>

namespace romascope {

class Session;
class UiMap;

/// The panel at the left edge, as high as the window, and what frames cost at the right one.
class Panel {
public:
    Panel();
    /// Lays both out and does what the user asks of the session; the rest is requested.
    void draw(Session& session, InterfaceState& state, const Activity& activity, UiMap& map,
              Requests& requests);
    /// Where the panel ends, from the left, in ImGui's units.
    float right_edge() const { return right_edge_; }
    /// How wide the user has made it, in heights of the font. A window without so much room shows
    /// it narrower.
    float width() const { return width_; }
    void set_width(float font_heights);
    /// Seconds until it shows something newer by itself; none while it does not.
    std::optional<double> seconds_to_change() const {
        return costs_shown_ ? costs_.seconds_to_change() : std::nullopt;
    }
    /// It is not laid out in this frame.
    void hide() { costs_shown_ = false; }

private:
    bool begin_panel();
    void draw_scene(Session& session, UiMap& map, Requests& requests);
    void draw_camera(Session& session, UiMap& map);
    void draw_time(Session& session, UiMap& map);
    void draw_technique(Session& session, UiMap& map);
    void draw_picture(Session& session, InterfaceState& state, const Activity& activity, UiMap& map,
                      Requests& requests);
    void draw_costs(Session& session, UiMap& map);
    void draw_costs_window(Session& session, UiMap& map);

    std::vector<BuiltInScene> built_in_ = built_in_scenes();
    std::string path_; ///< what is being written of a scene's path
    KnobList knobs_;
    Costs costs_;
    bool costs_shown_ = false; ///< in the last frame
    float right_edge_ = 0.0f;
    float width_;               ///< as the user has it, in heights of the font
    float shown_width_ = 0.0f;  ///< in the frame before, in ImGui's units
    float screen_width_ = 0.0f; ///< in the frame before
    float font_height_ = 0.0f;  ///< in the frame before
};

} // namespace romascope
