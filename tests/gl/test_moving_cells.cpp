// SPDX-License-Identifier: MIT
// Which cells of the spatial hash are emptied where something moves, and when.
#include "renderer/base/files.h"
#include "renderer/scene/gltf/import.h"
#include "renderer/tracers/occupancy/bit_grid.h"
#include "renderer/tracers/occupancy/occupancy_knobs.h"
#include "renderer/tracers/structure_view.h"
#include "shaders/reuse/spatial_hash/search.h"
#include "shaders/reuse/spatial_hash/stale_cells.h"
#include "tests/gl/gl_test.h"
#include "tests/support/moving_scene.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <tuple>
#include <unordered_map>

namespace romascope {
namespace {

class MovingCells : public GlTest {
protected:
    static constexpr float kCell = 0.1f;

    MovingCells() {
        settings_.set(kWidth, 96);
        settings_.set(kHeight, 72);
        settings_.set(kOccupancyResolution, 64);
        settings_.set(kAoRadius, 0.6);
        settings_.set(kHashEnabled, true);
        settings_.set(kHashCapacity, 16);
        settings_.set(kHashFixedSize, double{kCell});
        settings_.set(kHashSampleCap, 32768);
    }

    /// A floor of 8 m with posts on it, and a block that stands where pose() puts it.
    static Scene yard() {
        MovingSceneBuilder builder;
        std::vector<glm::vec3> corners = rectangle({0, 0, 0}, {0, 1, 0}, 4.0f);
        for (const glm::vec2 place : {glm::vec2(-3, -1), glm::vec2(-1, -3), glm::vec2(2, 2)})
            add_box(corners, {place.x, 0.3f, place.y}, 0.3f);
        add_box(corners, {3.8f, 1.8f, 3.8f}, 0.2f); // so that what jumps stays within bounds
        builder.add_still(corners);
        std::vector<glm::vec3> block;
        add_box(block, {0, 0.25f, 0}, 0.25f);
        const uint32_t node = builder.add_node({});
        builder.add_moving({block, std::vector<glm::vec3>(block.size()), node, -1, 0, {}, {}});
        Scene scene = builder.build();
        scene.cameras = {look_at("above", {0.5f, 9, 0}, {0, 0, 0}, 0.9f),
                         look_at("sky", {0, 5, 0}, {0, 9, 1}, 0.9f)};
        return scene;
    }

    static Pose pose(glm::dvec3 place) {
        Pose pose{{glm::dmat4(1.0)}, {}};
        pose.node_to_world[0][3] = glm::dvec4(place, 1.0);
        return pose;
    }

    void render(Pipeline& pipeline, const Pose& pose, const Camera& camera, int frames) {
        for (int i = 0; i < frames; ++i) {
            pipeline.set_pose(pose);
            pipeline.render(settings_, camera);
        }
    }

    static uint64_t count(const Pipeline& pipeline, const std::string& name) {
        for (const NamedCount& count : pipeline.counts())
            if (count.name == name)
                return count.count;
        ADD_FAILURE() << "no count " << name;
        return 0;
    }

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

