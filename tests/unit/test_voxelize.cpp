// SPDX-License-Identifier: MIT
// No path from cell to cell through faces leads through a closed surface.
#include "renderer/tracers/occupancy/voxelize_cpu.h"
#include "tests/support/closed_meshes.h"

#include <gtest/gtest.h>

#include <queue>

namespace romascope {
namespace {

constexpr int kSide = 40;

/// Cells as metres, so that a mesh is placed in cells.
OccupancyGrid cells_of_a_metre() {
    OccupancyGrid grid;
    grid.size = glm::ivec3(kSide);
    return grid;
}

Scene scene_of(const ClosedMesh& mesh) {
    Scene scene;
    scene.materials.resize(1);
    scene.positions = mesh.positions;
    scene.indices = mesh.indices;
    scene.vertex_material.assign(mesh.positions.size(), 0);
    return scene;
}

/// Cells that are reached through faces from `start` without stepping on an occupied one.
BitGrid flood(const BitGrid& walls, glm::ivec3 start) {
    BitGrid reached(walls.size());
    std::queue<glm::ivec3> next;
    const auto visit = [&](glm::ivec3 cell) {
        for (int axis = 0; axis < 3; ++axis)
            if (cell[axis] < 0 || cell[axis] >= walls.size()[axis])
                return;
        if (walls.get(cell) || reached.get(cell))
            return;
        reached.set(cell);
        next.push(cell);
    };
    visit(start);
    while (!next.empty()) {
        const glm::ivec3 cell = next.front();
        next.pop();
        for (int axis = 0; axis < 3; ++axis)
            for (const int step : {-1, 1}) {
                glm::ivec3 neighbour = cell;
                neighbour[axis] += step;
                visit(neighbour);
            }
    }
    return reached;
}

/// Floods from a corner, which must be outside, and counts cells whose centre lies inside by
/// `inside(point)`, and how many of them were reached.
template <class Inside>
void expect_tight(const ClosedMesh& mesh, Inside&& inside, size_t& enclosed) {
    for (const OccupancyCoverage coverage :
         {OccupancyCoverage::thin, OccupancyCoverage::conservative}) {
        const BitGrid cells = voxelize_on_cpu(scene_of(mesh), cells_of_a_metre(), coverage);
        ASSERT_FALSE(cells.get({0, 0, 0}));
        const BitGrid reached = flood(cells, {0, 0, 0});
        size_t leaked = 0;
        for (int z = 0; z < kSide; ++z)
            for (int y = 0; y < kSide; ++y)
                for (int x = 0; x < kSide; ++x) {
                    if (!inside(glm::vec3(x, y, z) + 0.5f))
                        continue;
                    ++enclosed;
                    leaked += reached.get({x, y, z});
                }
        EXPECT_EQ(leaked, 0u) << (coverage == OccupancyCoverage::thin ? "thin" : "conservative");
    }
}

glm::mat4 placed(glm::vec3 centre, const glm::mat4& turn, glm::vec3 half) {
    return glm::scale(glm::translate(glm::mat4(1.0f), centre) * turn, half);
}

/// Whether a point is inside of the box, by more than rounding.
auto inside_box(const glm::mat4& matrix) {
    return [inverse = glm::inverse(glm::dmat4(matrix)), matrix](glm::vec3 point) {
        const glm::dvec3 local(inverse * glm::dvec4(glm::dvec3(point), 1.0));
        for (int axis = 0; axis < 3; ++axis) {
            const double half = glm::length(glm::dvec3(matrix[axis]));
            if (std::abs(local[axis]) * half > half - 1e-3)
                return false;
        }
        return true;
    };
}

TEST(Voxelize, BoxesAndSlabsAreTightAtAnyAngle) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    size_t enclosed = 0;
    for (int i = 0; i < 150; ++i) {
        SCOPED_TRACE(testing::Message() << "box " << i);
        glm::vec3 half(2.0f + 9.0f * unit(random), 2.0f + 9.0f * unit(random),
                       2.0f + 9.0f * unit(random));
        if (i % 3 == 0) // a slab, down to a hundredth of a cell
            half[i / 3 % 3] = 0.005f + 0.7f * unit(random) * unit(random);
        const glm::vec3 centre = 19.0f + 2.0f * glm::vec3(unit(random), unit(random), unit(random));
        const glm::mat4 matrix = placed(centre, random_turn(random), half);
        expect_tight(box_mesh(matrix), inside_box(matrix), enclosed);
    }
    EXPECT_GT(enclosed, 100000u);
}

TEST(Voxelize, BoxesAlongTheAxesAreTightToo) {
    // Faces at whole and half cells, where every test is a tie, and all but at right angles.
    std::mt19937 random(4);
    std::uniform_int_distribution<int> halves(4, 20);
    size_t enclosed = 0;
    for (const float tilt : {0.0f, 1e-6f, 1e-5f, 1e-4f, 5e-4f, 2e-3f, 1e-2f}) {
        for (int i = 0; i < 20; ++i) {
            SCOPED_TRACE(testing::Message() << "tilt " << tilt << ", box " << i);
            const glm::vec3 half =
                0.5f * glm::vec3(halves(random), halves(random), halves(random)) +
                (i & 1 ? 0.25f : 0.0f);
            const glm::vec3 centre(20.0f + (i & 2 ? 0.5f : 0.0f), 20.0f, 20.0f);
            glm::mat4 turn(1.0f);
            if (tilt > 0)
                turn = glm::rotate(glm::mat4(1.0f), tilt,
                                   glm::normalize(glm::vec3(1.0f, i % 5 - 2.0f, i % 3 - 1.0f)));
            const glm::mat4 matrix = placed(centre, turn, half);
            expect_tight(box_mesh(matrix), inside_box(matrix), enclosed);
        }
    }
    EXPECT_GT(enclosed, 100000u);
}

TEST(Voxelize, SpheresOfAnyFinenessAreTight) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    std::uniform_int_distribution<int> pieces(5, 90);
    size_t enclosed = 0;
    for (int i = 0; i < 60; ++i) {
        SCOPED_TRACE(testing::Message() << "sphere " << i);
        const float radius = 3.0f + 12.0f * unit(random);
        const glm::vec3 centre = 19.0f + 2.0f * glm::vec3(unit(random), unit(random), unit(random));
        const int rings = pieces(random), sectors = pieces(random);
        const ClosedMesh mesh =
            sphere_mesh(placed(centre, random_turn(random), glm::vec3(radius)), rings, sectors);
        // A sphere inside of the mesh.
        const float inner = radius * std::cos(3.15f / static_cast<float>(rings)) *
                                std::cos(3.15f / static_cast<float>(sectors)) -
                            0.01f;
        expect_tight(
            mesh, [&](glm::vec3 point) { return glm::distance(point, centre) < inner; }, enclosed);
    }
    EXPECT_GT(enclosed, 100000u);
}

