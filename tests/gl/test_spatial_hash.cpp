// SPDX-License-Identifier: MIT
// Ambient occlusion kept in the spatial hash, frame by frame.
#include "renderer/frame/jump.h"
#include "renderer/tracers/structure_view.h"
#include "tests/gl/gl_test.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace romascope {
namespace {

class SpatialHashTest : public GlTest {
protected:
    SpatialHashTest() {
        settings_.set(kWidth, 64);
        settings_.set(kHeight, 48);
        settings_.set(kOccupancyResolution, 64);
        settings_.set(kHashEnabled, true);
        settings_.set(kHashCapacity, 14);
    }

    /// A floor with blocks standing on it, seen from above at a slant.
    static Scene blocks() {
        std::vector<glm::vec3> corners = rectangle({0, 0, 0}, {0, 1, 0}, 4.0f);
        std::mt19937 random(7);
        std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
        for (int i = 0; i < 12; ++i) {
            const glm::vec3 place(3.0f * unit(random), 0.4f, 3.0f * unit(random));
            for (const glm::vec3 corner : rectangle(place, random_direction(random), 0.4f))
                corners.push_back(corner);
        }
        Scene scene = scene_of_triangles(corners);
        scene.cameras = {look_at("slant", {4, 3, 5}, {0, 0, 0}, 0.9f)};
        return scene;
    }

    static std::map<std::string, uint64_t> counts_of(const Pipeline& pipeline) {
        std::map<std::string, uint64_t> counts;
        for (const NamedCount& count : pipeline.counts())
            counts[count.name] = count.count;
        return counts;
    }

    static double mean_difference(const Image& a, const Image& b) {
        double sum = 0;
        for (size_t i = 0; i < a.data.size(); ++i)
            sum += std::abs(double(a.data[i]) - double(b.data[i]));
        return sum / static_cast<double>(a.data.size());
    }

    Image render(Pipeline& pipeline, const Camera& camera, int frames) {
        for (int i = 0; i < frames; ++i)
            pipeline.render(settings_, camera);
        return pipeline.picture();
    }

