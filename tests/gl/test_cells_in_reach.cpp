// SPDX-License-Identifier: MIT
// Which cells of the spatial hash are emptied where something moves, by how far they lie from it.
#include "renderer/scene/gltf/import.h"
#include "renderer/tracers/occupancy/bit_grid.h"
#include "renderer/tracers/occupancy/occupancy_knobs.h"
#include "shaders/reuse/spatial_hash/search.h"
#include "shaders/reuse/spatial_hash/stale_cells.h"
#include "tests/gl/moving_cells.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <tuple>
#include <unordered_map>

namespace romascope {
namespace {

class CellsInReach : public MovingCells {
protected:
    /// The centre of each cell of level 0 by its slot, of the slots that are taken.
    std::map<size_t, glm::vec3> places(const std::vector<gpu::Cell>& cells, const Bounds& bounds) {
        const float inverse = 1.0f / smallest_cell_size(settings_);
        std::unordered_map<uint32_t, size_t> slots;
        std::vector<bool> taken(1u << 22); // by part of the checksum: nearly all keys have no cell
        for (size_t slot = 0; slot < cells.size(); ++slot) {
            if (cells[slot].checksum != 0) {
                slots[cells[slot].checksum] = slot;
                taken[cells[slot].checksum >> 10] = true;
            }
        }
        std::map<size_t, glm::vec3> places;
        const glm::ivec3 low = glm::ivec3(glm::floor(bounds.min * inverse)) - 3;
        const glm::ivec3 high = glm::ivec3(glm::floor(bounds.max * inverse)) + 3;
        const auto bins = static_cast<int>(settings_.get(kHashNormalBins));
        gpu::CellKey key{};
        for (int normal = 0; normal < (2 * bins + 1) * (2 * bins + 1) * (2 * bins + 1); ++normal) {
            const int side = 2 * bins + 1;
            key.normal =
                glm::ivec3(normal % side, normal / side % side, normal / side / side) - bins;
            const float length = glm::length(glm::vec3(key.normal)) / static_cast<float>(bins);
            if (length < 0.6f || length > 1.4f)
                continue; // no unit normal is rounded to it
            for (key.cell.z = low.z; key.cell.z <= high.z; ++key.cell.z)
                for (key.cell.y = low.y; key.cell.y <= high.y; ++key.cell.y)
                    for (key.cell.x = low.x; key.cell.x <= high.x; ++key.cell.x) {
                        const uint32_t checksum = gpu::key_checksum(key);
                        if (!taken[checksum >> 10])
                            continue;
                        const auto found = slots.find(checksum);
                        const auto mask = static_cast<uint32_t>(cells.size() - 1);
                        if (found != slots.end() &&
                            ((static_cast<uint32_t>(found->second) - gpu::home_hash(key)) & mask) <
                                static_cast<uint32_t>(settings_.get(kHashSearch)))
                            places[found->second] = gpu::cell_centre(key, inverse);
                    }
        }
        return places;
    }

    /// Points of the moving triangles in a pose, no farther from each other than `spacing`.
    static std::vector<glm::vec3> points_of_moving(const Scene& scene, const Pose& pose,
                                                   float spacing) {
        Scene posed = scene;
        apply_pose(posed, pose);
        std::vector<glm::vec3> points;
        for (size_t i = 0; i < posed.indices.size(); i += 3) {
            if (posed.indices[i] < posed.motion.first_vertex)
                continue;
            const glm::vec3 a = posed.positions[posed.indices[i]];
            const glm::vec3 ab = posed.positions[posed.indices[i + 1]] - a;
            const glm::vec3 ac = posed.positions[posed.indices[i + 2]] - a;
            const float longest =
                std::max({glm::length(ab), glm::length(ac), glm::length(ab - ac)});
            const auto steps = static_cast<int>(std::ceil(longest / spacing));
            for (int u = 0; u <= steps; ++u)
                for (int v = 0; u + v <= steps; ++v)
                    points.push_back(a + (static_cast<float>(u) * ab + static_cast<float>(v) * ac) /
                                             static_cast<float>(steps));
        }
        return points;
    }

