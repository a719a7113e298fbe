// SPDX-License-Identifier: MIT
// The error split without GL: counting, drawing of directions, the report.
#include "app/bench/variants.h"
#include "app/split/directions.h"
#include "app/split/split_report.h"
#include "renderer/frame/technique.h"
#include "renderer/tracers/roma/directions.h"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

namespace romascope {
namespace {

std::mt19937 generator(11);

bool coin() { return generator() & 1u; }

glm::vec3 random_normal() {
    std::normal_distribution<float> normal;
    return glm::normalize(glm::vec3(normal(generator), normal(generator), normal(generator)));
}

CandidateSet candidates_of(int side, uint32_t frame) {
    const std::vector<glm::dvec3> directions = candidate_directions(side, true, 3, frame);
    return CandidateSet(std::vector<glm::vec3>(directions.begin(), directions.end()));
}

TEST(Tally, CountsAsTheWordsSay) {
    Tally tally;
    tally.add({.truth = true,
               .drawn_cells = true,
               .traced_cells = false,
               .method = true,
               .traced_truth = false});
    tally.add({.truth = false,
               .drawn_cells = true,
               .traced_cells = true,
               .method = false,
               .traced_truth = true});
    EXPECT_EQ(tally.rays, 2u);
    EXPECT_EQ(tally.free, 1u);
    EXPECT_EQ(tally.of(Step::voxelisation), (StepErrors{0, 1}));
    EXPECT_EQ(tally.of(Step::snapping), (StepErrors{1, 0}));
    EXPECT_EQ(tally.of(Step::resampling), (StepErrors{1, 1}));
    EXPECT_EQ(tally.of(Step::whole), (StepErrors{0, 0}));
    EXPECT_EQ(tally.of(Step::own_direction), (StepErrors{1, 1}));
    EXPECT_EQ(tally.of(Step::resampling).wrong(), 2u);
    EXPECT_EQ(tally.of(Step::voxelisation).difference(), -1);
}

TEST(Tally, DifferencesAddUpWhateverTheAnswers) {
    for (int round = 0; round < 200; ++round) {
        Tally tally, doubled;
        const int rays = 1 + static_cast<int>(generator() % 300);
        for (int i = 0; i < rays; ++i)
            tally.add({coin(), coin(), coin(), coin(), coin()});
        EXPECT_EQ(tally.of(Step::voxelisation).difference() +
                      tally.of(Step::snapping).difference() +
                      tally.of(Step::resampling).difference(),
                  tally.of(Step::whole).difference());
        doubled += tally;
        doubled += tally;
        EXPECT_EQ(doubled.of(Step::whole).wrong(), 2 * tally.of(Step::whole).wrong());
        EXPECT_EQ(doubled.free, 2 * tally.free);
    }
}

TEST(CandidateSet, StrataArePlaces) {
    std::uniform_real_distribution<double> unit(1e-6, 1.0 - 1e-6);
    for (const int side : {2, 3, 4, 7, 16}) {
        const CandidateSet set = candidates_of(side, 5);
        ASSERT_EQ(set.directions().size(), static_cast<size_t>(side * side));
        const std::vector<glm::dvec3> by_stratum = candidate_directions(side, true, 3, 5);
        const std::vector<int> strata = strata_along_curve(side);
        for (int place = 0; place < side * side; ++place) {
            const auto at = static_cast<size_t>(place);
            EXPECT_EQ(set.directions()[at], glm::vec3(by_stratum[static_cast<size_t>(strata[at])]));
            for (int i = 0; i < 20; ++i) {
                const glm::vec3 near =
                    set.direction_near(place, {unit(generator), unit(generator)});
                EXPECT_NEAR(glm::length(near), 1.0f, 1e-5f);
                EXPECT_EQ(set.place_of(near), place);
                EXPECT_EQ(set.place_of(-near), place);
            }
        }
    }
}

/// Points at one place with one normal, each a pixel.
std::vector<SplitPoint> points_with(glm::vec3 normal, int count) {
    std::vector<SplitPoint> points;
    for (int pixel = 0; pixel < count; ++pixel)
        points.push_back({{}, normal, {}, 0, pixel});
    return points;
}

TEST(Directions, AreCosineDistributedWhateverTheMethod) {
    constexpr int kPoints = 2000, kFrames = 40;
    for (int round = 0; round < 3; ++round) {
        const glm::vec3 normal = random_normal();
        const std::vector<SplitPoint> points = points_with(normal, kPoints);
        for (const bool choose : {false, true}) {
            glm::dvec3 sum(0.0);
            double squares = 0.0;
            for (uint32_t frame = 0; frame < kFrames; ++frame)
                for (const SplitDirection& direction :
                     draw_directions(points, candidates_of(4, frame), choose, 1, frame)) {
                    ASSERT_NEAR(glm::length(direction.drawn), 1.0f, 1e-5f);
                    const double cosine = glm::dot(normal, direction.drawn);
                    ASSERT_GE(cosine, -1e-6);
                    sum += glm::dvec3(direction.drawn);
                    squares += cosine * cosine;
                }
            const double rays = double(kPoints) * kFrames;
            // A cosine-distributed direction has mean 2/3 of the normal, its squared cosine 1/2.
            // 40 sets of 16 jittered candidates leave a deviation of 0.01 or less; seen: 0.006.
            EXPECT_NEAR(glm::length(sum / rays - 2.0 / 3.0 * glm::dvec3(normal)), 0.0, 0.02);
            EXPECT_NEAR(squares / rays, 0.5, 0.02);
        }
    }
}

TEST(Directions, AreTracedAlongTheCandidateOfTheirStratum) {
    for (const bool choose : {false, true}) {
        const CandidateSet set = candidates_of(4, 2);
        const glm::vec3 normal = random_normal();
        for (const SplitDirection& direction :
             draw_directions(points_with(normal, 500), set, choose, 1, 2)) {
            const int place = set.place_of(direction.drawn);
            const glm::vec3 candidate = set.directions()[static_cast<size_t>(place)];
            EXPECT_TRUE(direction.traced == candidate || direction.traced == -candidate);
            if (choose) {
                EXPECT_EQ(direction.place, place);
                EXPECT_GE(glm::dot(direction.traced, normal), 0.0f);
            } else {
                EXPECT_EQ(direction.place, -1);
                EXPECT_GE(glm::dot(direction.traced, direction.drawn), 0.0f);
            }
        }
    }
    for (const SplitDirection& direction :
         draw_directions(points_with(random_normal(), 100), CandidateSet(), false, 1, 2))
        EXPECT_EQ(direction.traced, direction.drawn);
}

TEST(Directions, FollowSeedFrameAndCamera) {
    std::vector<SplitPoint> points = points_with(random_normal(), 50);
    const auto draw = [&](uint32_t seed, uint32_t frame) {
        std::vector<glm::vec3> drawn;
        for (const SplitDirection& each :
             draw_directions(points, CandidateSet(), false, seed, frame))
            drawn.push_back(each.drawn);
        return drawn;
    };
    const std::vector<glm::vec3> first = draw(1, 1);
    EXPECT_EQ(draw(1, 1), first);
    EXPECT_NE(draw(2, 1), first);
    EXPECT_NE(draw(1, 2), first);
    for (SplitPoint& point : points)
        point.camera = 1;
    EXPECT_NE(draw(1, 1), first);
}

TEST(SplitReport, HasALineForEachStepOfEachScene) {
    SplitResult result{"roma, \"quoted\"", {}};
    for (int scene = 0; scene < 2; ++scene) {
        Tally& tally = result.scenes.emplace_back();
        for (int i = 0; i < 10; ++i)
            tally.add({coin(), coin(), coin(), coin(), coin()});
    }
    const Facts facts = {{"scene", "two of them"}};
    std::istringstream csv(split_csv(facts, {"a", "b"}, {result, result}));
    std::vector<std::string> lines;
    for (std::string line; std::getline(csv, line);)
        lines.push_back(line);
    ASSERT_EQ(lines.size(), 2u + 2 * 3 * kStepNames.size());
    EXPECT_EQ(lines[0], "# scene: two of them");
    EXPECT_TRUE(lines[2].starts_with("\"roma, \"\"quoted\"\"\",a,voxelisation,10,")) << lines[2];
    EXPECT_TRUE(lines[12].starts_with("\"roma, \"\"quoted\"\"\",all,voxelisation,20,"));
    // One scene is no sum.
    result.scenes.pop_back();
    const std::string one = split_csv(facts, {"a"}, {result});
    EXPECT_EQ(one.find(",all,"), std::string::npos);
}

TEST(Variants, IdleSettingsMakeNone) {
    Settings base(all_knobs());
    base.set(kTracer, "");
    const auto names = [&](const std::vector<std::string>& texts) {
        std::vector<std::string> all;
        for (const BenchVariant& variant : expand_variants(base, parse_variations(base, texts)))
            all.push_back(variant.name);
        return all;
    };
    EXPECT_EQ(names({"technique.tracer=roma", "roma.taps=1,2", "roma.alignment=rotate,shear"}),
              (std::vector<std::string>{"roma roma.alignment=rotate",
                                        "roma roma.taps=1 roma.alignment=shear",
                                        "roma roma.taps=2 roma.alignment=shear"}));
    EXPECT_EQ(
        names({"technique.tracer=dda", "occupancy.builder=raster,compute",
               "occupancy.coverage=thin,conservative"}),
        (std::vector<std::string>{
            "dda occupancy.builder=raster", "dda occupancy.builder=compute occupancy.coverage=thin",
            "dda occupancy.builder=compute occupancy.coverage=conservative"}));
    // Those that differ are bounded, not the combinations.
    const std::vector<std::string> many = {"technique.tracer=roma",
                                           "roma.alignment=rotate,shear",
                                           "roma.taps=1,2,3",
                                           "roma.fit=box,cube",
                                           "occupancy.builder=raster,compute",
                                           "occupancy.coverage=thin,conservative",
                                           "occupancy.axes=all,z"};
    const std::vector<Variation> variations = parse_variations(base, many);
    EXPECT_EQ(expand_variants(base, variations, 20).size(), 20u);
    EXPECT_THROW(expand_variants(base, variations, 19), Error);
}

} // namespace
} // namespace romascope