    Settings settings_{all_knobs()};
};

TEST_F(MovingCells, ThoseOutOfReachKeepTheirCounts) {
    const Scene scene = yard();
    const Kept found =
        kept_after(scene, scene.cameras[0], pose({-2, 0, -2}), pose({-1.5, 0, -2}), 12, 0.02f);
    EXPECT_GT(found.far, 4000u);
    EXPECT_GE(found.kept, found.far * 95 / 100) << "of " << found.far;
}

TEST_F(MovingCells, AFrameThatFailsAfterTheHashCountsAsOne) {
    const Scene scene = yard();
    settings_.set(kViewStructure, "no such view");
    const auto picture_after = [&](bool fails) {
        Pipeline pipeline(scene, ShaderLibrary());
        render(pipeline, pose({-2, 0, -2}), scene.cameras[0], 4);
        if (fails) {
            settings_.set(kView, PictureKind::structure);
            EXPECT_THROW(render(pipeline, pose({-1.5, 0, -2}), scene.cameras[0], 1), Error);
            settings_.set(kView, PictureKind::ambient_occlusion);
        } else {
            render(pipeline, pose({-1.5, 0, -2}), scene.cameras[0], 1);
        }
        render(pipeline, pose({-1, 0, -2}), scene.cameras[0], 1);
        return pipeline.picture();
    };
    EXPECT_EQ(picture_after(true).data, picture_after(false).data);
}

TEST_F(MovingCells, MostOutOfReachOfTheDancersKeepTheirCounts) {
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

TEST_F(MovingCells, ThoseWithinReachAreWhatAFreshTableHas) {
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

TEST_F(MovingCells, NoneIsKeptWhoseRaysFindSomethingElse) {
    // The same rays in both poses: cells from where any of them ends otherwise. Without jitter the
    // same cells are used in every frame.
    settings_.set(kHashJitter, 0.0);
    settings_.set(kAoRays, 16);
    settings_.set(kHashSmallest, 0.1);
    const Scene scene = yard();
    constexpr int kFrames = 6;
    const auto cells_of = [](const Pipeline& pipeline) {
        std::map<uint32_t, gpu::Cell> cells;
        for (const gpu::Cell& cell : pipeline.spatial_hash().table().download())
            if (cell.checksum != 0)
                cells[cell.checksum] = cell;
        return cells;
    };
    // Sizes: one; one that is large beside the reach; sizes by distance, mixed, of which the larger
    // ones have a reach of their own, and the largest have none.
    for (const auto& [fixed, footprint] :
         {std::pair(0.1, 5.0), std::pair(0.5, 5.0), std::pair(0.0, 1.0), std::pair(0.0, 5.0)}) {
        settings_.set(kHashFixedSize, fixed);
        settings_.set(kHashFootprint, footprint);
        for (const auto& [from, to] : {std::pair(pose({-2, 0, -2}), pose({-1.5, 0, -2})),
                                       std::pair(pose({-0.3, 0, 2}), pose({2.9, 0.6, -2.8}))}) {
            const auto table_of = [&](const Pose& pose) {
                Pipeline pipeline(scene, ShaderLibrary());
                render(pipeline, pose, scene.cameras[0], kFrames);
                return cells_of(pipeline);
            };
            const auto in_from = table_of(from), in_to = table_of(to);
            // Seen at once, and after another move that nobody saw, of another place.
            for (const bool seen : {true, false}) {
                Pipeline pipeline(scene, ShaderLibrary());
                render(pipeline, from, scene.cameras[0], kFrames);
                const auto before = cells_of(pipeline);
                if (!seen) {
                    render(pipeline, pose({3, 0, 3}), scene.cameras[1], 1);
                    render(pipeline, to, scene.cameras[1], 1);
                }
                render(pipeline, to, scene.cameras[0], 1);
                EXPECT_GT(count(pipeline, "hash renewals"), 0u);
                const auto after = cells_of(pipeline);
                size_t differ = 0;
                for (const auto& [checksum, cell] : before) {
                    const auto a = in_from.find(checksum), b = in_to.find(checksum);
                    if (a == in_from.end() || b == in_to.end() ||
                        gpu::cell_samples(a->second) != gpu::cell_samples(b->second) ||
                        gpu::cell_hits(a->second) == gpu::cell_hits(b->second))
                        continue;
                    ++differ;
                    ASSERT_LT(gpu::cell_samples(after.at(checksum)), gpu::cell_samples(cell));
                }
                EXPECT_GT(differ, 4u) << fixed << " " << footprint << " " << seen;
            }
        }
    }
}

TEST_F(MovingCells, WhatHardlyMovesEmptiesNone) {
    // Neither near, nor of cells that are larger than all reaches, nor beyond the volume's border.
    settings_.set(kHashSmallest, 0.02);
    settings_.set(kHashJitter, 4.0);
    const Scene scene = yard();
    for (const auto& [fixed, footprint] : {std::pair(0.0, 2.0), std::pair(0.0, 12.0)}) {
        settings_.set(kHashFixedSize, fixed);
        settings_.set(kHashFootprint, footprint);
        Pipeline pipeline(scene, ShaderLibrary());
        for (int frame = 0; frame < 4; ++frame) {
            render(pipeline, pose({-2 + 0.001 * frame, 0, -2}), scene.cameras[0], 1);
            EXPECT_EQ(count(pipeline, "hash renewals"), 0u) << frame;
        }
        EXPECT_GT(count(pipeline, "hash cells"), 20u);
    }
}

TEST_F(MovingCells, CellsOutlastTheVolumesGrowth) {
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

TEST_F(MovingCells, AFrameThatFailsInTheHashForgetsAll) {
    const Scene scene = yard();
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / fmt::format("romascope-broken-{}", getpid());
    const auto write_broken = [&](const std::string& file, const std::string& condition) {
        const auto source = std::filesystem::path(ROMASCOPE_SOURCE_DIR) / "shaders";
        std::filesystem::remove_all(folder);
        std::filesystem::copy(source, folder, std::filesystem::copy_options::recursive);
        write_file_atomically(folder / file, read_text_file(source / file) + "\n#if " + condition +
                                                 "\n#error broken\n#endif\n");
        return ShaderLibrary(folder);
    };
    const auto expect_all_forgotten = [&](Pipeline& pipeline, const Pose& pose) {
        render(pipeline, pose, scene.cameras[0], 1);
        EXPECT_GT(count(pipeline, "hash cells"), 100u);
        EXPECT_EQ(count(pipeline, "hash insertions"), count(pipeline, "hash cells"));
    };
    {
        // After cells were claimed, whose last use is not known any more.
        Pipeline pipeline(scene, write_broken("reuse/spatial_hash/add.comp.glsl", "AO_RAYS == 7"));
        render(pipeline, pose({-2, 0, -2}), scene.cameras[0], 4);
        settings_.set(kAoRays, 7);
        EXPECT_THROW(render(pipeline, pose({-2, 0, -2}), scene.cameras[0], 1), Error);
        settings_.set(kAoRays, 1);
        expect_all_forgotten(pipeline, pose({-1.5, 0, -2}));
    }
    {
        // While looking for what moved.
        Pipeline pipeline(scene, write_broken("reuse/changes/block_distance.comp.glsl", "1"));
        render(pipeline, pose({-2, 0, -2}), scene.cameras[0], 4);
        EXPECT_THROW(render(pipeline, pose({-1.5, 0, -2}), scene.cameras[0], 1), Error);
        expect_all_forgotten(pipeline, pose({-1.5, 0, -2}));
    }
    std::filesystem::remove_all(folder);
    log_.emplace(); // some drivers speak of what does not compile
}

TEST_F(MovingCells, UnseenOnesAreEmptiedWhenTheyAreSeenAgain) {
    settings_.set(kHashJitter, 0.0);
    const Scene scene = yard();
    const Pose from = pose({-2, 0, -2}), to = pose({-1.5, 0, -2}), back = pose({-2, 0, -2.001});
    for (const bool evicts : {true, false}) {
        settings_.set(kHashEvict, evicts);
        Pipeline pipeline(scene, ShaderLibrary()), watching(scene, ShaderLibrary());
        render(watching, from, scene.cameras[0], 6);
        render(watching, to, scene.cameras[0], 1);
        render(pipeline, from, scene.cameras[0], 6);
        render(pipeline, to, scene.cameras[1], 3);
        render(pipeline, to, scene.cameras[1], 5);
        EXPECT_EQ(count(pipeline, "hash renewals"), 0u) << "nothing is seen";
        render(pipeline, to, scene.cameras[0], 1);
        EXPECT_EQ(count(pipeline, "hash renewals"), count(watching, "hash renewals"));
        EXPECT_GT(count(pipeline, "hash renewals"), 150u);
        render(pipeline, to, scene.cameras[0], 1);
        EXPECT_EQ(count(pipeline, "hash renewals"), 0u);
        // There and back while nobody looks.
        render(pipeline, back, scene.cameras[1], 1);
        render(pipeline, to, scene.cameras[1], 1);
        render(pipeline, to, scene.cameras[0], 1);
        EXPECT_GT(count(pipeline, "hash renewals"), 150u);
    }
}

TEST_F(MovingCells, NoGhostIsLeft) {
    const Scene scene = yard();
    const Pose from = pose({-2, 0, -2}), to = pose({0.5, 0, 0.5});
    settings_.set(kMean, false);
    // One size of cells; sizes by distance, mixed; and cells larger than all reaches are told for.
    for (const auto& [fixed, smallest, footprint] :
         {std::tuple(0.1, 0.07, 5.0), std::tuple(0.0, 0.02, 1.0), std::tuple(0.0, 0.02, 12.0)}) {
        settings_.set(kHashFixedSize, fixed);
        settings_.set(kHashSmallest, smallest);
        settings_.set(kHashFootprint, footprint);
        Pipeline pipeline(scene, ShaderLibrary()), fresh(scene, ShaderLibrary());
        render(pipeline, from, scene.cameras[0], 40);
        render(pipeline, to, scene.cameras[0], 24);
        fresh.restart(40);
        render(fresh, to, scene.cameras[0], 24);
        const Image picture = pipeline.picture(), expected = fresh.picture();
        double largest = 0, sum = 0;
        for (size_t i = 0; i < picture.data.size(); ++i) {
            const double difference = std::abs(double(picture.data[i]) - double(expected.data[i]));
            largest = std::max(largest, difference);
            sum += difference;
        }
        // Cells that were kept have less noise than fresh ones. A block that stays where it was is
        // 0.3 and more around it.
        EXPECT_LT(sum / static_cast<double>(picture.data.size()), 0.01) << footprint;
        EXPECT_LT(largest, 0.2) << footprint;
    }
}

TEST_F(MovingCells, TheSameBytesOnEveryRun) {
    const Scene scene = yard();
    const auto run = [&](Pipeline& pipeline) {
        for (int frame = 0; frame < 10; ++frame)
            render(pipeline, pose({-2 + 0.2 * frame, 0, 0.1 * frame}), scene.cameras[0], 1);
        return pipeline.picture().data;
    };
    Pipeline first(scene, ShaderLibrary()), second(scene, ShaderLibrary());
    const std::vector<float> picture = run(first);
    EXPECT_GT(count(first, "hash renewals"), 0u);
    EXPECT_EQ(run(second), picture);
    first.restart();
    EXPECT_EQ(run(first), picture);
}

TEST_F(MovingCells, SlowMovesAddUp) {
    settings_.set(kHashJitter, 0.0);
    const Scene scene = yard();
    const auto place = [](double x) { return pose({x, 0, -2}); };
    Pipeline pipeline(scene, ShaderLibrary());
    render(pipeline, place(-2), scene.cameras[0], 3);
    // A cell of the occupancy map is 8 / 63 m, a quarter of it 0.032.
    size_t renewed = 0;
    for (int frame = 1; frame <= 10; ++frame) {
        render(pipeline, place(-2 + 0.01 * frame), scene.cameras[0], 1);
        const bool expected = frame == 4 || frame == 8;
        EXPECT_EQ(count(pipeline, "hash renewals") > 0, expected) << frame;
        renewed += expected;
    }
    EXPECT_EQ(renewed, 2u);
}

TEST_F(MovingCells, AllAreForgottenWithAnUnboundedRadius) {
    settings_.set(kAoRadius, std::numeric_limits<double>::infinity());
    const Scene scene = yard();
    Pipeline pipeline(scene, ShaderLibrary());
    render(pipeline, pose({-2, 0, -2}), scene.cameras[0], 3);
    render(pipeline, pose({-1.5, 0, -2}), scene.cameras[0], 1);
    EXPECT_EQ(count(pipeline, "hash insertions"), count(pipeline, "hash cells"));
    EXPECT_EQ(count(pipeline, "hash renewals"), 0u);
    for (const StructureBytes& structure : pipeline.bytes())
        EXPECT_NE(structure.name, "hash changes");
}

TEST_F(MovingCells, WhatStandsStillCostsNoPass) {
    const Scene scene = yard();
    Pipeline pipeline(scene, ShaderLibrary());
    const auto passes = [&] {
        std::map<std::string, size_t> found;
        pipeline.timer().finish();
        for (const PassTiming& timing : pipeline.timer().timings())
            found[timing.pass] = timing.milliseconds.size();
        pipeline.timer().clear();
        return found;
    };
    render(pipeline, pose({-2, 0, -2}), scene.cameras[0], 5);
    auto found = passes();
    EXPECT_EQ(found["changes"] + found["hash renew"], 0u);
    render(pipeline, pose({-1.5, 0, -2}), scene.cameras[0], 40);
    found = passes();
    EXPECT_EQ(found["changes"], 1u);
    // From the change on until no cell is left that is older: at an age of 20 frames they go.
    EXPECT_EQ(found["hash renew"], 21u);
    settings_.set(kHashEvict, false);
    render(pipeline, pose({-2, 0, -2}), scene.cameras[0], 40);
    EXPECT_EQ(passes()["hash renew"], 40u);
}

TEST_F(MovingCells, AllAreForgottenWhereSomethingLeavesTheVolume) {
    const Scene scene = yard();
    Pipeline pipeline(scene, ShaderLibrary());
    render(pipeline, pose({-2, 0, -2}), scene.cameras[0], 3);
    render(pipeline, pose({-2, 6, -2}), scene.cameras[0], 1);
    EXPECT_EQ(count(pipeline, "hash insertions"), count(pipeline, "hash cells"));
    // The volume then holds it there and on the way back.
    render(pipeline, pose({-2, 5, -2}), scene.cameras[0], 1);
    EXPECT_LT(count(pipeline, "hash insertions"), count(pipeline, "hash cells") / 2);
    render(pipeline, pose({-2, 0, -2}), scene.cameras[0], 1);
    EXPECT_GT(count(pipeline, "hash renewals"), 100u);
    EXPECT_LT(count(pipeline, "hash insertions"), count(pipeline, "hash cells") / 2);
}

} // namespace
} // namespace romascope