    static float distance_to(const std::vector<glm::vec3>& points, glm::vec3 from) {
        float nearest = std::numeric_limits<float>::infinity();
        for (const glm::vec3 point : points) {
            const glm::vec3 way = point - from;
            nearest = std::min(nearest, glm::dot(way, way));
        }
        return std::sqrt(nearest);
    }

    /// By slot, how far the cells that were there lie from what moved: from the points of the
    /// moving triangles in both poses.
    std::map<size_t, float> distances(const std::vector<gpu::Cell>& cells, const Scene& scene,
                                      const Pose& from, const Pose& to, float spacing) {
        std::vector<glm::vec3> points = points_of_moving(scene, from, spacing);
        for (const glm::vec3 point : points_of_moving(scene, to, spacing))
            points.push_back(point);
        // Triangles share their corners.
        const auto before = [](glm::vec3 a, glm::vec3 b) {
            return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
        };
        std::ranges::sort(points, before);
        points.erase(std::unique(points.begin(), points.end()), points.end());
        Bounds bounds = scene.bounds;
        for (const glm::vec3 point : points)
            bounds.add(point);
        std::map<size_t, float> distances;
        for (const auto& [slot, centre] : places(cells, bounds))
            distances[slot] = distance_to(points, centre);
        return distances;
    }

    /// From a cell's centre to what is out of reach of all that it may take.
    float out_of_reach() const {
        return static_cast<float>(settings_.get(kAoRadius)) +
               smallest_cell_size(settings_) *
                   gpu::cell_radius(static_cast<float>(settings_.get(kHashJitter)));
    }

