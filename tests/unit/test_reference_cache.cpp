// SPDX-License-Identifier: MIT
// What the reference keeps from run to run.
#include "tests/support/reference_fixture.h"

#include <fstream>
#include <functional>

namespace romascope {
namespace {

TEST_F(Reference, cache_returns_the_same_bytes) {
    const DiscView view;
    const AoReference first = ambient_occlusion_reference(view.scene, view.query);
    EXPECT_FALSE(first.from_cache);
    ASSERT_EQ(cache_files().size(), 1u);
    const AoReference second = ambient_occlusion_reference(view.scene, view.query);
    EXPECT_TRUE(second.from_cache);
    EXPECT_EQ(first.visibility.data, second.visibility.data);
    EXPECT_EQ(first.standard_error.data, second.standard_error.data);
    EXPECT_EQ(first.seconds, second.seconds);
    const AoReference fresh =
        ambient_occlusion_reference(view.scene, view.query, {}, {.use_cache = false});
    EXPECT_FALSE(fresh.from_cache);
    EXPECT_EQ(first.visibility.data, fresh.visibility.data);
}

TEST_F(Reference, anything_that_matters_misses_the_cache) {
    const DiscView view;
    ambient_occlusion_reference(view.scene, view.query);
    const auto hits = [&](const std::function<void(DiscView&)>& change) {
        DiscView changed = view;
        change(changed);
        return ambient_occlusion_reference(changed.scene, changed.query).from_cache;
    };
    EXPECT_TRUE(hits([](DiscView&) {}));
    EXPECT_TRUE(hits([](DiscView& v) { v.query.camera.name = "other"; }));
    EXPECT_TRUE(hits([](DiscView& v) { v.scene.name = "other"; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.scene.positions[5].x += 1e-3f; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.scene.normals[0] = {0.6f, 0.8f, 0.0f}; }));
    EXPECT_FALSE(hits([](DiscView& v) { std::swap(v.scene.indices[0], v.scene.indices[1]); }));
    EXPECT_TRUE(hits([](DiscView& v) { v.scene.materials[0].base_color = glm::vec3(0.2f); }));
    EXPECT_FALSE(hits([](DiscView& v) { v.scene.materials[0].double_sided = false; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.scene.materials[0].alpha_cutoff = 0.5f; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.query.camera.eye.x += 1e-4f; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.query.camera.up = -v.query.camera.up; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.query.camera.vertical_fov += 1e-4f; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.query.size = {23, 37}; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.query.samples += 1; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.query.radius = 7.0f; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.query.seed += 1; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.query.pixel_jitter = true; }));
}

TEST_F(Reference, damaged_cache_files_are_computed_anew) {
    const DiscView view;
    const AoReference good = ambient_occlusion_reference(view.scene, view.query);
    const fs::path file = cache_files().at(0);
    const auto size = fs::file_size(file);
    const std::vector<std::function<void()>> damages = {
        [&] { fs::resize_file(file, size - 1); },
        [&] { fs::resize_file(file, size + 4); },
        [&] { fs::resize_file(file, 0); },
        [&] { std::ofstream(file) << "not a result"; },
        [&] {
            fs::remove(file);
            fs::create_directory(file);
        },
        [&] {
            std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
            stream.seekp(static_cast<std::streamoff>(size / 2));
            stream.put('\x77');
        },
        [&] {
            std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
            stream.seekp(0);
            stream.put('X');
        }};
    for (size_t i = 0; i < damages.size(); ++i) {
        damages[i]();
        const AoReference again = ambient_occlusion_reference(view.scene, view.query);
        EXPECT_FALSE(again.from_cache) << "damage " << i;
        EXPECT_EQ(again.visibility.data, good.visibility.data);
        if (fs::is_directory(file))
            fs::remove(file);
        ambient_occlusion_reference(view.scene, view.query);
        EXPECT_TRUE(ambient_occlusion_reference(view.scene, view.query).from_cache);
    }
}

TEST_F(Reference, works_without_a_writable_cache) {
    std::ofstream(folder_ / "file") << "in the way";
    setenv("XDG_CACHE_HOME", (folder_ / "file" / "below").c_str(), 1);
    const DiscView view;
    EXPECT_FALSE(ambient_occlusion_reference(view.scene, view.query).from_cache);
    EXPECT_FALSE(ambient_occlusion_reference(view.scene, view.query).from_cache);
}

} // namespace
} // namespace romascope
