// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace romascope {

class Session;
class UiMap;

/// What frames cost: milliseconds of each pass, bytes of each structure.
class Costs {
public:
    /// Two tables, each with its sum, and what clock was used.
    void draw(Session& session, UiMap& map);
    /// Seconds until numbers are shown that are newer; none while they are the newest.
    std::optional<double> seconds_to_change() const;

private:
    struct Pass {
        std::string name;
        bool rasterises = false;
        double median = 0.0, percentile_95 = 0.0; ///< milliseconds
    };
    struct Structure {
        std::string name;
        size_t bytes = 0;
    };
    void measure(Session& session);
    void draw_passes() const;
    void draw_structures() const;

    std::vector<Pass> passes_;
    std::vector<Structure> structures_;
    std::string clock_;
    std::chrono::steady_clock::time_point measured_;
    bool is_newest_ = true;
};

} // namespace romascope
