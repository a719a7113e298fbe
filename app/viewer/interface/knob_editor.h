// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/settings/knob.h"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace romascope {

/// A value of a text knob that is known to mean something.
struct KnownName {
    std::string value;
    std::string label; ///< as the list shows it
    std::string help;
};
struct KnownNames {
    std::vector<KnownName> names;
    bool only_these = false; ///< no other text has a meaning
    std::string empty;       ///< what no text at all means
};

/// What a list with `value` chosen shows: the label of the name, or the text itself.
std::string shown_name(const KnownNames& names, const std::string& value);

/// Widgets for the values of knobs.
class KnobEditor {
public:
    /// Lays out the widget, as wide as ImGui's next item. What the user made of the value, if
    /// anything. What was typed is given back as it is, even out of range, and not before it is
    /// complete; by other means values stay in range.
    std::optional<KnobValue> edit(const KnobBase& knob, const KnobValue& value,
                                  const KnownNames& names);
    /// A tick for infinity, which no slider reaches; for knobs whose WidgetSpec says so. Without it
    /// the number is the last one that was seen.
    std::optional<KnobValue> edit_infinity(const KnobBase& knob, double value);

private:
    std::optional<KnobValue> edit_number(const KnobBase& knob, const KnobValue& value);
    std::optional<KnobValue> edit_choice(const KnobBase& knob, const KnobValue& value);
    std::optional<KnobValue> edit_text(const KnobBase& knob, const std::string& value,
                                       const KnownNames& names);

    /// What is in the text field of a number.
    struct Typed {
        const KnobBase* knob = nullptr;
        std::optional<KnobValue> value; ///< none: the one it had
        int frame = 0;                  ///< of ImGui
    };
    Typed typed_;
    std::map<const KnobBase*, double> last_finite_;
};

} // namespace romascope