    Settings settings_{all_knobs()};
};

TEST_F(SpatialHashTest, TheSameBytesOnEveryRun) {
    const Scene scene = blocks();
    for (const HashProbing probing :
         {HashProbing::linear, HashProbing::rehash, HashProbing::bucket}) {
        settings_.set(kHashProbing, probing);
        Pipeline first(scene, ShaderLibrary());
        const Image picture = render(first, scene.cameras[0], 6);
        EXPECT_EQ(counts_of(first)["hash failed pixels"], 0u);
        Pipeline second(scene, ShaderLibrary());
        EXPECT_EQ(render(second, scene.cameras[0], 6).data, picture.data);
        first.restart();
        EXPECT_EQ(render(first, scene.cameras[0], 6).data, picture.data)
            << "what was there is forgotten";
    }
}

TEST_F(SpatialHashTest, AnOpenPlaneIsExactlyOne) {
    const Scene scene = scene_of_triangles(rectangle({0, 0, 0}, {0, 1, 0}, 3.0f));
    leave_all_own_cells(settings_);
    for (const int capacity : {10, 16}) {
        settings_.set(kHashCapacity, capacity);
        settings_.set(kHashFootprint, 0.5);
        Pipeline pipeline(scene, ShaderLibrary());
        for (const float value : render(pipeline, scene.cameras[0], 5).data)
            ASSERT_EQ(value, 1.0f);
    }
}

TEST_F(SpatialHashTest, FindsWhatPlainTracingFinds) {
    const Scene scene = blocks();
    settings_.set(kHashFootprint, 2.0);
    settings_.set(kHashSmallest, 0.02);
    Pipeline pipeline(scene, ShaderLibrary());
    const Image cached = render(pipeline, scene.cameras[0], 32);
    settings_.set(kHashEnabled, false);
    Pipeline plain_pipeline(scene, ShaderLibrary());
    const Image plain = render(plain_pipeline, scene.cameras[0], 32);
    // Cells of two pixels smooth over edges; noise of 128 rays is about 0.01 on average.
    EXPECT_LT(mean_difference(cached, plain), 0.03);
    double bias = 0;
    for (size_t i = 0; i < plain.data.size(); ++i)
        bias += double(cached.data[i]) - double(plain.data[i]);
    EXPECT_NEAR(bias / static_cast<double>(plain.data.size()), 0.0, 0.004);
}

TEST_F(SpatialHashTest, OneFrameAfterManyIsAlreadyGood) {
    // A camera that moves starts the mean anew, the cells stay.
    const Scene scene = blocks();
    settings_.set(kHashJitter, 0.0);
    const auto camera_at = [](int frame) {
        return look_at("fly", {4, 3, 5 - 0.02f * static_cast<float>(frame)}, {0, 0, 0}, 0.9f);
    };
    Pipeline pipeline(scene, ShaderLibrary());
    for (int frame = 0; frame < 40; ++frame)
        pipeline.render(settings_, camera_at(frame));
    ASSERT_EQ(pipeline.frame_count(), 1u);
    const Image moved = pipeline.picture();
    const auto counts = counts_of(pipeline);
    EXPECT_GT(counts.at("hash rays saved"), counts.at("hash rays traced"));
    EXPECT_EQ(counts.at("hash failed pixels"), 0u);

    settings_.set(kHashEnabled, false);
    Pipeline plain(scene, ShaderLibrary());
    const Image one = render(plain, camera_at(39), 1);
    const Image truth = render(plain, camera_at(39), 64);
    EXPECT_LT(mean_difference(moved, truth), 0.5 * mean_difference(one, truth));
}

TEST_F(SpatialHashTest, CellsThatHaveEnoughTakeNoMore) {
    const Scene scene = blocks();
    settings_.set(kHashJitter, 0.0);
    settings_.set(kHashSampleCap, 40);
    Pipeline pipeline(scene, ShaderLibrary());
    render(pipeline, scene.cameras[0], 1);
    EXPECT_EQ(counts_of(pipeline)["hash rays saved"], 0u);
    // Each frame brings a cell at least one pixel's 4 rays.
    render(pipeline, scene.cameras[0], 10);
    const auto before = pipeline.spatial_hash().table().download();
    render(pipeline, scene.cameras[0], 1);
    EXPECT_EQ(counts_of(pipeline)["hash rays traced"], 0u);
    EXPECT_EQ(counts_of(pipeline)["hash insertions"], 0u);
    const auto after = pipeline.spatial_hash().table().download();
    for (size_t i = 0; i < before.size(); ++i) {
        ASSERT_EQ(gpu::cell_samples(before[i]), gpu::cell_samples(after[i]));
        ASSERT_EQ(gpu::cell_hits(before[i]), gpu::cell_hits(after[i]));
        ASSERT_TRUE(before[i].checksum == 0 || gpu::cell_samples(before[i]) >= 40);
    }
    // Without the stop it goes on, and the sums stay within their bits.
    settings_.set(kHashStop, false);
    render(pipeline, scene.cameras[0], 1);
    EXPECT_EQ(counts_of(pipeline)["hash rays saved"], 0u);
}

TEST_F(SpatialHashTest, AFullTableFallsBackOnOwnRays) {
    const Scene scene = blocks();
    settings_.set(kWidth, 160);
    settings_.set(kHeight, 120);
    settings_.set(kHashCapacity, 10);
    settings_.set(kHashFootprint, 0.5);
    settings_.set(kHashSmallest, 0.001);
    for (const HashProbing probing :
         {HashProbing::linear, HashProbing::rehash, HashProbing::bucket}) {
        settings_.set(kHashProbing, probing);
        settings_.set(kHashEnabled, true);
        Pipeline pipeline(scene, ShaderLibrary());
        const Image cached = render(pipeline, scene.cameras[0], 1);
        const auto counts = counts_of(pipeline);
        EXPECT_GT(counts.at("hash failed pixels"), 5000u);
        EXPECT_GT(counts.at("hash cells"), 1000u) << "nearly full";
        EXPECT_LE(counts.at("hash cells"), 1024u);
        EXPECT_LE(counts.at("hash longest probe"), 10u);
        settings_.set(kHashEnabled, false);
        Pipeline plain_pipeline(scene, ShaderLibrary());
        const Image plain = render(plain_pipeline, scene.cameras[0], 1);
        // What a pixel's own rays found shows in it: in its cells, or by itself.
        size_t different = 0;
        for (size_t i = 0; i < plain.data.size(); ++i) {
            if (plain.data[i] < 1.0f) {
                ASSERT_LT(cached.data[i], 1.0f) << i;
            }
            if (plain.data[i] > 0.0f) {
                ASSERT_GT(cached.data[i], 0.0f) << i;
            }
            different += cached.data[i] != plain.data[i];
        }
        EXPECT_LT(different, plain.data.size() - counts.at("hash failed pixels"));
        EXPECT_LT(mean_difference(cached, plain), 0.1);
    }
}

TEST_F(SpatialHashTest, NoPixelIsBlackOnAFlight) {
    // A pixel whose own rays found an opening is never closed: either its cells took those rays, or
    // it shows them.
    const Scene scene = blocks();
    settings_.set(kHashFootprint, 1.0);
    settings_.set(kHashSmallest, 0.01);
    settings_.set(kHashSampleCap, 32768);
    settings_.set(kView, PictureKind::ambient_occlusion_raw);
    Settings plain_settings = settings_;
    plain_settings.set(kHashEnabled, false);
    for (const int capacity : {10, 16}) {
        settings_.set(kHashCapacity, capacity);
        Pipeline pipeline(scene, ShaderLibrary()), plain_pipeline(scene, ShaderLibrary());
        uint64_t failed = 0;
        for (int frame = 0; frame < 24; ++frame) {
            const float turn = 0.1f * static_cast<float>(frame);
            const Camera camera =
                look_at("flight", {4 * std::cos(turn), 1 + 0.03f * static_cast<float>(frame), 3.0f},
                        {std::sin(turn), 0, 0}, 0.9f);
            pipeline.render(settings_, camera);
            plain_pipeline.render(plain_settings, camera);
            failed += counts_of(pipeline)["hash failed pixels"];
            const Image cached = pipeline.picture(), plain = plain_pipeline.picture();
            for (size_t i = 0; i < plain.data.size(); ++i)
                if (plain.data[i] > 0.0f) {
                    ASSERT_GT(cached.data[i], 0.0f) << "pixel " << i << " of frame " << frame;
                }
        }
        EXPECT_EQ(failed > 0, capacity == 10);
    }
}

TEST_F(SpatialHashTest, WhatChangesTheMeaningOfCellsStartsAnew) {
    const Scene scene = blocks();
    Pipeline pipeline(scene, ShaderLibrary());
    render(pipeline, scene.cameras[0], 3);
    const auto is_fresh = [&] {
        render(pipeline, scene.cameras[0], 1);
        const auto counts = counts_of(pipeline);
        return counts.at("hash insertions") == counts.at("hash cells");
    };
    EXPECT_FALSE(is_fresh());
    settings_.set(kHashFootprint, 6.0);
    EXPECT_FALSE(is_fresh()) << "chooses among cells";
    settings_.set(kSunStrength, 3.0);
    settings_.set(kAoRays, 2);
    EXPECT_FALSE(is_fresh());
    settings_.set(kAoRadius, 1.0);
    EXPECT_TRUE(is_fresh());
    settings_.set(kHashNormalBins, 5.0);
    EXPECT_TRUE(is_fresh());
    settings_.set(kHashSmallest, 0.1);
    EXPECT_TRUE(is_fresh());
    settings_.set(kHashJitter, 0.25);
    EXPECT_TRUE(is_fresh()) << "cells hold samples from farther away than they take now";
    settings_.set(kRomaNormalOffset, 2.0);
    EXPECT_TRUE(is_fresh());
    settings_.set(kTracer, "dda");
    EXPECT_TRUE(is_fresh());
    settings_.set(kHashCapacity, 15);
    EXPECT_TRUE(is_fresh());
    EXPECT_FALSE(is_fresh());
}

TEST_F(SpatialHashTest, WhatOnlyShowsSomethingElseKeepsTheCells) {
    const Scene scene = blocks();
    Pipeline pipeline(scene, ShaderLibrary());
    render(pipeline, scene.cameras[0], 3);
    settings_.set(kView, PictureKind::structure);
    int knobs = 0;
    for (const KnobBase* knob : all_knobs().all()) {
        if (!chooses_view(*knob) || knob == &kView || knob == &kViewStructure)
            continue;
        if (knob->choices().empty())
            settings_.set_text(knob->key(), "1");
        else
            settings_.set_value(*knob, std::string(knob->choices().back()));
        ASSERT_FALSE(settings_.is_default(*knob) && knob != &kDepthRange) << knob->key();
        render(pipeline, scene.cameras[0], 1);
        const auto counts = counts_of(pipeline);
        EXPECT_LT(counts.at("hash insertions"), counts.at("hash cells")) << knob->key();
        ++knobs;
    }
    EXPECT_GE(knobs, 10);
    settings_.set(kViewStructure, "map_slice");
    for (const std::string_view view : kView.choices()) {
        settings_.set_text(kView.key(), view);
        render(pipeline, scene.cameras[0], 1);
        const auto counts = counts_of(pipeline);
        EXPECT_LT(counts.at("hash insertions"), counts.at("hash cells")) << view;
    }
}

TEST_F(SpatialHashTest, AnimatedCamerasKeepTheCells) {
    Scene scene = blocks();
    scene.motion.nodes.resize(1);
    scene.motion.cameras = {{0, 0}};
    Pipeline pipeline(scene, ShaderLibrary());
    for (int frame = 0; frame < 4; ++frame) {
        Pose pose{{glm::dmat4(1.0)}, {}};
        pose.node_to_world[0][3].x = 0.001 * frame;
        pipeline.set_pose(pose);
        pipeline.render(settings_, camera_at(scene, 0, pose));
    }
    EXPECT_LT(counts_of(pipeline)["hash insertions"], counts_of(pipeline)["hash cells"] / 2);
}

TEST_F(SpatialHashTest, CellsOutOfSightAreFreedInTime) {
    const Scene scene = blocks();
    settings_.set(kHashEvictionAge, 4);
    settings_.set(kHashJitter, 0.0); // so that each is used in every frame that sees it
    const Camera away = look_at("sky", {0, 5, 0}, {0, 9, 1}, 0.9f);
    // The count of frames wraps on the way.
    for (const uint32_t first : {0u, (1u << 24) - 4u, 0xFFFFFFFCu}) {
        Pipeline pipeline(scene, ShaderLibrary());
        pipeline.restart(first);
        render(pipeline, scene.cameras[0], 2);
        const uint64_t cells = counts_of(pipeline)["hash cells"];
        ASSERT_GT(cells, 100u);
        render(pipeline, away, 4);
        EXPECT_EQ(counts_of(pipeline)["hash evictions"], 0u);
        EXPECT_EQ(counts_of(pipeline)["hash cells"], cells);
        render(pipeline, away, 1);
        EXPECT_EQ(counts_of(pipeline)["hash evictions"], cells);
        EXPECT_EQ(counts_of(pipeline)["hash cells"], 0u);
        for (const gpu::Cell& cell : pipeline.spatial_hash().table().download())
            ASSERT_TRUE(cell.checksum == 0 && cell.hits == 0 && cell.samples == 0);
    }
    settings_.set(kHashEvict, false);
    Pipeline pipeline(scene, ShaderLibrary());
    render(pipeline, scene.cameras[0], 2);
    const uint64_t cells = counts_of(pipeline)["hash cells"];
    render(pipeline, away, 8);
    EXPECT_EQ(counts_of(pipeline)["hash cells"], cells);
}

TEST_F(SpatialHashTest, CountsAddUp) {
    const Scene scene = blocks();
    settings_.set(kAoRays, 3);
    Pipeline pipeline(scene, ShaderLibrary());
    uint64_t cells = 0, evictions = 0;
    for (int frame = 0; frame < 30; ++frame) {
        const float turn = 0.1f * static_cast<float>(frame);
        pipeline.render(settings_, look_at("round", {5 * std::cos(turn), 3, 5 * std::sin(turn)},
                                           {0, 0, 0}, 0.9f));
        const auto counts = counts_of(pipeline);
        cells += counts.at("hash insertions") - counts.at("hash evictions");
        evictions += counts.at("hash evictions");
        ASSERT_EQ(counts.at("hash cells"), cells);
        uint64_t by_samples = 0, by_age = 0;
        for (const auto& [name, count] : counts) {
            by_samples += name.starts_with("hash samples") ? count : 0;
            by_age += name.starts_with("hash age") ? count : 0;
        }
        ASSERT_EQ(by_samples, cells);
        ASSERT_EQ(by_age, cells);
        ASSERT_EQ((counts.at("hash rays traced") + counts.at("hash rays saved")) % 3, 0u);
        ASSERT_LE(counts.at("hash rays traced") + counts.at("hash rays saved"), 64u * 48u * 3u);
    }
    EXPECT_GT(evictions, 0u);
}

TEST_F(SpatialHashTest, TwelveBytesACell) {
    const Scene scene = blocks();
    Pipeline pipeline(scene, ShaderLibrary());
    render(pipeline, scene.cameras[0], 1);
    const auto bytes = [&] {
        size_t found = 0;
        for (const StructureBytes& structure : pipeline.bytes())
            found += structure.name == "hash table" ? structure.bytes : 0;
        return found;
    };
    EXPECT_EQ(bytes(), 12u << 14);
    EXPECT_LE(bytes() + 64 * 48 * 12, SpatialHash::bytes_needed(settings_, 64 * 48));
    settings_.set(kHashEnabled, false);
    render(pipeline, scene.cameras[0], 1);
    EXPECT_EQ(bytes(), 0u);
    EXPECT_EQ(SpatialHash::bytes_needed(settings_, 64 * 48), 0u);
}

TEST_F(SpatialHashTest, ViewsShowTheCells) {
    const Scene scene = blocks();
    settings_.set(kHashEnabled, false); // looking is enough
    settings_.set(kView, PictureKind::hash);
    settings_.set(kHashSampleCap, 100);
    Pipeline pipeline(scene, ShaderLibrary());
    render(pipeline, scene.cameras[0], 40);
    const Image colors = pipeline.picture();
    ASSERT_EQ(colors.channels, 3);
    std::set<std::array<float, 3>> distinct;
    for (size_t i = 0; i < colors.data.size(); i += 3)
        distinct.insert({colors.data[i], colors.data[i + 1], colors.data[i + 2]});
    const auto counts = counts_of(pipeline);
    EXPECT_GT(distinct.size(), 50u);
    // Where a pixel's own place has no cell, that of its lookup is shown.
    for (size_t i = 0; i < colors.data.size(); i += 3)
        ASSERT_FALSE(colors.data[i] == 0.25f && colors.data[i + 1] == 0.0f) << "no cell";
    EXPECT_LE(distinct.size(), counts.at("hash cells") + 2);
    settings_.set(kHashView, HashView::failed);
    const Image none = render(pipeline, scene.cameras[0], 1);
    for (size_t i = 0; i < none.data.size(); i += 3)
        ASSERT_EQ(none.data[i], none.data[i + 1]) << "grey: none failed";
    settings_.set(kHashView, HashView::samples);
    const Image samples = render(pipeline, scene.cameras[0], 1);
    size_t full = 0;
    for (size_t i = 0; i < samples.data.size(); i += 3)
        full += samples.data[i] == 1.0f;
    EXPECT_GT(full, 1500u) << "yellow where cells have enough";
    settings_.set(kHashView, HashView::age);
    const Image ages = render(pipeline, scene.cameras[0], 1);
    EXPECT_NE(ages.data, samples.data);
}

} // namespace
} // namespace romascope
