// SPDX-License-Identifier: MIT
// The rotation and its tracing: GPU against the CPU twin, bit for bit, and both against a walk in
// double precision that shares no code with them.
#include "tests/gl/roma_rays.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace romascope {
namespace {

struct Case {
    glm::ivec3 size;
    int side, angular;
    double density;
};

class RomaTest : public AlignedMapsTest {
protected:
    RomaTest() {
        settings_.set(kRomaAlignment, RomaAlignment::rotate);
        settings_.set(kRomaNormalOffset, 1.5);
        settings_.set(kRomaEscape, 0);
    }
    void prepare(const Case& c, unsigned seed) {
        settings_.set(kOccupancyResolution, c.side);
        settings_.set(kRomaAngularResolution, c.angular);
        tracer_ = RomaTracer();
        align_random_grid(c.size, c.density, seed);
        maps_.clear();
        for (const gpu::RomaDirection& direction : tracer_.rotation().directions())
            maps_.push_back(rotate_on_cpu(base_, direction, c.side));
    }

    gpu::RomaRay on_cpu(const RomaTestRay& ray, int map, bool forward) const {
        const glm::vec3 relative = glm::vec3(ray.point) - bounds_.centre();
        return gpu::roma_ray(maps_[static_cast<size_t>(map)].direction, forward, relative,
                             glm::vec3(ray.normal), ray.direction.w,
                             settings_.get(kOccupancyResolution));
    }

    float distance_on_cpu(const RomaTestRay& ray, int map, bool forward) const {
        const AlignedMap& aligned = maps_[static_cast<size_t>(map)];
        const auto hit = closest_hit_on_cpu(aligned, on_cpu(ray, map, forward));
        return hit ? *hit * aligned.direction.row_v.w : -1.0f;
    }

    std::vector<AlignedMap> maps_;
};

class RomaCases : public RomaTest, public testing::WithParamInterface<Case> {};

TEST_P(RomaCases, RotationEqualsItsTwinBitForBit) {
    prepare(GetParam(), 11);
    size_t set = 0;
    for (size_t i = 0; i < maps_.size(); ++i) {
        const std::vector<uint32_t> words = tracer_.rotation().download_map(static_cast<int>(i));
        ASSERT_EQ(words.size(), maps_[i].words.size());
        EXPECT_EQ(words, maps_[i].words) << "map " << i;
        for (const uint32_t word : words)
            set += static_cast<size_t>(std::popcount(word));
    }
    EXPECT_GT(set, 0u);
}

TEST_P(RomaCases, TracingEqualsItsTwinBitForBit) {
    prepare(GetParam(), 12);
    const std::vector<RomaTestRay> rays = random_rays(20000);
    const std::vector<RomaTestResult> results = trace(rays);
    const RomaTwin twin{[&](const RomaTestRay& ray, int map, bool forward) {
                            return distance_on_cpu(ray, map, forward);
                        },
                        [&](int map, glm::vec3 direction) {
                            return gpu::roma_is_forward(maps_[static_cast<size_t>(map)].direction,
                                                        direction);
                        }};
    const size_t hits = expect_twins(rays, results, twin);
    for (size_t i = 0; i < rays.size(); ++i) {
        const int map = rays[i].choice.x;
        const bool hit = any_hit_on_cpu(maps_[static_cast<size_t>(map)],
                                        on_cpu(rays[i], map, rays[i].choice.y != 0));
        ASSERT_EQ(results[i].given.x != 0.0f, hit) << "ray " << i;
    }
    EXPECT_GT(hits, rays.size() / 20);
    EXPECT_LT(hits, rays.size() * 19 / 20);
}

/// Walks the cells of the aligned map that a ray passes, in double precision and world space: the
/// centre of each is looked up in the base grid. Nothing if rounding could decide either way.
std::optional<double> walk(const BitGrid& base, const OccupancyGrid& grid, glm::dvec3 centre,
                           const gpu::RomaDirection& map, bool forward, int side, double offset,
                           glm::dvec3 point, glm::dvec3 normal, double t_max, bool& ambiguous) {
    // Turn and size of the map are read from its description: they are a choice and no claim.
    struct {
        glm::dvec3 centre, cell;
        glm::dmat3 axes;
    } box{centre, {}, {}};
    const glm::dvec3 rows[] = {glm::vec3(map.row_u), glm::vec3(map.row_v), glm::vec3(map.row_w)};
    for (int axis = 0; axis < 3; ++axis) {
        box.cell[axis] = 1.0 / glm::length(rows[axis]);
        box.axes[axis] = rows[axis] * box.cell[axis];
    }
    const auto to_box = [&](glm::dvec3 p) {
        return glm::transpose(box.axes) * (p - box.centre) / box.cell + 0.5 * side;
    };
    const glm::dvec3 start = to_box(point + normal * offset);
    const double surface = to_box(point).z;
    const auto near_border = [](double x) { return std::abs(x - std::round(x)) < 2e-3; };
    ambiguous = near_border(start.x) || near_border(start.y) || near_border(start.z);
    const int i = static_cast<int>(std::floor(start.x)), j = static_cast<int>(std::floor(start.y));
    if (i < 0 || j < 0 || i >= side || j >= side)
        return std::nullopt;
    const int begin = std::clamp(static_cast<int>(std::floor(start.z)), -1, side);
    for (int k = begin; forward ? k < side : k >= 0; k += forward ? 1 : -1) {
        if (k < 0 || k >= side)
            continue; // outside, but on the way in
        const double entry = (forward ? k - surface : surface - (k + 1)) * box.cell.z;
        ambiguous = ambiguous || std::abs(entry - t_max) < 2e-3 * box.cell.z;
        if (entry >= t_max)
            return std::nullopt;
        const glm::dvec3 world =
            box.centre + box.axes * ((glm::dvec3(i, j, k) + 0.5 - 0.5 * side) * box.cell);
        const glm::dvec3 cell = (world - glm::dvec3(grid.origin)) / double(grid.cell_size);
        // Only a border between cells that differ can change the answer.
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 shift(corner & 1, corner / 2 & 1, corner / 4);
            const glm::dvec3 moved = cell + 2e-3 * (2.0 * shift - 1.0);
            ambiguous = ambiguous || base.get(glm::ivec3(glm::floor(moved))) !=
                                         base.get(glm::ivec3(glm::floor(cell)));
        }
        if (base.get(glm::ivec3(glm::floor(cell))))
            return std::max(entry, 0.0);
    }
    return std::nullopt;
}

