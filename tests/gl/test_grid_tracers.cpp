// SPDX-License-Identifier: MIT
// Tracers that look at the cells of the base occupancy map: against a walk in double precision that
// shares no line with them, against each other, and against planes and walls.
#include "renderer/reference/ao_reference.h"
#include "renderer/tracers/dda/dda_tracer.h"
#include "renderer/tracers/dda2d/dda2d_tracer.h"
#include "renderer/tracers/samples/samples_tracer.h"
#include "tests/gl/small_pictures.h"
#include "tests/gl/tracer_rays.h"
#include "tests/support/random_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace romascope {
namespace {

/// Points closer than this to a face between cells, in cells, may fall to either side of it.
constexpr double kTie = 1e-3;

struct Case {
    glm::ivec3 size;
    double density;
    int escape;
};

/// A ray in cells: what of it lies in the grid, and where it enters each cell on its way.
struct CellRay {
    glm::dvec3 start, direction;
    double end = 0;                ///< t at which it ends or has left the grid
    double moved = 0;              ///< from the surface to the start
    std::vector<double> crossings; ///< t of all faces it crosses in the grid, ascending, from t 0
};

class GridTracersTest : public GlTest {
protected:
    void prepare(const Case& c, unsigned seed) {
        random_.seed(seed);
        base_ = random_grid(c.size, c.density, random_);
        map_ = upload_base(base_, BaseStore::texture);
        grid_.size = c.size;
        grid_.cell_size = 0.173f;
        grid_.origin = {-3.7f, 1.1f, 20.0f};
        for (const KnobBase* knob : all_knobs().all())
            if (knob->key().ends_with(".escape"))
                settings_.set_text(knob->key(), std::to_string(c.escape));
    }

    std::vector<TestRay> random_rays(int count) {
        std::uniform_real_distribution<float> unit(-0.3f, 1.3f);
        std::uniform_real_distribution<float> reach(0.0f, 1.0f);
        const glm::vec3 extent = grid_.cell_size * glm::vec3(grid_.size);
        std::vector<TestRay> rays;
        for (int i = 0; i < count; ++i) {
            const glm::vec3 place(unit(random_), unit(random_), unit(random_));
            glm::vec3 direction = random_direction(random_);
            if (i % 8 == 1) { // along an axis, or across one
                const int axis = i / 8 % 3;
                for (int other = 0; other < 3; ++other)
                    if (i % 16 == 1 ? other != axis : other == axis)
                        direction[other] = i % 32 < 16 ? 0.0f : -0.0f;
                direction = glm::normalize(direction);
            }
            const float t_max = i % 4 == 0 ? std::numeric_limits<float>::infinity()
                                : i % 17 == 0
                                    ? 0.0f
                                    : glm::length(extent) * reach(random_) * reach(random_);
            rays.push_back({glm::vec4(grid_.origin + place * extent, 0.0f),
                            glm::vec4(random_direction(random_), 0.0f),
                            glm::vec4(direction, t_max)});
        }
        return rays;
    }

    std::vector<glm::vec2> trace(GridTracer& tracer, const std::vector<TestRay>& rays) {
        const Scene any = scene_of_triangles(rectangle({0, 0, 0}, {0, 1, 0}, 1.0f));
        const GpuScene scene(any);
        tracer.take(frame(scene, settings_), map_.texture(), grid_);
        return trace_rays(shaders_, tracer, settings_, rays);
    }

    CellRay in_cells(const TestRay& ray, double offset) const {
        CellRay cells;
        const glm::dvec3 normal(ray.normal);
        cells.direction = glm::dvec3(ray.direction);
        cells.start = (glm::dvec3(ray.point) - glm::dvec3(grid_.origin)) / double(grid_.cell_size) +
                      offset * normal;
        cells.moved = offset * glm::dot(normal, cells.direction);
        cells.end = double(ray.direction.w) / double(grid_.cell_size) - cells.moved;
        cells.crossings = {0.0};
        for (int axis = 0; axis < 3; ++axis)
            for (int plane = 0; plane <= grid_.size[axis]; ++plane)
                if (cells.direction[axis] != 0.0)
                    cells.crossings.push_back((plane - cells.start[axis]) / cells.direction[axis]);
        std::erase_if(cells.crossings, [](double t) { return t < 0.0; });
        std::ranges::sort(cells.crossings);
        return cells;
    }

    glm::ivec3 cell_at(const CellRay& ray, double t) const {
        return glm::ivec3(glm::floor(glm::clamp(ray.start + t * ray.direction, -9.0, 999.0)));
    }

