// SPDX-License-Identifier: MIT
#include "tests/gl/gl_test.h"

#include <bit>
#include <cmath>

namespace romascope {
namespace {

/// How far a cell's centre may lie from where a rasteriser takes its sample: GL allows vertices to
/// be rounded to 1/256 of a pixel (at least 4 bits of sub-pixels; both Mesa and NVIDIA have 8), and
/// rounding both ends of an edge can move it by twice that.
constexpr double kSlack = 1.0 / 128.0;

/// Three-axis sampling at cell centres in double precision: what each cell of the grid is, and
/// whether moving the centre by kSlack would change it.
struct SampledGrid {
    BitGrid certain;  ///< set wherever the centre may move
    BitGrid possible; ///< set for some place of the centre
};

using Triangle = std::array<glm::dvec3, 3>; ///< in cells

/// Depths of the triangle, in cells along `w`, over the square of half side kSlack around a centre.
/// Nothing if the square misses the triangle; `inside`: the whole square is within.
struct Depths {
    bool touches = false, inside = false;
    double low = 0, high = 0;
};

Depths depths_at(const Triangle& t, int u, int v, int w, double x, double y) {
    const double area =
        (t[1][u] - t[0][u]) * (t[2][v] - t[0][v]) - (t[1][v] - t[0][v]) * (t[2][u] - t[0][u]);
    Depths depths;
    depths.touches = depths.inside = true;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 a = t[i], b = t[(i + 1) % 3];
        const double length = std::hypot(b[u] - a[u], b[v] - a[v]);
        double distance = (b[u] - a[u]) * (y - a[v]) - (b[v] - a[v]) * (x - a[u]);
        distance *= area >= 0 ? 1 : -1;
        // A square's corner is sqrt(2) away; a sliver thinner than the slack is never certain.
        const double slack = kSlack * std::sqrt(2.0) * length;
        if (distance < -slack)
            return {};
        depths.inside = depths.inside && distance > slack;
    }
    double low = std::min({t[0][w], t[1][w], t[2][w]});
    double high = std::max({t[0][w], t[1][w], t[2][w]});
    if (std::abs(area) > 1e-9) {
        // Depth as a plane over the square. In compute a cell is 1/4096 longer.
        const glm::dvec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
        const double at = t[0][w] - (n[u] * (x - t[0][u]) + n[v] * (y - t[0][v])) / n[w];
        const double spread = kSlack * (std::abs(n[u]) + std::abs(n[v])) / std::abs(n[w]) + 4e-4;
        low = std::clamp(at - spread, low - 4e-4, high);
        high = std::clamp(at + spread, low, high + 4e-4);
    }
    depths.low = low;
    depths.high = high;
    return depths;
}

SampledGrid sample_on_cpu(const Scene& scene, const OccupancyGrid& grid) {
    SampledGrid sampled{BitGrid(grid.size), BitGrid(grid.size)};
    for (size_t i = 0; i < scene.indices.size(); i += 3) {
        Triangle t;
        for (size_t k = 0; k < 3; ++k)
            t[k] = (glm::dvec3(scene.positions[scene.indices[i + k]]) - glm::dvec3(grid.origin)) /
                   double(grid.cell_size);
        for (int w = 0; w < 3; ++w) {
            const int u = (w + 1) % 3, v = (w + 2) % 3;
            const auto range = [&](int axis) {
                const double low = std::min({t[0][axis], t[1][axis], t[2][axis]}) - 1;
                const double high = std::max({t[0][axis], t[1][axis], t[2][axis]}) + 1;
                return std::pair(std::max(0, static_cast<int>(low)),
                                 std::min(grid.size[axis] - 1, static_cast<int>(high)));
            };
            const auto [u0, u1] = range(u);
            const auto [v0, v1] = range(v);
            for (int b = v0; b <= v1; ++b) {
                for (int a = u0; a <= u1; ++a) {
                    const Depths depths = depths_at(t, u, v, w, a + 0.5, b + 0.5);
                    if (!depths.touches)
                        continue;
                    const int last = grid.size[w] - 1;
                    const int low = std::clamp(static_cast<int>(std::floor(depths.low)), 0, last);
                    const int high = std::clamp(static_cast<int>(std::floor(depths.high)), 0, last);
                    glm::ivec3 cell;
                    cell[u] = a;
                    cell[v] = b;
                    for (int depth = low; depth <= high; ++depth) {
                        cell[w] = depth;
                        sampled.possible.set(cell);
                        if (low == high && depths.inside)
                            sampled.certain.set(cell);
                    }
                }
            }
        }
    }
    return sampled;
}

class OccupancyTest : public GlTest {
protected:
    /// Builds the map of a scene, by each builder, and checks each cell; returns how many are set
    /// at least. Built in compute it is to be the same map, thin.
    size_t check_against_cpu(const Scene& scene, Settings settings, uint32_t frame_number) {
        size_t least = std::numeric_limits<size_t>::max();
        for (const OccupancyBuilder builder :
             {OccupancyBuilder::raster, OccupancyBuilder::compute}) {
            SCOPED_TRACE(builder == OccupancyBuilder::raster ? "raster" : "compute");
            settings.set(kOccupancyBuilder, builder);
            settings.set(kOccupancyCoverage, OccupancyCoverage::thin);
            least = std::min(least, check_as_set(scene, settings, frame_number));
        }
        return least;
    }

