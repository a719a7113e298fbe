// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/passes/frame_context.h"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace romascope {

class Session;
class UiMap;

/// What frames cost: milliseconds of each pass, bytes of each structure; and what they counted.
class Costs {
public:
    /// A table of each, times and bytes with their sums, and what clock was used.
    void draw(Session& session, UiMap& map);
    /// Seconds until numbers are shown that are newer; none while they are the newest.
    std::optional<double> seconds_to_change() const;

private:
    struct Pass {
        std::string name;
        bool rasterises = false;
        double median = 0.0, percentile_95 = 0.0; ///< milliseconds
    };
    void measure(Session& session);
    void draw_passes() const;
    void draw_structures() const;
    void draw_counts() const;

    std::vector<Pass> passes_;
    std::vector<StructureBytes> structures_;
    std::vector<NamedCount> counts_;
    std::string clock_;
    std::chrono::steady_clock::time_point measured_;
    bool is_newest_ = true;
};

} // namespace romascope
