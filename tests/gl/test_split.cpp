// SPDX-License-Identifier: MIT
// Error splits of scenes whose truth is known, and lists of rays against the CPU twin.
#include "app/split/chain.h"
#include "renderer/tracers/dda/dda_tracer.h"
#include "renderer/tracers/occupancy/occupancy_knobs.h"
#include "renderer/tracers/roma/directions.h"
#include "renderer/tracers/roma/roma_cpu.h"
#include "renderer/tracers/roma/shear_cpu.h"
#include "shaders/tracers/roma/concentric.h"
#include "tests/gl/gl_test.h"
#include "tests/support/random_grid.h"

namespace romascope {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

class SplitTest : public GlTest {
protected:
    SplitTest() { settings_.set(kOccupancyResolution, 64); }

    static SplitScene seen(const std::vector<glm::vec3>& corners, const Camera& camera) {
        return SplitScene(scene_of_triangles(corners), {}, {camera}, {16, 12});
    }

    Tally tally(SplitScene& scene, int frames = 4) {
        Chain chain;
        Tally all;
        for (int frame = 0; frame < frames; ++frame)
            for (const ChainAnswers& ray :
                 chain.ask(scene, settings_, static_cast<uint32_t>(frame)))
                all.add(ray);
        const auto difference = [&](Step step) { return all.of(step).difference(); };
        EXPECT_EQ(difference(Step::voxelisation) + difference(Step::snapping) +
                      difference(Step::resampling),
                  difference(Step::whole));
        return all;
    }

    /// Calls `check` with each tracer and alignment in the settings.
    template <class Check>
    void for_all_methods(const Check& check) {
        for (const TracerEntry& entry : tracers()) {
            settings_.set(kTracer, std::string(entry.name));
            const bool aligned = entry.name == "roma";
            for (const RomaAlignment alignment : {RomaAlignment::rotate, RomaAlignment::shear}) {
                settings_.set(kRomaAlignment, alignment);
                SCOPED_TRACE(fmt_name(entry.name, alignment));
                check(entry.name);
                if (!aligned)
                    break;
            }
        }
    }

    /// So that no ray meets the plane it starts on, with every tracer.
    void leave_far(int escape) {
        for (const char* tracer : {"roma", "dda", "dda2d", "samples"}) {
            settings_.set_text(std::string(tracer) + ".normal_offset", "1.5");
            settings_.set_text(std::string(tracer) + ".escape", std::to_string(escape));
        }
    }

    static std::string fmt_name(std::string_view tracer, RomaAlignment alignment) {
        std::string name(tracer);
        name += alignment == RomaAlignment::shear ? " shear" : " rotate";
        return name;
    }

    Settings settings_{all_knobs()};
};

/// The inside of a cube of side 4 around the origin.
std::vector<glm::vec3> closed_box() {
    std::vector<glm::vec3> corners;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 normal(0.0f);
            normal[axis] = side;
            for (const glm::vec3 corner : rectangle(2.0f * normal, -normal, 2.0f))
                corners.push_back(corner);
        }
    return corners;
}

TEST_F(SplitTest, NothingIsWrongOnAnOpenPlane) {
    std::mt19937 random(3);
    for (int round = 0; round < 4; ++round) {
        const glm::vec3 normal = round == 0 ? glm::vec3(0, 1, 0) : random_direction(random);
        SplitScene scene = seen(
            rectangle({1, 2, 3}, normal, 3.0f),
            look_at("above", glm::vec3(1, 2, 3) + 2.0f * normal + 0.3f * random_direction(random),
                    {1, 2, 3}, 1.2f));
        // Columns of a sheared map pass through up to half a cell more than their rays do.
        leave_far(1);
        for_all_methods([&](std::string_view) {
            const Tally all = tally(scene, 2);
            EXPECT_EQ(all.free, all.rays); // nothing stands on it
            EXPECT_EQ(all.of(Step::own_direction), StepErrors{});
            EXPECT_EQ(all.of(Step::whole), StepErrors{});
            EXPECT_EQ(all.of(Step::voxelisation), StepErrors{});
        });
    }
}

TEST_F(SplitTest, SnappingTurnsRaysBelowAnOpenPlaneAndNothingElse) {
    settings_.set(kRomaSampling, RomaSampling::snap);
    leave_far(0);
    const glm::vec3 normal = glm::normalize(glm::vec3(0.3f, 1.0f, 0.2f));
    SplitScene scene =
        seen(rectangle({0, 0, 0}, normal, 3.0f), look_at("above", 2.0f * normal, {0, 0, 0}, 1.0f));
    for (const RomaAlignment alignment : {RomaAlignment::rotate, RomaAlignment::shear}) {
        settings_.set(kRomaAlignment, alignment);
        const Tally all = tally(scene, 8);
        EXPECT_EQ(all.of(Step::voxelisation), StepErrors{});
        EXPECT_EQ(all.of(Step::snapping).leaks, 0u);
        // 3.7 % on average over all normals at 4 x 4 strata.
        const double share = double(all.of(Step::snapping).false_shadows) / double(all.rays);
        EXPECT_GT(share, 0.001);
        EXPECT_LT(share, 0.15);
    }
}