    size_t check_as_set(const Scene& scene, const Settings& settings, uint32_t frame_number) {
        const GpuScene gpu_scene(scene);
        OccupancyMap map;
        map.build(frame(gpu_scene, settings, 3, frame_number));
        const BitGrid built = map.download();
        map.build(frame(gpu_scene, settings, 3, frame_number), BaseStore::buffer);
        EXPECT_EQ(map.download(), built) << "in a buffer";
        const SampledGrid expected = sample_on_cpu(scene, map.grid());
        size_t missing = 0, extra = 0;
        for (size_t i = 0; i < built.words().size(); ++i) {
            missing += std::popcount(expected.certain.words()[i] & ~built.words()[i]);
            extra += std::popcount(built.words()[i] & ~expected.possible.words()[i]);
        }
        EXPECT_EQ(missing, 0u);
        EXPECT_EQ(extra, 0u);
        // The exception must stay an exception, or the comparison means nothing.
        EXPECT_GT(expected.certain.count(), 0.75 * expected.possible.count());
        return built.count();
    }

    std::vector<glm::vec3> random_triangles(int count, float size, unsigned seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> place(-1.0f, 1.0f);
        std::vector<glm::vec3> corners;
        for (int i = 0; i < count; ++i) {
            const glm::vec3 centre(place(random), 0.5f * place(random), 2.0f * place(random));
            for (int k = 0; k < 3; ++k)
                corners.push_back(centre + size * random_direction(random));
        }
        return corners;
    }