TEST(Voxelize, ThinSheetsDivideTheGrid) {
    // A plane through the whole grid, in two large triangles: one side is not reached from the
    // other.
    std::mt19937 random(6);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    for (int i = 0; i < 200; ++i) {
        SCOPED_TRACE(testing::Message() << "plane " << i);
        const glm::mat4 turn = random_turn(random);
        const glm::vec3 normal(turn[2]);
        const glm::vec3 centre = 18.0f + 4.0f * glm::vec3(unit(random), unit(random), unit(random));
        ClosedMesh sheet;
        for (const glm::vec2 corner : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
            sheet.positions.push_back(
                centre + 80.0f * (corner.x * glm::vec3(turn[0]) + corner.y * glm::vec3(turn[1])));
        sheet.quad(0, 1, 2, 3);
        const BitGrid cells =
            voxelize_on_cpu(scene_of(sheet), cells_of_a_metre(), OccupancyCoverage::thin);
        const glm::ivec3 start(kSide * (normal.x > 0), kSide * (normal.y > 0),
                               kSide * (normal.z > 0));
        const BitGrid reached = flood(cells, glm::min(start, kSide - 1));
        size_t leaked = 0, far_side = 0;
        for (int z = 0; z < kSide; ++z)
            for (int y = 0; y < kSide; ++y)
                for (int x = 0; x < kSide; ++x) {
                    const float height = glm::dot(normal, glm::vec3(x, y, z) + 0.5f - centre);
                    far_side += height < -1e-3f;
                    leaked += height < -1e-3f && reached.get({x, y, z});
                }
        EXPECT_EQ(leaked, 0u);
        EXPECT_GT(far_side, 5000u);
        // And it is thin: one cell a column, along the axis that it faces most, and ties.
        EXPECT_LT(cells.count(), 1.9 * kSide * kSide);
    }
}

} // namespace
} // namespace romascope