    /// Whether a place so close to others that differ could be taken for one of them.
    bool is_ambiguous(const CellRay& ray, double t) const {
        for (int corner = 0; corner < 8; ++corner) {
            CellRay moved = ray;
            moved.start += kTie * (2.0 * glm::dvec3(corner & 1, corner / 2 & 1, corner / 4) - 1.0);
            if (base_.get(cell_at(moved, t)) != base_.get(cell_at(ray, t)))
                return true;
        }
        return false;
    }

    bool is_near_face(const CellRay& ray, double t) const {
        const glm::dvec3 place = ray.start + t * ray.direction;
        return glm::any(glm::lessThan(glm::abs(place - glm::round(place)), glm::dvec3(kTie)));
    }

    /// Where a cell that stops the ray is entered, after those that it leaves its surface through;
    /// -1 if there is none. `skipped`: where it is past those.
    double walk(const CellRay& ray, int escape, bool& ambiguous, double& skipped) const {
        bool leaving = true;
        skipped = 0.0;
        for (size_t i = 0; i + 1 < ray.crossings.size(); ++i) {
            const double from = ray.crossings[i], to = ray.crossings[i + 1];
            const double middle = 0.5 * (from + to);
            const bool occupied = base_.get(cell_at(ray, middle));
            ambiguous = ambiguous || is_ambiguous(ray, middle) || std::abs(from - ray.end) < kTie;
            if (from >= ray.end)
                return -1.0;
            if (i == 0)
                ambiguous = ambiguous || is_ambiguous(ray, 0.0);
            if (occupied && leaving && escape > 0) {
                // A crossing of two faces at once makes no cell of its own.
                ambiguous = ambiguous || to - from < 2 * kTie;
                --escape;
                skipped = to;
                continue;
            }
            leaving = false;
            if (occupied)
                return from;
        }
        return -1.0;
    }

    /// Metres from the surface.
    double distance(const CellRay& ray, double t) const {
        return std::max(t + ray.moved, 0.0) * double(grid_.cell_size);
    }

    /// What goes texel by texel gives the hits of what goes cell by cell; how many those are.
    long expect_texels_as_cells(const std::vector<TestRay>& rays) {
        DdaTracer cells;
        Dda2dTracer texels;
        const std::vector<glm::vec2> expected = trace(cells, rays);
        for (const bool hierarchy : {false, true}) {
            settings_.set(kDda2dHierarchy, hierarchy);
            const std::vector<glm::vec2> results = trace(texels, rays);
            for (size_t i = 0; i < rays.size() && !HasFailure(); ++i)
                EXPECT_EQ(results[i], expected[i])
                    << "ray " << i << " from " << rays[i].point.x << " " << rays[i].point.y << " "
                    << rays[i].point.z << " along " << rays[i].direction.x << " "
                    << rays[i].direction.y << " " << rays[i].direction.z << ", hierarchy "
                    << hierarchy;
        }
        return std::ranges::count_if(expected, [](glm::vec2 r) { return r.x != 0.0f; });
    }

    std::mt19937 random_;
    Settings settings_{all_knobs()};
    BitGrid base_;
    BaseMap map_;
    OccupancyGrid grid_;
};

class GridCases : public GridTracersTest, public testing::WithParamInterface<Case> {};

TEST_P(GridCases, TheWalkIsThatInDoublePrecision) {
    prepare(GetParam(), 21);
    const std::vector<TestRay> rays = random_rays(6000);
    DdaTracer tracer;
    const std::vector<glm::vec2> results = trace(tracer, rays);
    size_t compared = 0, hits = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        const CellRay ray = in_cells(rays[i], settings_.get(kDdaNormalOffset));
        bool ambiguous = false;
        double skipped = 0;
        const double t = walk(ray, GetParam().escape, ambiguous, skipped);
        ASSERT_EQ(results[i].x != 0.0f, results[i].y >= 0.0f) << "ray " << i;
        if (ambiguous)
            continue;
        ASSERT_EQ(t >= 0.0, results[i].y >= 0.0f) << "ray " << i;
        if (t >= 0.0) {
            ASSERT_NEAR(distance(ray, t), results[i].y, 2 * kTie * grid_.cell_size) << "ray " << i;
        }
        ++compared;
        hits += t >= 0.0;
    }
    EXPECT_GT(compared, rays.size() / 2); // the exception must not swallow the test
    EXPECT_GT(hits, compared / 50);
    EXPECT_LT(hits, compared * 19 / 20);
}

TEST_P(GridCases, TexelByTexelGivesTheSameHitsWithAndWithoutHierarchy) {
    // All rays decide by the same numbers in the same order, so there are no ties to leave out.
    prepare(GetParam(), 22);
    const std::vector<TestRay> rays = random_rays(20000);
    expect_texels_as_cells(rays);
}

