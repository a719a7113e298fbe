// SPDX-License-Identifier: MIT
// How a ray leaves its own surface: knobs that every tracer in cells has, each under its own key
// and with a default of its own, as what is best differs from method to method.
#pragma once

#include "renderer/settings/knob.h"

namespace romascope {

/// All three must be string literals, as for any knob. The default is in cells.
inline Knob<double> normal_offset_knob(std::string_view key, std::string_view help,
                                       std::string_view source, double default_value) {
    return {{.key = key, .unit = "cells", .help = help, .source = source}, default_value, 0.0, 8.0};
}
inline Knob<double> normal_offset_knob(std::string_view key, std::string_view source,
                                       double default_value) {
    return normal_offset_knob(key, "How far a ray starts off its surface, along the normal.",
                              source, default_value);
}

inline Knob<int> escape_knob(std::string_view key, std::string_view source, int default_value) {
    return {{.key = key,
             .unit = "cells",
             .help = "How many occupied cells a ray may pass at its very start, where it leaves "
                     "its own surface.",
             .source = source},
            default_value,
            0,
            4};
}

} // namespace romascope