TEST_F(SplitTest, ARayInAClosedBoxIsBlocked) {
    SplitScene scene =
        seen(closed_box(), look_at("inside", {0.5f, 0.3f, 0.1f}, {-1, -1.5f, -2}, 1.2f));
    settings_.set(kOccupancyBuilder, OccupancyBuilder::compute);
    leave_far(0); // an escape leads through a wall in its corners
    for (const OccupancyCoverage coverage :
         {OccupancyCoverage::thin, OccupancyCoverage::conservative}) {
        settings_.set(kOccupancyCoverage, coverage);
        for_all_methods([&](std::string_view name) {
            const Tally all = tally(scene);
            EXPECT_EQ(all.free, 0u);
            // Cells that separate let nothing through; what looks only here and there does.
            EXPECT_EQ(all.of(Step::voxelisation), StepErrors{});
            if (name == "samples") {
                EXPECT_GT(all.of(Step::whole).leaks, all.rays / 10);
            } else if (name != "roma") {
                EXPECT_EQ(all.of(Step::whole), StepErrors{});
            }
            EXPECT_EQ(all.of(Step::whole).false_shadows, 0u);
        });
    }
    // All that a column's line passes: no way through.
    settings_.set(kTracer, "roma");
    settings_.set(kRomaAlignment, RomaAlignment::shear);
    settings_.set(kRomaTaps, 3);
    EXPECT_EQ(tally(scene).of(Step::whole), StepErrors{});
}

TEST_F(SplitTest, TheTruthStartsAtTheSurface) {
    // A floor 10 m wide, 64 cells of 0.156 m; a shelf 0.1 m above, so within the offset of any
    // method: rays start beyond it, and all the loss is voxelisation's.
    std::vector<glm::vec3> corners = rectangle({0, 0, 0}, {0, 1, 0}, 5.0f);
    for (const glm::vec3 corner : rectangle({0, 0.1f, 0}, {0, 1, 0}, 5.0f))
        corners.push_back(corner);
    Scene scene = scene_of_triangles(corners);
    SplitScene split(std::move(scene), {}, {look_at("between", {0, 0.05f, 0}, {0, 0, 1}, 0.4f)},
                     {16, 12});
    for_all_methods([&](std::string_view) {
        const Tally all = tally(split, 2);
        EXPECT_LT(all.free, all.rays / 20);
        EXPECT_GT(all.of(Step::voxelisation).leaks, all.rays / 3);
    });
}

TEST_F(SplitTest, AllLinksInCellsStartWhereTheMethodDoes) {
    const glm::vec3 normal = glm::normalize(glm::vec3(0.3f, 1.0f, 0.2f));
    SplitScene scene =
        seen(rectangle({0, 0, 0}, normal, 3.0f), look_at("above", 2.0f * normal, {0, 0, 0}, 1.0f));
    settings_.set(kRomaEscape, 0);
    for (const RomaAlignment alignment : {RomaAlignment::rotate, RomaAlignment::shear}) {
        settings_.set(kRomaAlignment, alignment);
        // On the surface, in its own cells, nothing is free, though the exact answer for cells has
        // an offset of its own when it is the method.
        settings_.set(kRomaNormalOffset, 0.0);
        EXPECT_GT(tally(scene, 2).of(Step::voxelisation).false_shadows, 300u);
        // Far above it everything is, though that offset is nothing.
        settings_.set(kRomaNormalOffset, 6.0);
        settings_.set(kDdaNormalOffset, 0.0);
        EXPECT_EQ(tally(scene, 2).of(Step::voxelisation), StepErrors{});
        settings_.set(kDdaNormalOffset, 1.5);
    }
    // Nor is its escape the method's.
    settings_.set(kRomaNormalOffset, 0.0);
    settings_.set(kRomaEscape, 4);
    const uint64_t with = tally(scene, 2).of(Step::voxelisation).false_shadows;
    settings_.set(kRomaEscape, 0);
    EXPECT_LT(2 * with, tally(scene, 2).of(Step::voxelisation).false_shadows);
}

