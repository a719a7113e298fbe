// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace romascope {

/// A fixed set of directions, each of which, or its opposite, stands for all of its stratum: the
/// hemisphere is cut into as many strata of equal size (Zeng et al. 2023, section 4.1).
class CandidateSet {
public:
    /// None: rays keep their own direction.
    CandidateSet() = default;
    /// Unit directions by stratum, row by row; a square number of them.
    explicit CandidateSet(const std::vector<glm::vec3>& by_stratum);

    bool empty() const { return directions_.empty(); }
    /// In the order that GLSL's tracer_candidate has them.
    const std::vector<glm::vec3>& directions() const { return directions_; }

    /// The place of the candidate that stands for a unit direction or its opposite.
    int place_of(glm::vec3 direction) const;
    /// A direction in the stratum of the candidate at `place`: uniform there if `u` is in the unit
    /// square. Which of it and its opposite is open.
    glm::vec3 direction_near(int place, glm::dvec2 u) const;
    /// The candidate that is drawn about a unit normal, with probability proportional to
    /// |normal . c|, for `u` in [0, 1): as the estimator of ambient occlusion does.
    int draw(glm::vec3 normal, float u) const;

private:
    int side_ = 0;
    std::vector<glm::vec3> directions_; ///< by place
    std::vector<int> strata_;           ///< by place
    std::vector<int> places_;           ///< by stratum
};

} // namespace romascope
