// SPDX-License-Identifier: MIT
#pragma once

#include "app/viewer/interface/knob_editor.h"
#include "app/viewer/interface/knob_groups.h"

#include <map>
#include <string>
#include <vector>

namespace romascope {

class Session;
class UiMap;

/// All knobs of a session, generated from their declarations.
class KnobList {
public:
    /// Filter, reset of all, and a header for each group with a row for each knob.
    /// `filter`: shows only knobs that match it.
    void draw(Session& session, std::string& filter, UiMap& map);

private:
    void draw_group(const KnobGroup& group, Session& session, const std::string& filter,
                    UiMap& map);
    void draw_row(const KnobBase& knob, Session& session, UiMap& map);

    KnobEditor editor_;
    std::map<std::string_view, bool> in_use_; ///< groups, in the frame before
};

} // namespace romascope
