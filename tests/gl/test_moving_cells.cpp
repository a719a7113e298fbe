// SPDX-License-Identifier: MIT
// When cells of the spatial hash are emptied where something moves, and what pictures then have.
#include "renderer/base/files.h"
#include "renderer/tracers/structure_view.h"
#include "tests/gl/moving_cells.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <tuple>

namespace romascope {
namespace {

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