    /// Renders one pose, then a frame of another, and looks at the cells that are out of reach of
    /// all that moved: how many there are, and how many of them lost no samples.
    struct Kept {
        size_t far = 0, kept = 0;
        /// Of these, beyond the map's cell by which rays may find things nearer, too.
        size_t beyond_map = 0, kept_beyond_map = 0;
    };
    Kept kept_after(const Scene& scene, const Camera& camera, const Pose& from, const Pose& to,
                    int frames, float spacing) {
        Pipeline pipeline(scene, ShaderLibrary());
        render(pipeline, from, camera, frames);
        EXPECT_EQ(count(pipeline, "hash renewals"), 0u);
        const auto before = pipeline.spatial_hash().table().download();
        render(pipeline, to, camera, 1);
        EXPECT_GT(count(pipeline, "hash renewals"), 0u);
        const auto after = pipeline.spatial_hash().table().download();
        const float map_cell =
            OccupancyGrid::fit(scene.bounds, settings_.get(kOccupancyResolution), glm::vec3(0.0f))
                .cell_size;
        Kept kept;
        for (const auto& [slot, distance] : distances(before, scene, from, to, spacing)) {
            if (distance <= out_of_reach())
                continue;
            const bool keeps = gpu::cell_samples(after[slot]) >= gpu::cell_samples(before[slot]);
            const bool beyond_map = distance > out_of_reach() + map_cell;
            ++kept.far;
            kept.kept += keeps;
            kept.beyond_map += beyond_map;
            kept.kept_beyond_map += keeps && beyond_map;
        }
        return kept;
    }
};

TEST_F(CellsInReach, ThoseOutOfReachKeepTheirCounts) {
    const Scene scene = yard();
    const Kept found =
        kept_after(scene, scene.cameras[0], pose({-2, 0, -2}), pose({-1.5, 0, -2}), 12, 0.02f);
    EXPECT_GT(found.far, 4000u);
    EXPECT_GE(found.kept, found.far * 95 / 100) << "of " << found.far;
}

TEST_F(CellsInReach, MostOutOfReachOfTheDancersKeepTheirCounts) {
    const Scene scene =
        load_gltf(std::filesystem::path(ROMASCOPE_SOURCE_DIR) / "assets/dancers.glb");
    settings_ = Settings(all_knobs());
    settings_.set(kWidth, 240);
    settings_.set(kHeight, 135);
    settings_.set(kHashEnabled, true);
    settings_.set(kAoRadius, 2.0);
    settings_.set(kHashFixedSize, 0.2);
    settings_.set(kHashSampleCap, 5000);
    for (const Camera& camera : scene.cameras) {
        const Kept found = kept_after(scene, camera, pose_at(scene.motion, 0, 0.4),
                                      pose_at(scene.motion, 0, 1.2), 4, 0.2f);
        EXPECT_GT(found.far, 1000u) << camera.name;
        // What rays find may lie a cell of the map nearer than what moved: beyond the radius alone
        // the cells within that one cannot keep theirs.
        EXPECT_GE(found.kept_beyond_map, found.beyond_map * 90 / 100) << camera.name;
        EXPECT_GE(found.kept, found.far * 86 / 100) << camera.name;
        const auto share = [](size_t kept, size_t of) {
            return 100.0 * static_cast<double>(kept) / static_cast<double>(of);
        };
        std::printf("%s: of %zu cells beyond the radius and their extent %.1f %% keep their "
                    "counts, of %zu beyond a cell of the map more %.1f %%\n",
                    camera.name.c_str(), found.far, share(found.kept, found.far), found.beyond_map,
                    share(found.kept_beyond_map, found.beyond_map));
    }
}

TEST_F(CellsInReach, ThoseWithinReachAreWhatAFreshTableHas) {
    // Without jitter the same cells are used in every frame.
    settings_.set(kHashJitter, 0.0);
    const Scene scene = yard();
    const Pose from = pose({-2, 0, -2}), to = pose({-1.5, 0, -2});
    for (const uint32_t first : {0u, 0xFFFAu, 0xFFFFFFF6u, 0xFFFFFFF9u}) {
        Pipeline pipeline(scene, ShaderLibrary()), fresh(scene, ShaderLibrary());
        pipeline.restart(first);
        render(pipeline, from, scene.cameras[0], 6);
        const auto before = pipeline.spatial_hash().table().download();
        render(pipeline, to, scene.cameras[0], 1);
        const uint64_t renewals = count(pipeline, "hash renewals");
        render(pipeline, to, scene.cameras[0], 3);
        EXPECT_EQ(count(pipeline, "hash renewals"), 0u) << "once is enough";
        const auto after = pipeline.spatial_hash().table().download();
        fresh.restart(first + 6);
        render(fresh, to, scene.cameras[0], 4);
        std::map<uint32_t, gpu::Cell> anew;
        for (const gpu::Cell& cell : fresh.spatial_hash().table().download())
            anew[cell.checksum] = cell;

        size_t near = 0, emptied = 0;
        for (const auto& [slot, distance] : distances(before, scene, from, to, 0.02f)) {
            const auto found = anew.find(after[slot].checksum);
            if (found == anew.end())
                continue; // not seen since
            const bool equal = found->second.hits == after[slot].hits &&
                               found->second.samples == after[slot].samples;
            if (distance < static_cast<float>(settings_.get(kAoRadius))) {
                ++near;
                ASSERT_TRUE(equal) << distance;
            }
            emptied += equal;
        }
        EXPECT_GT(near, 150u);
        EXPECT_EQ(emptied, renewals);
    }
}

TEST_F(CellsInReach, CellsOutlastTheVolumesGrowth) {
    // What went far and came back leaves a volume that is larger than the scene. The map's cells
    // are large again where something goes far again, within it.
    settings_.set(kHashJitter, 0.0);
    settings_.set(kAoRadius, 0.2);
    settings_.set(kAoRays, 16);
    const Scene scene = yard();
    const Pose far = pose({-2, 0, 40}), away = pose({-2, 6, -2}), from = pose({-2, 0, -2});
    Pipeline pipeline(scene, ShaderLibrary());
    for (const Pose& pose : {from, far, from, away, from})
        render(pipeline, pose, scene.cameras[0], 6);
    const auto before = pipeline.spatial_hash().table().download();
    render(pipeline, far, scene.cameras[0], 1);
    const auto after = pipeline.spatial_hash().table().download();
    const uint32_t last_frame = 30;
    const float map_cell = 44.0f / 63.0f;
    size_t near = 0;
    for (const auto& [slot, distance] : distances(before, scene, from, from, 0.02f)) {
        if (gpu::cell_age(after[slot], last_frame) > 0 ||
            distance > static_cast<float>(settings_.get(kAoRadius)) + map_cell)
            continue; // not seen, or out of reach
        ++near;
        ASSERT_LT(gpu::cell_samples(after[slot]), gpu::cell_samples(before[slot])) << distance;
    }
    EXPECT_GT(near, 100u);
}

} // namespace
} // namespace romascope