    Settings settings_{all_knobs()};
};

TEST_F(OccupancyTest, EqualsSamplingAtCellCentres) {
    for (const int resolution : {32, 50, 128}) {
        settings_.set(kOccupancyResolution, resolution);
        for (unsigned seed = 0; seed < 3; ++seed) {
            SCOPED_TRACE(testing::Message() << resolution << " cells, seed " << seed);
            const Scene scene = scene_of_triangles(random_triangles(40, 0.7f, seed));
            EXPECT_GT(check_against_cpu(scene, settings_, seed), 100u);
        }
    }
}

TEST_F(OccupancyTest, SmallTrianglesToo) {
    const Scene scene = scene_of_triangles(random_triangles(2000, 0.04f, 9));
    EXPECT_GT(check_against_cpu(scene, settings_, 0), 100u);
}

TEST_F(OccupancyTest, WallsNearlyAlongAnAxisToo) {
    // Seen edge on, a wall's depth runs through the whole grid within a pixel.
    std::mt19937 random(17);
    for (const float tilt : {0.0f, 1e-5f, 2e-4f, 1e-3f, 5e-3f, 8e-3f, 0.02f, 0.1f}) {
        SCOPED_TRACE(testing::Message() << "tilt " << tilt);
        std::vector<glm::vec3> corners;
        std::uniform_real_distribution<float> place(-1.0f, 1.0f);
        for (int i = 0; i < 24; ++i) {
            glm::vec3 normal(0.0f);
            normal[i % 3] = i % 2 ? 1.0f : -1.0f;
            const glm::vec3 centre(place(random), place(random), place(random));
            const glm::vec3 turned = glm::normalize(normal + tilt * random_direction(random));
            for (const glm::vec3 corner : rectangle(centre, turned, 0.3f + 0.2f * place(random)))
                corners.push_back(corner);
        }
        check_against_cpu(scene_of_triangles(corners), settings_, 1);
    }
}

TEST_F(OccupancyTest, FlatScenesHaveACell) {
    const Scene scene = scene_of_triangles(rectangle({1, 2, 3}, {0, 1, 0}, 5.0f));
    const GpuScene gpu_scene(scene);
    OccupancyMap map;
    map.build(frame(gpu_scene, settings_, 0, 0));
    EXPECT_EQ(map.grid().size.y, 1);
    // Every cell whose centre the rectangle covers: all but the one more for the shift.
    EXPECT_GE(map.download().count(), 127u * 127u);
}

TEST_F(OccupancyTest, GridFitsTheBoundsAndCoversThemUnderAnyShift) {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    std::uniform_int_distribution<int> cells(32, 256);
    for (int i = 0; i < 2000; ++i) {
        Bounds bounds;
        const glm::vec3 corner = 100.0f * glm::vec3(unit(random), unit(random), unit(random));
        const glm::vec3 size(unit(random), unit(random) * unit(random), unit(random));
        bounds.add(corner);
        bounds.add(corner + size);
        const glm::vec3 jitter(unit(random) * 0.999f, unit(random) * 0.999f, unit(random) * 0.999f);
        const int resolution = cells(random);
        const OccupancyGrid grid = OccupancyGrid::fit(bounds, resolution, jitter);
        EXPECT_EQ(std::max({grid.size.x, grid.size.y, grid.size.z}), resolution);
        for (int axis = 0; axis < 3; ++axis) {
            const float reach = static_cast<float>(grid.size[axis]) * grid.cell_size;
            EXPECT_LE(grid.origin[axis], bounds.min[axis]);
            EXPECT_GE(grid.origin[axis] + reach, bounds.max[axis] - 1e-4f * grid.cell_size);
            // No more than the extent, one cell, and what rounding up to whole cells costs.
            EXPECT_LT(reach, bounds.extent()[axis] + 2.001f * grid.cell_size);
        }
    }
}

TEST_F(OccupancyTest, MemoryDoesNotDependOnTriangles) {
    const Scene few = scene_of_triangles(random_triangles(100, 0.3f, 1));
    std::vector<glm::vec3> corners = random_triangles(1000, 0.2f, 2);
    for (glm::vec3& corner : corners) // the same bounds, so the same grid
        corner = glm::clamp(corner, few.bounds.min, few.bounds.max);
    corners.push_back(few.bounds.min);
    corners.push_back(few.bounds.max);
    corners.push_back({few.bounds.min.x, few.bounds.max.y, few.bounds.min.z});
    const Scene many = scene_of_triangles(corners);
    const GpuScene gpu_few(few), gpu_many(many);
    RomaTracer a, b;
    a.build(frame(gpu_few, settings_));
    b.build(frame(gpu_many, settings_));
    ASSERT_EQ(a.bytes().size(), b.bytes().size());
    for (size_t i = 0; i < a.bytes().size(); ++i)
        EXPECT_EQ(a.bytes()[i].bytes, b.bytes()[i].bytes) << a.bytes()[i].name;
}

TEST_F(OccupancyTest, JitterMovesTheGridByLessThanACell) {
    const Scene scene = scene_of_triangles(random_triangles(10, 0.3f, 1));
    const GpuScene gpu_scene(scene);
    OccupancyMap map;
    glm::vec3 mean(0.0f);
    constexpr int kCount = 64;
    for (uint32_t number = 0; number < kCount; ++number) {
        map.build(frame(gpu_scene, settings_, 0, number));
        const glm::vec3 shift = (scene.bounds.min - map.grid().origin) / map.grid().cell_size;
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(shift[axis], -1e-3f);
            EXPECT_LT(shift[axis], 1.001f);
        }
        mean += shift / float(kCount);
    }
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(mean[axis], 0.5f, 0.05f); // evenly spread
    settings_.set(kOccupancyJitter, 0.0);
    map.build(frame(gpu_scene, settings_, 0, 5));
    EXPECT_EQ(map.grid().origin, scene.bounds.min);
}

TEST_F(OccupancyTest, OneAxisLeavesHolesInSteepSurfaces) {
    // A wall along z, seen edge on from z: nothing of it covers a cell's centre.
    std::vector<glm::vec3> corners = rectangle({0.313f, 0, 0}, {1, 0, 0}, 1.0f);
    const std::vector<glm::vec3> floor = rectangle({0, 0, -1}, {0, 0, 1}, 1.0f);
    corners.insert(corners.end(), floor.begin(), floor.end());
    const Scene scene = scene_of_triangles(corners);
    const GpuScene gpu_scene(scene);
    settings_.set(kOccupancyBuilder, OccupancyBuilder::raster);
    OccupancyMap map;
    map.build(frame(gpu_scene, settings_));
    const size_t all = map.download().count();
    settings_.set(kOccupancyAxes, OccupancyAxes::z);
    map.build(frame(gpu_scene, settings_));
    EXPECT_LT(map.download().count(), 0.6 * static_cast<double>(all));
}

} // namespace
} // namespace romascope
