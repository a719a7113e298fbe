// SPDX-License-Identifier: MIT
// What a small glTF file may ask for: bounds of memory and of work.
#include "tests/support/gltf_files.h"

#include <cstdint>

namespace romascope {
namespace {

TEST(GltfMemory, a_scene_over_the_bound_is_refused_before_it_is_built) {
    TriangleFile file;
    const json primitive = file.primitive(); // of 10,000: the JSON is small, the scene is not
    file.root["meshes"][0]["primitives"] = json::array();
    for (int i = 0; i < 100; ++i)
        file.root["meshes"][0]["primitives"].push_back(primitive);
    for (int i = 1; i < 1000; ++i)
        file.add("nodes", {{"mesh", 0}});
    EXPECT_EQ(load(file).triangle_count(), 100000u);
    const std::string text = refusal(file, 8 << 20);
    EXPECT_CONTAINS(text, "asset.glb: scene: needs");
    EXPECT_CONTAINS(text, "--max-memory");
    EXPECT_CONTAINS(refusal(file, 100), "the limit is 100 B");
}

TEST(GltfMemory, instances_and_shared_keys_cannot_multiply_without_bound) {
    GltfBuilder file;
    file.add_mesh({{"POSITION", file.add_accessor(std::vector<float>(300000, 1.0f), "VEC3")}});
    json mesh = file.root["meshes"][0];
    for (int i = 1; i < 100; ++i)
        mesh["primitives"].push_back(mesh["primitives"][0]);
    file.root["meshes"][0] = mesh;
    for (int i = 0; i < 1000; ++i)
        file.add("nodes", {{"mesh", 0}});
    EXPECT_CONTAINS(refusal(file, SIZE_MAX), "the scene has more than 50000000 triangles");

    TriangleFile keys;
    std::vector<float> times(100000), values(300000, 1.0f);
    for (size_t i = 0; i < times.size(); ++i)
        times[i] = static_cast<float>(i);
    for (int i = 0; i < 500; ++i)
        keys.add("nodes", {{"name", "n"}});
    keys.animate(0, "scale", times, values, "VEC3");
    for (int i = 1; i < 500; ++i)
        keys.root["animations"][0]["channels"].push_back(
            {{"sampler", 0}, {"target", {{"node", i}, {"path", "scale"}}}});
    EXPECT_CONTAINS(refusal(keys, SIZE_MAX), "the animations hold more than");
}

TEST(GltfMemory, positions_without_data_are_one_point) {
    GltfBuilder file;
    file.add("accessors", {{"componentType", 5126}, {"count", 3'000'000'000u}, {"type", "VEC3"}});
    file.add_mesh({{"POSITION", 0}});
    file.add("nodes", {{"mesh", 0}, {"translation", {1, 2, 3}}});
    const Scene scene = load(file, 1 << 20);
    EXPECT_EQ(scene.triangle_count(), 1u);
    EXPECT_EQ(scene.positions[0], glm::vec3(1, 2, 3));
}

TEST(GltfMemory, products_of_what_a_small_file_lists_are_bounded) {
    TriangleFile targets;
    targets.primitive()["targets"] = json(std::vector<json>(20000, json::object()));
    for (int i = 0; i < 20000; ++i)
        targets.add("nodes", {{"mesh", 0}});
    EXPECT_CONTAINS(refusal(targets), "needs");
    EXPECT_CONTAINS(refusal(targets, SIZE_MAX), "morph targets in all");

    TriangleFile names; // quadratic work would take minutes
    names.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}});
    for (int i = 0; i < 40000; ++i)
        names.add("nodes", {{"camera", 0}});
    EXPECT_EQ(load(names, size_t{1} << 30).cameras.back().name, "camera_40000");

    TriangleFile primitives;
    for (int i = 0; i < 20000; ++i) {
        primitives.root["meshes"][0]["primitives"].push_back({{"attributes", json::object()}});
        primitives.add("nodes", {{"mesh", 0}});
    }
    EXPECT_EQ(load(primitives, size_t{1} << 30).triangle_count(), 20001u);
}

} // namespace
} // namespace romascope
