// SPDX-License-Identifier: MIT
// Alignment by shear and its tracing: GPU against the CPU twin, bit for bit.
// tests/unit/test_shear.cpp has the twin against walks in double precision.
#include "tests/gl/roma_rays.h"

#include <algorithm>
#include <bit>

namespace romascope {
namespace {

struct Case {
    glm::ivec3 size;
    int side, angular, taps;
    double density;
};

class ShearTest : public AlignedMapsTest {
protected:
    ShearTest() { settings_.set(kRomaAlignment, RomaAlignment::shear); }

    void prepare(const Case& c, unsigned seed) {
        settings_.set(kOccupancyResolution, c.side);
        settings_.set(kRomaAngularResolution, c.angular);
        settings_.set(kRomaTaps, c.taps);
        align_random_grid(c.size, c.density, seed);
        maps_.clear();
        for (size_t map = 0; map < shears().maps.size(); ++map)
            maps_.push_back(shear_on_cpu(base_, shears(), map, c.taps));
    }

    const ShearFrame& shears() const { return tracer_.shearing().frame(); }

    float distance_on_cpu(const RomaTestRay& ray, int map, bool forward) const {
        const ShearedMap& sheared = maps_[static_cast<size_t>(map)];
        const gpu::RomaRay on_map =
            sheared.ray(forward, glm::vec3(ray.point), glm::vec3(ray.normal), ray.direction.w);
        const auto hit = closest_hit_on_cpu(sheared, on_map, settings_.get(kRomaEscape));
        return hit ? *hit * sheared.map.scale.w : -1.0f;
    }