TEST_P(RomaCases, AWalkInDoublePrecisionConfirmsHitsAndDistances) {
    prepare(GetParam(), 13);
    const std::vector<RomaTestRay> rays = random_rays(20000);
    const std::vector<RomaTestResult> results = trace(rays);
    const double longest_turn =
        glm::length(glm::dvec3(bounds_.extent()) + 2.0 * grid_.cell_size) / GetParam().side;
    const double offset = settings_.get(kRomaNormalOffset) * longest_turn;
    size_t compared = 0, hits = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        const RomaTestRay& ray = rays[i];
        bool ambiguous = false;
        const auto expected =
            walk(base_, grid_, bounds_.centre(), maps_[static_cast<size_t>(ray.choice.x)].direction,
                 ray.choice.y != 0, GetParam().side, offset, ray.point, ray.normal, ray.direction.w,
                 ambiguous);
        if (ambiguous)
            continue;
        const float distance = results[i].given.y;
        ASSERT_EQ(expected.has_value(), distance >= 0.0f);
        ASSERT_EQ(expected.has_value(), results[i].given.x != 0.0f);
        if (expected) {
            ASSERT_NEAR(*expected, distance, 1e-3 * grid_.cell_size);
        }
        ++compared;
        hits += expected.has_value();
    }
    EXPECT_GT(compared, rays.size() / 2); // the exception must not swallow the test
    EXPECT_GT(hits, compared / 20);
}

TEST_P(RomaCases, EscapingRaysEqualTheirTwinBitForBit) {
    settings_.set(kRomaEscape, 3);
    prepare(GetParam(), 15);
    const std::vector<RomaTestRay> rays = random_rays(5000);
    const std::vector<RomaTestResult> results = trace(rays);
    size_t escaped = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        const AlignedMap& map = maps_[static_cast<size_t>(rays[i].choice.x)];
        const gpu::RomaRay ray = on_cpu(rays[i], rays[i].choice.x, rays[i].choice.y != 0);
        const auto hit = closest_hit_on_cpu(map, ray, 3);
        ASSERT_EQ(results[i].given.y, hit ? *hit * map.direction.row_v.w : -1.0f) << "ray " << i;
        ASSERT_EQ(results[i].given.x != 0.0f, hit.has_value()) << "ray " << i;
        escaped += hit != closest_hit_on_cpu(map, ray);
    }
    EXPECT_GT(escaped, 0u);
}

TEST_P(RomaCases, UnsnappedRaysEqualTheirTwinBitForBit) {
    expect_unsnapped_twins(
        [&] { prepare(GetParam(), 14); },
        [&](const RomaTestRay& ray, int iterations, int escape) {
            const glm::vec3 direction(ray.direction);
            const auto& map = *std::ranges::min_element(maps_, {}, [&](const AlignedMap& one) {
                return gpu::roma_crossings(gpu::roma_turned(one.direction, direction));
            });
            const gpu::RomaWalk walk =
                gpu::roma_walk_in_box(map.direction, glm::vec3(ray.point) - bounds_.centre(),
                                      glm::vec3(ray.normal), direction, ray.direction.w, map.side);
            return walk_on_cpu(map, walk, iterations, escape);
        });
}

INSTANTIATE_TEST_SUITE_P(
    Grids, RomaCases,
    testing::Values(Case{{32, 32, 32}, 32, 4, 0.08}, Case{{33, 20, 7}, 33, 3, 0.2},
                    Case{{64, 40, 64}, 64, 2, 0.04}, Case{{50, 100, 31}, 100, 4, 0.04},
                    Case{{128, 90, 60}, 128, 2, 0.03}, Case{{129, 16, 32}, 129, 2, 0.06},
                    Case{{256, 64, 100}, 256, 2, 0.02}),
    [](const testing::TestParamInfo<Case>& chosen) {
        return "side" + std::to_string(chosen.param.side);
    });

TEST_F(RomaTest, TheSameSeedGivesTheSameMaps) {
    prepare({{40, 30, 20}, 40, 4, 0.05}, 5);
    const std::vector<uint32_t> first = tracer_.rotation().download_map(3);
    prepare({{40, 30, 20}, 40, 4, 0.05}, 5);
    EXPECT_EQ(tracer_.rotation().download_map(3), first);
    prepare({{40, 30, 20}, 40, 4, 0.05}, 6);
    EXPECT_NE(tracer_.rotation().download_map(3), first);
}

} // namespace
} // namespace romascope
