// SPDX-License-Identifier: MIT
// Counting where along the chain of a method's decisions rays go wrong.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace romascope {

/// What the links of the chain say about one ray: whether it is blocked.
struct ChainAnswers {
    bool truth = false;        ///< the drawn direction, in the triangles, from the surface itself
    bool drawn_cells = false;  ///< the same, in the cells of the occupancy map, off the surface
    bool traced_cells = false; ///< the direction that the method traces instead, in the cells
    bool method = false;       ///< that, by the method
    bool traced_truth = false; ///< that, in the triangles, from the surface itself
};

/// The first three lie one after the other; `whole` is from the first link to the last.
/// `own_direction` leaves the choice of the direction out: from `traced_truth` to `method`.
enum class Step { voxelisation, snapping, resampling, whole, own_direction };
inline constexpr std::array<std::string_view, 5> kStepNames = {
    "voxelisation", "snapping", "resampling", "whole", "own direction"};

/// Rays that change their answer in a step.
struct StepErrors {
    uint64_t leaks = 0;         ///< blocked before, free after
    uint64_t false_shadows = 0; ///< free before, blocked after

    uint64_t wrong() const { return leaks + false_shadows; }
    /// Above 0 the step makes the picture too bright. Those of the first three steps add up to
    /// that of the whole.
    int64_t difference() const {
        return static_cast<int64_t>(leaks) - static_cast<int64_t>(false_shadows);
    }
    void add(bool before, bool after) {
        leaks += before && !after;
        false_shadows += !before && after;
    }
    StepErrors& operator+=(const StepErrors& other) {
        leaks += other.leaks;
        false_shadows += other.false_shadows;
        return *this;
    }
    friend bool operator==(const StepErrors&, const StepErrors&) = default;
};

struct Tally {
    uint64_t rays = 0;
    uint64_t free = 0; ///< in truth
    std::array<StepErrors, kStepNames.size()> steps{};

    const StepErrors& of(Step step) const { return steps[static_cast<size_t>(step)]; }
    StepErrors& of(Step step) { return steps[static_cast<size_t>(step)]; }

    void add(const ChainAnswers& ray) {
        ++rays;
        free += !ray.truth;
        of(Step::voxelisation).add(ray.truth, ray.drawn_cells);
        of(Step::snapping).add(ray.drawn_cells, ray.traced_cells);
        of(Step::resampling).add(ray.traced_cells, ray.method);
        of(Step::whole).add(ray.truth, ray.method);
        of(Step::own_direction).add(ray.traced_truth, ray.method);
    }
    Tally& operator+=(const Tally& other) {
        rays += other.rays;
        free += other.free;
        for (size_t i = 0; i < steps.size(); ++i)
            steps[i] += other.steps[i];
        return *this;
    }
    friend bool operator==(const Tally&, const Tally&) = default;
};

} // namespace romascope