TEST_P(GridCases, SamplesAreTheCellsAtTheirPlaces) {
    prepare(GetParam(), 23);
    const std::vector<TestRay> rays = random_rays(6000);
    for (const int count : {1, 7, 40}) {
        settings_.set(kSamplesCount, count);
        SamplesTracer tracer;
        const std::vector<glm::vec2> results = trace(tracer, rays);
        size_t compared = 0, hits = 0;
        for (size_t i = 0; i < rays.size(); ++i) {
            CellRay ray = in_cells(rays[i], settings_.get(kSamplesNormalOffset));
            bool ambiguous = false;
            double skipped = 0;
            walk(ray, GetParam().escape, ambiguous, skipped); // how far it escapes
            // The part of the ray that lies in the grid, slab by slab.
            double begin = skipped, end = ray.end;
            for (int axis = 0; axis < 3; ++axis) {
                if (ray.direction[axis] == 0.0) {
                    if (ray.start[axis] < 0.0 || ray.start[axis] > grid_.size[axis])
                        end = -1.0;
                    continue;
                }
                const double a = -ray.start[axis] / ray.direction[axis];
                const double b = (grid_.size[axis] - ray.start[axis]) / ray.direction[axis];
                begin = std::max(begin, std::min(a, b));
                end = std::min(end, std::max(a, b));
            }
            ambiguous = (ambiguous && GetParam().escape > 0) || std::abs(end - begin) < kTie;
            double found = -1.0;
            for (int sample = 0; sample < count && end > begin && found < 0.0; ++sample) {
                const double t = begin + (sample + 0.5) / count * (end - begin);
                const glm::ivec3 cell = cell_at(ray, t);
                ambiguous = ambiguous || is_ambiguous(ray, t);
                if (!base_.get(cell))
                    continue;
                // Where its cell begins: the last face before the sample.
                found = *(std::ranges::upper_bound(ray.crossings, t) - 1);
                ambiguous = ambiguous || is_near_face(ray, t);
                found = std::max(found, begin);
            }
            ASSERT_EQ(results[i].x != 0.0f, results[i].y >= 0.0f) << "ray " << i;
            if (ambiguous)
                continue;
            ASSERT_EQ(found >= 0.0, results[i].y >= 0.0f) << "ray " << i << " of " << count;
            if (found >= 0.0) {
                ASSERT_NEAR(distance(ray, found), results[i].y, 2 * kTie * grid_.cell_size);
            }
            ++compared;
            hits += found >= 0.0;
        }
        EXPECT_GT(compared, rays.size() / 2);
        EXPECT_GT(hits, compared / 2000);
    }
}

INSTANTIATE_TEST_SUITE_P(Grids, GridCases,
                         testing::Values(Case{{32, 32, 32}, 0.05, 0}, Case{{33, 20, 7}, 0.3, 2},
                                         Case{{50, 100, 31}, 0.02, 1}, Case{{128, 90, 60}, 0.01, 0},
                                         Case{{70, 16, 129}, 0.5, 4}, Case{{1, 1, 64}, 0.3, 1},
                                         Case{{64, 64, 256}, 0.003, 0}),
                         [](const testing::TestParamInfo<Case>& chosen) {
                             return fmt::format("x{}_escape{}", chosen.param.size.x,
                                                chosen.param.escape);
                         });

TEST_F(GridTracersTest, RaysOnFacesAndEdgesAreDecidedAlike) {
    // Whole numbers everywhere: every crossing is a tie.
    prepare({{40, 36, 70}, 0.03, 0}, 24);
    grid_.cell_size = 1.0f;
    grid_.origin = glm::vec3(0.0f);
    std::uniform_int_distribution<int> place(-5, 75), step(-2, 2);
    std::vector<TestRay> rays;
    while (rays.size() < 20000) {
        const glm::vec3 direction(step(random_), step(random_), step(random_));
        if (direction == glm::vec3(0.0f))
            continue;
        rays.push_back(
            {glm::vec4(place(random_), place(random_), place(random_), 0),
             {0, 0, 0, 0},
             glm::vec4(glm::normalize(direction), std::numeric_limits<float>::infinity())});
    }
    EXPECT_GT(expect_texels_as_cells(rays), 1000);
}