    std::vector<ShearedMap> maps_;
};

class ShearCases : public ShearTest, public testing::WithParamInterface<Case> {};

TEST_P(ShearCases, MapsEqualTheirTwinBitForBit) {
    for (const Invocations invocations : {Invocations::few, Invocations::many}) {
        settings_.set(kRomaInvocations, invocations);
        prepare(GetParam(), 11);
        if (invocations == Invocations::few) {
            const ShearPackings packings = shear_packings(grid_.size, shear_guard(GetParam().taps));
            EXPECT_EQ(tracer_.shearing().download_packings(), pack_on_cpu(base_, packings));
        }
        size_t set = 0;
        for (size_t map = 0; map < maps_.size(); ++map) {
            const std::vector<uint32_t> words =
                tracer_.shearing().download_map(static_cast<int>(map));
            ASSERT_EQ(words.size(), maps_[map].words.size());
            EXPECT_EQ(words, maps_[map].words) << "map " << map;
            size_t cells = 0;
            for (const uint32_t word : words)
                cells += static_cast<size_t>(std::popcount(word));
            if (GetParam().taps == 1) {
                EXPECT_EQ(cells, base_.count());
            }
            set += cells;
        }
        EXPECT_GT(set, 0u);
    }
}

TEST_P(ShearCases, TracingEqualsItsTwinBitForBit) {
    for (const int escape : {0, 2}) {
        settings_.set(kRomaEscape, escape);
        prepare(GetParam(), 12);
        const std::vector<RomaTestRay> rays = random_rays(10000);
        const std::vector<RomaTestResult> results = trace(rays);
        const RomaTwin twin{[&](const RomaTestRay& ray, int map, bool forward) {
                                return distance_on_cpu(ray, map, forward);
                            },
                            [&](int map, glm::vec3 direction) {
                                return gpu::shear_is_forward(maps_[static_cast<size_t>(map)].map,
                                                             direction);
                            }};
        const size_t hits = expect_twins(rays, results, twin);
        EXPECT_GT(hits, rays.size() / 30);
        EXPECT_LT(hits, rays.size() * 19 / 20);
    }
}

TEST_P(ShearCases, UnsnappedRaysEqualTheirTwinBitForBit) {
    expect_unsnapped_twins(
        [&] { prepare(GetParam(), 14); },
        [&](const RomaTestRay& ray, int iterations, int escape) {
            const glm::vec3 direction(ray.direction);
            const auto& map = *std::ranges::min_element(maps_, {}, [&](const ShearedMap& one) {
                return gpu::roma_crossings(gpu::shear_aligned(one.map, direction));
            });
            const gpu::RomaWalk walk =
                gpu::shear_walk(map.grid, map.map, glm::vec3(ray.point), glm::vec3(ray.normal),
                                direction, ray.direction.w);
            return walk_on_cpu(map, walk, iterations, escape);
        });
}

INSTANTIATE_TEST_SUITE_P(
    Grids, ShearCases,
    testing::Values(Case{{32, 32, 32}, 32, 4, 1, 0.08}, Case{{33, 20, 7}, 33, 3, 1, 0.2},
                    Case{{33, 20, 7}, 33, 3, 3, 0.1}, Case{{64, 1, 50}, 64, 4, 1, 0.2},
                    Case{{64, 40, 64}, 64, 2, 2, 0.04}, Case{{3, 100, 31}, 100, 4, 2, 0.04},
                    Case{{128, 90, 60}, 128, 2, 1, 0.03}, Case{{129, 16, 32}, 129, 2, 3, 0.03},
                    Case{{256, 24, 100}, 256, 2, 1, 0.03}, Case{{24, 40, 256}, 256, 2, 3, 0.03}),
    [](const testing::TestParamInfo<Case>& chosen) {
        return "side" + std::to_string(chosen.param.side) + "taps" +
               std::to_string(chosen.param.taps) + "y" + std::to_string(chosen.param.size.y);
    });

TEST_F(ShearTest, MemoryIsThatOfTheCellsAndGrowsOnly) {
    settings_.set(kRomaInvocations, Invocations::many);
    prepare({{128, 20, 30}, 128, 4, 1, 0.05}, 5);
    size_t texels = 0;
    for (size_t map = 0; map < maps_.size(); ++map)
        texels += static_cast<size_t>(shears().size(map).x) * shears().size(map).y;
    EXPECT_EQ(shears().texels, texels); // 128 bits in each
    // The most columns for 128 slices, and the farthest below and above that a ray may ask for.
    const size_t places = 16 * 2 * (30 + 2 * (128 + 4) + 1);
    EXPECT_EQ(tracer_.shearing().bytes(),
              16 * texels + 8 * places + sizeof(gpu::ShearGrid) + 16 * sizeof(gpu::ShearMap));
    // Few invocations take packings of the base map as well.
    settings_.set(kRomaInvocations, Invocations::few);
    prepare({{128, 20, 30}, 128, 4, 1, 0.05}, 5);
    const ShearPackings packings = shear_packings(grid_.size, 0);
    EXPECT_EQ(tracer_.shearing().bytes(), 16 * texels + 4 * shear_packing_words(packings) +
                                              8 * places + sizeof(gpu::ShearGrid) +
                                              16 * sizeof(gpu::ShearMap));
    settings_.set(kRomaInvocations, Invocations::many);
    prepare({{128, 20, 30}, 128, 4, 1, 0.05}, 5);
    // Other candidates have other axes, so other columns: no smaller buffer, no other map.
    const size_t before = tracer_.shearing().bytes();
    for (unsigned seed = 6; seed < 12; ++seed) {
        prepare({{128, 20, 30}, 128, 4, 1, 0.05}, seed);
        EXPECT_GE(tracer_.shearing().bytes(), before);
        EXPECT_EQ(tracer_.shearing().download_map(15), maps_[15].words);
    }
}

TEST_F(ShearTest, TheAlignmentCanChangeFromFrameToFrame) {
    prepare({{40, 30, 20}, 40, 4, 1, 0.05}, 5);
    const size_t sheared = tracer_.bytes()[1].bytes;
    settings_.set(kRomaAlignment, RomaAlignment::rotate);
    const Scene any = scene_of_triangles(rectangle({0, 0, 0}, {0, 1, 0}, 1.0f));
    const GpuScene gpu_scene(any);
    tracer_.align(frame(gpu_scene, settings_), upload_base(base_, BaseStore::texture), grid_,
                  bounds_);
    EXPECT_EQ(tracer_.rotation().directions().size(), 16u);
    EXPECT_TRUE(shears().maps.empty()); // what is not used holds no memory
    settings_.set(kRomaAlignment, RomaAlignment::shear);
    prepare({{40, 30, 20}, 40, 4, 1, 0.05}, 5);
    EXPECT_EQ(tracer_.bytes()[1].bytes, sheared);
    EXPECT_EQ(tracer_.shearing().download_map(3), maps_[3].words);
}

} // namespace
} // namespace romascope
