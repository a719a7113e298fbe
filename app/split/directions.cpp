// SPDX-License-Identifier: MIT
#include "app/split/directions.h"

#include "renderer/reference/sampling.h"
#include "shaders/common/random.h"

namespace romascope {
namespace {

/// A stratum that a normal hardly sees is hardly ever chosen, so this many tries are enough.
constexpr int kMostTries = 4096;

glm::vec3 turned_to(glm::vec3 direction, glm::vec3 towards) {
    return glm::dot(direction, towards) < 0.0f ? -direction : direction;
}

/// Density proportional to |normal . w| within the stratum.
glm::vec3 cosine_in_stratum(const CandidateSet& candidates, int place, glm::vec3 normal,
                            uint32_t random) {
    const auto next = [&] { return double(fraction(random = gpu::pcg_hash(random))); };
    glm::vec3 direction = candidates.directions()[static_cast<size_t>(place)];
    for (int i = 0; i < kMostTries; ++i) {
        const double x = next(), y = next();
        direction = candidates.direction_near(place, {x, y});
        if (next() < std::abs(glm::dot(direction, normal)))
            break;
    }
    return turned_to(direction, normal);
}

} // namespace

std::vector<SplitDirection> draw_directions(const std::vector<SplitPoint>& points,
                                            const CandidateSet& candidates, bool choose,
                                            uint32_t seed, uint32_t frame) {
    // Apart from the numbers that the candidates and the grid are shifted by.
    constexpr uint32_t kSalt = 0x73706c69u;
    std::vector<SplitDirection> directions;
    directions.reserve(points.size());
    for (const SplitPoint& point : points) {
        const uint32_t key = gpu::pcg_hash((seed ^ kSalt) + static_cast<uint32_t>(point.camera));
        const uint32_t first = gpu::pcg_hash(static_cast<uint32_t>(point.pixel) + key);
        SplitDirection& direction = directions.emplace_back();
        if (choose) {
            const float u = gpu::unit_float(gpu::van_der_corput(frame, first));
            direction.place = candidates.draw(point.normal, u);
            direction.traced = turned_to(
                candidates.directions()[static_cast<size_t>(direction.place)], point.normal);
            direction.drawn = cosine_in_stratum(candidates, direction.place, point.normal,
                                                gpu::pcg_hash(first + gpu::pcg_hash(frame)));
            continue;
        }
        const glm::uvec2 u = gpu::r2_sequence(frame, {first, gpu::pcg_hash(first)});
        direction.drawn =
            frame_about(point.normal) * cosine_direction({fraction(u.x), fraction(u.y)});
        direction.traced = direction.drawn;
        if (!candidates.empty()) {
            const int place = candidates.place_of(direction.drawn);
            direction.traced =
                turned_to(candidates.directions()[static_cast<size_t>(place)], direction.drawn);
        }
    }
    return directions;
}

} // namespace romascope
