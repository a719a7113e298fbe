// SPDX-License-Identifier: MIT
// The occupancy map built in compute: the CPU twin's cells, bit for bit.
#include "renderer/tracers/occupancy/voxelize_cpu.h"
#include "shaders/tracers/occupancy/work_list.h"
#include "tests/gl/gl_test.h"
#include "tests/support/random_triangles.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace romascope {
namespace {

constexpr OccupancyCoverage kCoverages[] = {OccupancyCoverage::thin,
                                            OccupancyCoverage::conservative};
/// Cells along the test scenes' sides; they are that many metres minus one long.
constexpr int kSide = 64;

class OccupancyComputeTest : public GlTest {
protected:
    OccupancyComputeTest() {
        settings_.set(kOccupancyBuilder, OccupancyBuilder::compute);
        settings_.set(kOccupancyResolution, kSide);
    }

    /// Corners in cells become metres; anything beyond the box of the grid too.
    static Scene scene_in_cells(const std::vector<glm::vec3>& corners) {
        Scene scene = scene_of_triangles(corners);
        scene.bounds = Bounds{glm::vec3(0.0f), glm::vec3(kSide - 1)};
        return scene;
    }

    BitGrid build(const Scene& scene, OccupancyCoverage coverage, uint32_t number = 0) {
        settings_.set(kOccupancyCoverage, coverage);
        const GpuScene gpu_scene(scene);
        const auto built = [&](Invocations invocations, BaseStore store) {
            settings_.set(kOccupancyInvocations, invocations);
            map_.build(frame(gpu_scene, settings_, 0, number), store);
            return map_.download();
        };
        const BitGrid by_many = built(Invocations::many, BaseStore::texture);
        EXPECT_EQ(built(Invocations::few, BaseStore::texture), by_many);
        EXPECT_EQ(built(Invocations::many, BaseStore::buffer), by_many);
        EXPECT_EQ(built(Invocations::few, BaseStore::buffer), by_many);
        return by_many;
    }

    /// Builds with both coverages and compares; how many cells are set.
    size_t expect_twin(const Scene& scene, uint32_t number = 0) {
        size_t count = 0;
        for (const OccupancyCoverage coverage : kCoverages) {
            const BitGrid built = build(scene, coverage, number);
            const BitGrid twin = voxelize_on_cpu(scene, map_.grid(), coverage);
            size_t differ = 0;
            for (size_t i = 0; i < built.words().size(); ++i)
                differ += static_cast<size_t>(std::popcount(built.words()[i] ^ twin.words()[i]));
            EXPECT_EQ(differ, 0u) << (coverage == OccupancyCoverage::thin ? "thin"
                                                                          : "conservative");
            count += built.count();
        }
        return count;
    }

    std::vector<glm::vec3> corners_of(std::initializer_list<TriangleKind> kinds, int count,
                                      unsigned seed) {
        std::mt19937 random(seed);
        std::vector<glm::vec3> corners;
        for (int i = 0; i < count; ++i)
            for (const TriangleKind kind : kinds)
                for (const glm::vec3 corner : random_triangle(kind, glm::vec3(kSide), random))
                    corners.push_back(corner);
        return corners;
    }