TEST_F(GridTracersTest, TheHierarchyIsTheOrOfItsColumns) {
    prepare({{77, 41, 70}, 0.002, 0}, 25);
    Dda2dTracer tracer;
    trace(tracer, random_rays(1));
    const Texture& texture = tracer.hierarchy().texture();
    const std::vector<uint32_t> words = texture.download_uint(1);
    const glm::ivec3 texels = texture.size();
    // Levels are 48, 24, 12, 6, 3 columns wide: 77 rounded up to 96, halved and halved again.
    int begin = 0;
    for (int level = 1; level <= 5; begin += 96 >> level, ++level) {
        const int side = 1 << level;
        for (int y = 0; y * side < 41; ++y) {
            for (int x = 0; x * side < 77; ++x) {
                for (int word = 0; word < 3; ++word) {
                    uint32_t expected = 0;
                    for (int i = 0; i < side * side * 32; ++i) {
                        const glm::ivec3 cell(x * side + i / 32 % side, y * side + i / 32 / side,
                                              word * 32 + i % 32);
                        expected |= uint32_t(base_.get(cell)) << (i % 32);
                    }
                    ASSERT_EQ(
                        words[static_cast<size_t>((word * texels.y + y) * texels.x + begin + x)],
                        expected)
                        << "level " << level << ", column " << x << ", " << y;
                }
            }
        }
    }
}

class GridAmbientOcclusion : public SmallPictures, public testing::WithParamInterface<const char*> {
protected:
    GridAmbientOcclusion() {
        settings_.set(kAoRays, 16);
        settings_.set(kSamplesCount, 128); // two in a cell: nearly nothing is missed
        settings_.set(kTracer, GetParam());
    }

    /// How rays of the tracer leave their surface, cells.
    void leave_by(double offset, int escape) {
        const std::string tracer = GetParam();
        settings_.set_text(tracer + ".normal_offset", to_text(offset));
        settings_.set_text(tracer + ".escape", to_text(int64_t{escape}));
    }
};

TEST_P(GridAmbientOcclusion, AnOpenPlaneIsNearlyOneByDefault) {
    // The defaults are best where surfaces are near each other, and cost an open plane some of its
    // rays: seen are 0.4 %, of samples, which start nearest to it, 3.5 %.
    const double least = std::string(GetParam()) == "samples" ? 0.95 : 0.99;
    settings_.reset(kSamplesCount);
    std::mt19937 random(1);
    for (int i = 0; i < 8; ++i) {
        const auto [scene, camera, normal] = open_plane(random, i == 0);
        EXPECT_GT(mean(render(scene, camera, 2)), least)
            << "normal " << normal.x << " " << normal.y << " " << normal.z;
    }
}

TEST_P(GridAmbientOcclusion, AnOpenPlaneIsExactlyOne) {
    // Cells are set up to half a cell from the plane along its dominant axis, and end another half
    // cell further: 1.37 cells at most, below an offset of 1.5.
    leave_by(1.5, 0);
    std::mt19937 random(1);
    for (int i = 0; i < 8; ++i) {
        const auto [scene, camera, normal] = open_plane(random, i == 0);
        settings_.set(kSeed, i);
        EXPECT_EQ(mean(render(scene, camera, 2)), 1.0)
            << "normal " << normal.x << " " << normal.y << " " << normal.z;
    }
}

TEST_P(GridAmbientOcclusion, AWallIsSeenAsTheReferenceSeesIt) {
    std::vector<glm::vec3> corners = rectangle({5, 0, 0}, {0, 1, 0}, 5.0f);
    const std::vector<glm::vec3> wall = rectangle({0, 5, 0}, {1, 0, 0}, 5.0f);
    corners.insert(corners.end(), wall.begin(), wall.end());
    const Scene scene = scene_of_triangles(corners);
    for (const float distance : {1.25f, 4.0f, 9.0f}) {
        const Camera camera = look_at("spot", {distance, 2.0f, 0}, {distance, 0, 0}, 0.01f);
        const AoQuery query{camera, {32, 24}, 256};
        const AoReference truth =
            ambient_occlusion_reference(scene, query, {}, {.use_cache = false});
        // All pixels see nearly the same point. A cell is 0.16 m: at 1.25 m the wall stands up to a
        // cell nearer, the start 0.24 m higher, each of which moves the mean by up to 0.02.
        EXPECT_NEAR(mean(render(scene, camera, 8)), mean(truth.visibility), 0.03)
            << distance << " m";
    }
}

TEST_P(GridAmbientOcclusion, NothingBeyondTheRadiusOccludes) {
    const auto [scene, camera, normal] = below_a_ceiling();
    settings_.set(kAoRadius, 1.8);
    EXPECT_EQ(mean(render(scene, camera, 2)), 1.0);
    settings_.set(kAoRadius, 2.3);
    const double reached = mean(render(scene, camera, 8));
    // Rays within acos(2 / 2.3) of the normal reach it, whose cosine weight is sin^2.
    EXPECT_NEAR(reached, (2 / 2.3) * (2 / 2.3), 0.05);
}

INSTANTIATE_TEST_SUITE_P(Tracers, GridAmbientOcclusion, testing::Values("dda", "dda2d", "samples"),
                         [](const testing::TestParamInfo<const char*>& chosen) {
                             return std::string(chosen.param);
                         });

} // namespace
} // namespace romascope