TEST_F(SplitTest, AFiniteRadiusEndsAllLinks) {
    // Nothing of the box is within 1 cm, off its edges.
    SplitScene scene =
        seen(closed_box(), look_at("inside", {0.5f, 0.3f, 0.1f}, {0.1f, 0, -2}, 0.3f));
    settings_.set(kAoRadius, 0.01);
    for_all_methods([&](std::string_view) {
        const Tally all = tally(scene, 2);
        EXPECT_EQ(all.free, all.rays);
        EXPECT_EQ(all.of(Step::whole), StepErrors{});
        EXPECT_EQ(all.of(Step::voxelisation), StepErrors{});
    });
    settings_.set(kAoRadius, 8.0); // beyond the box's diagonal, 6.9 m
    settings_.set(kTracer, "dda");
    EXPECT_EQ(tally(scene, 2).free, 0u);
}

TEST_F(SplitTest, TheSameQuestionsHaveTheSameAnswers) {
    SplitScene scene =
        seen(closed_box(), look_at("inside", {0.5f, 0.3f, 0.1f}, {-1, -1.5f, -2}, 1.2f));
    for_all_methods([&](std::string_view) { EXPECT_EQ(tally(scene), tally(scene)); });
}

/// Rays in a grid of random cells.
TEST_F(SplitTest, AListOfRaysIsWhatTheTwinSays) {
    std::mt19937 random(9);
    const BitGrid base = random_grid({40, 30, 37}, 0.02, random);
    const OccupancyGrid grid{{-2.0f, 1.0f, 0.5f}, 0.1f, base.size()};
    Bounds bounds;
    bounds.add(grid.origin + 0.05f);
    bounds.add(grid.origin + grid.cell_size * glm::vec3(base.size()) - 0.05f);
    const GpuScene any(scene_of_triangles(rectangle({0, 0, 0}, {0, 1, 0}, 1.0f)));
    settings_.set(kOccupancyResolution, 40);
    settings_.set(kRomaEscape, 1);
    RayList list;
    for (const RomaAlignment alignment : {RomaAlignment::rotate, RomaAlignment::shear}) {
        settings_.set(kRomaAlignment, alignment);
        RomaTracer tracer;
        tracer.align(frame(any, settings_), upload_base(base, RomaTracer::store_for(settings_)),
                     grid, bounds);
        const std::vector<int> strata = strata_along_curve(4);
        std::vector<ListedRay> rays;
        std::uniform_real_distribution<float> unit(0.0f, 1.0f);
        for (int i = 0; i < 3000; ++i) {
            const glm::vec3 place(unit(random), unit(random), unit(random));
            rays.push_back({.point = bounds.min + place * bounds.extent(),
                            .t_max = i % 3 == 0 ? kInfinity : 4.0f * unit(random),
                            .normal = random_direction(random),
                            .place = i % 17 - 1,
                            .direction = random_direction(random)});
        }
        const std::vector<float> hits =
            list.trace(shaders_, settings_, tracer, RayQuestion::any_hit, rays);
        const std::vector<float> distances =
            list.trace(shaders_, settings_, tracer, RayQuestion::distance, rays);
        ASSERT_EQ(hits.size(), rays.size());
        std::vector<AlignedMap> rotated;
        std::vector<ShearedMap> sheared;
        for (size_t map = 0; map < 16; ++map) {
            if (alignment == RomaAlignment::shear)
                sheared.push_back(shear_on_cpu(base, tracer.shearing().frame(), map, 1));
            else
                rotated.push_back(rotate_on_cpu(base, tracer.rotation().directions()[map], 40));
        }
        int blocked = 0;
        for (size_t i = 0; i < rays.size(); ++i) {
            const ListedRay& ray = rays[i];
            const bool own = ray.place < 0;
            const int stratum = own ? gpu::stratum_of_direction(ray.direction, 4)
                                    : strata[static_cast<size_t>(ray.place)];
            const auto map = static_cast<size_t>(stratum);
            const glm::vec3 towards = own ? ray.direction : ray.normal;
            std::optional<float> slices;
            float metres = 0.0f;
            if (alignment == RomaAlignment::shear) {
                const ShearedMap& twin = sheared[map];
                slices = closest_hit_on_cpu(twin,
                                            twin.ray(gpu::shear_is_forward(twin.map, towards),
                                                     ray.point, ray.normal, ray.t_max),
                                            1);
                metres = twin.map.scale.w;
            } else {
                const AlignedMap& twin = rotated[map];
                slices = closest_hit_on_cpu(
                    twin,
                    gpu::roma_ray(twin.direction, gpu::roma_is_forward(twin.direction, towards),
                                  ray.point - bounds.centre(), ray.normal, ray.t_max, 40),
                    1);
                metres = twin.direction.row_v.w;
            }
            ASSERT_EQ(hits[i], slices ? 1.0f : 0.0f) << "ray " << i;
            ASSERT_EQ(distances[i], slices ? *slices * metres : -1.0f) << "ray " << i;
            blocked += slices.has_value();
        }
        EXPECT_GT(blocked, 300);
        EXPECT_LT(blocked, 2700);
    }
}

} // namespace
} // namespace romascope