    Settings settings_{all_knobs()};
    OccupancyMap map_;
};

TEST_F(OccupancyComputeTest, EqualsTheTwinForTrianglesOfAllKinds) {
    for (int kind = 0; kind < kTriangleKinds; ++kind) {
        for (const int count : {30, 60}) { // few are taken in another way
            SCOPED_TRACE(fmt::format("{} of kind {}", count, kind));
            const auto which = static_cast<TriangleKind>(kind);
            const size_t set = expect_twin(scene_in_cells(corners_of({which}, count, 5)), 3);
            const int least = which == TriangleKind::point ? count * 5 / 6 : count * 5 / 3;
            EXPECT_GT(set, static_cast<size_t>(least));
        }
    }
}

TEST_F(OccupancyComputeTest, EqualsTheTwinInGridsOfOtherShapes) {
    for (const int resolution : {32, 33, 100, 256}) {
        settings_.set(kOccupancyResolution, resolution);
        Scene scene = scene_of_triangles(
            corners_of({TriangleKind::small, TriangleKind::large, TriangleKind::strip}, 12, 9));
        for (glm::vec3& position : scene.positions)
            position *= glm::vec3(1.0f, 0.2f, 0.6f);
        scene.bounds = {};
        for (const glm::vec3& position : scene.positions)
            scene.bounds.add(position);
        EXPECT_GT(expect_twin(scene, 2), 1000u);
    }
}

TEST_F(OccupancyComputeTest, MoreLargeTrianglesThanTheListHoldsAreRightToo) {
    // Copies of one triangle fill the list; those after it are done where they are found.
    const CellCorners filler = {glm::vec3(1, 2, 3), glm::vec3(22, 23, 4), glm::vec3(21, 23, 5)};
    const std::vector<glm::vec3> others = corners_of(
        {TriangleKind::middling, TriangleKind::large, TriangleKind::needle, TriangleKind::small},
        20, 4);
    std::vector<glm::vec3> corners(filler.begin(), filler.end());
    corners.insert(corners.end(), others.begin(), others.end());
    const Scene distinct = scene_in_cells(corners);
    Scene scene = distinct;
    scene.indices.clear();
    for (uint32_t i = 0; i < gpu::kWorkListLength + 5000; ++i)
        scene.indices.insert(scene.indices.end(), {0, 1, 2});
    scene.indices.insert(scene.indices.end(), distinct.indices.begin() + 3, distinct.indices.end());
    for (const OccupancyCoverage coverage : kCoverages) {
        const BitGrid built = build(scene, coverage);
        EXPECT_EQ(built, voxelize_on_cpu(distinct, map_.grid(), coverage));
        // In the middle of the list.
        std::rotate(scene.indices.begin(), scene.indices.end() - 120, scene.indices.end());
        EXPECT_EQ(build(scene, coverage), built);
        std::rotate(scene.indices.begin(), scene.indices.begin() + 120, scene.indices.end());
    }
}

TEST_F(OccupancyComputeTest, TheOrderOfTrianglesDoesNotMatter) {
    Scene scene = scene_in_cells(corners_of(
        {TriangleKind::small, TriangleKind::middling, TriangleKind::large, TriangleKind::needle},
        100, 6));
    std::mt19937 random(1);
    for (const OccupancyCoverage coverage : kCoverages) {
        const BitGrid first = build(scene, coverage);
        for (int i = 0; i < 3; ++i) {
            std::vector<size_t> order(scene.triangle_count());
            for (size_t k = 0; k < order.size(); ++k)
                order[k] = k;
            std::shuffle(order.begin(), order.end(), random);
            std::vector<uint32_t> indices;
            for (const size_t triangle : order)
                for (size_t k = 0; k < 3; ++k)
                    indices.push_back(scene.indices[3 * triangle + k]);
            scene.indices = indices;
            EXPECT_EQ(build(scene, coverage), first);
        }
    }
}

TEST_F(OccupancyComputeTest, MasksAreLookedUpLikeOnTheTwin) {
    std::mt19937 random(12);
    Scene scene = scene_in_cells(corners_of(
        {TriangleKind::small, TriangleKind::middling, TriangleKind::large, TriangleKind::flat}, 60,
        7));
    SurfaceTexture texture;
    texture.size = {8, 8};
    for (int i = 0; i < 64; ++i)
        texture.texels.push_back(random() | 0x00ffffffu);
    scene.textures = {texture};
    scene.materials.push_back({.texture = 0, .alpha_cutoff = 0.5f, .double_sided = true});
    scene.materials.push_back({.alpha_cutoff = 0.4f});
    std::uniform_real_distribution<float> place(-2.0f, 2.0f);
    for (size_t i = 0; i < scene.positions.size(); ++i) {
        scene.vertex_material[i] = static_cast<uint32_t>(i / 3 % 3);
        scene.texcoords.emplace_back(place(random), place(random));
    }
    sort_by_group(scene);
    const size_t masked = expect_twin(scene, 1);
    scene.colors.assign(scene.positions.size(), 0);
    for (uint32_t& color : scene.colors)
        color = static_cast<uint32_t>(random());
    const size_t colored = expect_twin(scene, 1);
    scene.texcoords.clear();
    EXPECT_GT(expect_twin(scene, 1), 1000u);
    for (Material& material : scene.materials)
        material.alpha_cutoff = 0.0f;
    const size_t whole = expect_twin(scene, 1);
    EXPECT_LT(masked, 0.9 * static_cast<double>(whole));
    EXPECT_LT(colored, masked);
}

TEST_F(OccupancyComputeTest, MemoryIsWhatWasForetold) {
    const Scene scene =
        scene_of_triangles({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 0, 1}, {0, 1, 0}, {1, 1, 0}});
    build(scene, OccupancyCoverage::thin);
    EXPECT_EQ(map_.bytes().bytes, OccupancyMap::bytes_needed(settings_));
    settings_.set(kOccupancyBuilder, OccupancyBuilder::raster);
    build(scene, OccupancyCoverage::thin);
    EXPECT_EQ(map_.bytes().bytes, OccupancyMap::bytes_needed(settings_));
}

} // namespace
} // namespace romascope
