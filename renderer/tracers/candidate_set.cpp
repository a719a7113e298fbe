// SPDX-License-Identifier: MIT
#include "renderer/tracers/candidate_set.h"

#include "renderer/tracers/roma/directions.h"
#include "shaders/tracers/roma/concentric.h"

#include <cmath>

namespace romascope {

CandidateSet::CandidateSet(const std::vector<glm::vec3>& by_stratum)
    : side_(static_cast<int>(std::lround(std::sqrt(static_cast<double>(by_stratum.size()))))),
      strata_(strata_along_curve(side_)), places_(by_stratum.size()) {
    for (const int stratum : strata_) {
        places_[static_cast<size_t>(stratum)] = static_cast<int>(directions_.size());
        directions_.push_back(by_stratum[static_cast<size_t>(stratum)]);
    }
}

int CandidateSet::place_of(glm::vec3 direction) const {
    return places_[static_cast<size_t>(gpu::stratum_of_direction(direction, side_))];
}

glm::vec3 CandidateSet::direction_near(int place, glm::dvec2 u) const {
    const int stratum = strata_[static_cast<size_t>(place)];
    const glm::dvec2 corner(stratum % side_, stratum / side_);
    return hemisphere_from_square((corner + u) / double(side_));
}

int CandidateSet::draw(glm::vec3 normal, float u) const {
    float total = 0.0f;
    for (const glm::vec3& candidate : directions_)
        total += std::abs(glm::dot(normal, candidate));
    const float target = u * total;
    float sum = 0.0f;
    int place = 0;
    for (size_t i = 0; i + 1 < directions_.size(); ++i) {
        sum += std::abs(glm::dot(normal, directions_[i]));
        place += target >= sum ? 1 : 0;
    }
    return place;
}

} // namespace romascope
