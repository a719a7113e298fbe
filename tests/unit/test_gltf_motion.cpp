// SPDX-License-Identifier: MIT
// What of a glTF file moves: animations, skins, morph targets.
#include "tests/support/gltf_files.h"

#include <cmath>
#include <limits>

namespace romascope {
namespace {

/// A triangle whose three vertices follow joints 0 and 1 of a skin.
struct SkinnedFile : TriangleFile {
    std::vector<uint8_t> joints = {0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0};
    std::vector<float> weights = {0.5f, 0.5f, 0, 0, 0.25f, 0.75f, 0, 0, 1, 0, 0, 0};
    std::vector<float> bind;

    SkinnedFile() {
        for (int joint = 0; joint < 2; ++joint)
            for (int i = 0; i < 16; ++i)
                bind.push_back(i % 5 == 0 ? 1.0f : i == 13 && joint == 1 ? -1.0f : 0.0f);
    }
    SkinnedFile& finish() {
        primitive()["attributes"]["JOINTS_0"] = add_accessor(joints, "VEC4");
        primitive()["attributes"]["WEIGHTS_0"] = add_accessor(weights, "VEC4");
        node()["skin"] = 0;
        node()["translation"] = {100, 0, 0}; // which a skin ignores
        add("nodes", {{"children", {2}}, {"translation", {5, 0, 0}}});
        add("nodes", {{"translation", {0, 1, 0}}});
        add("skins", {{"joints", {1, 2}}, {"inverseBindMatrices", add_accessor(bind, "MAT4")}});
        return *this;
    }
};

TEST(GltfMotion, a_still_scene_has_none) {
    const Scene scene = load(TriangleFile());
    EXPECT_TRUE(scene.motion.empty());
    EXPECT_TRUE(scene.motion.nodes.empty());
}

TEST(GltfMotion, nodes_below_an_animated_one_move_and_others_are_written_out) {
    TriangleFile file; // node 0 stands still
    file.add("nodes", {{"children", {2, 3}}, {"translation", {50, 0, 0}}});
    file.add("nodes", {{"mesh", 0}, {"translation", {0, 0, 1}}});
    file.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}});
    file.add("nodes", {{"camera", 0}, {"translation", {0, 0, 4}}});
    file.animate(1, "translation", {0.5f, 1.5f}, {10, 0, 0, 20, 0, 0}, "VEC3");
    const Scene scene = load(file);
    const Motion& motion = scene.motion;
    ASSERT_EQ(motion.parts.size(), 1u);
    EXPECT_EQ(motion.first_vertex, 3u);
    EXPECT_EQ(motion.parts[0].first_vertex, 3u);
    EXPECT_EQ(motion.parts[0].vertex_count, 3u);
    EXPECT_EQ(motion.parts[0].skin, -1);
    EXPECT_EQ(motion.matrix_count, 1u);
    EXPECT_EQ(motion.rest_positions[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(scene.positions[0], glm::vec3(0, 0, 0));
    EXPECT_TRUE(near(scene.positions[3], {10, 0, 1})); // as at second 0
    EXPECT_TRUE(near(scene.camera("camera").eye, {10, 0, 4}));
    EXPECT_TRUE(near(scene.normals[4], {0, 0, 1}));
    EXPECT_GE(scene.bounds.max.x, 11.0f);
    EXPECT_EQ(motion.still.max, glm::vec3(1, 1, 0));
    ASSERT_EQ(motion.animations.size(), 1u);
    EXPECT_EQ(motion.animations[0].name, "animation_0");
    EXPECT_DOUBLE_EQ(motion.animations[0].duration, 1.5);
    ASSERT_EQ(motion.animations[0].channels.size(), 1u);
    EXPECT_EQ(motion.animations[0].channels[0].times, (std::vector<float>{0.5f, 1.5f}));
}

TEST(GltfMotion, skins_follow_their_joints_alone) {
    SkinnedFile file;
    const Scene scene = load(file.finish());
    const Motion& motion = scene.motion;
    ASSERT_EQ(motion.parts.size(), 1u);
    EXPECT_EQ(motion.parts[0].influence_sets, 1u);
    EXPECT_EQ(motion.matrix_count, 2u);
    ASSERT_EQ(motion.influences.size(), 3u);
    EXPECT_EQ(motion.influences[1].joint[1], 1);
    EXPECT_FLOAT_EQ(motion.influences[1].weight[1], 0.75f);
    // Joint 1 stands at (5, 1, 0), bound at (0, 1, 0): both matrices move by (5, 0, 0).
    EXPECT_TRUE(near(scene.positions[1], {6, 0, 0}));
    EXPECT_TRUE(near(scene.positions[2], {5, 1, 0}));
}

TEST(GltfMotion, weights_are_made_to_add_up) {
    SkinnedFile file;
    file.weights = {1, 1, 0, 0, 0, 0, 0, 0, 0.25f, 0.25f, 0, 0};
    const Scene scene = load(file.finish());
    EXPECT_FLOAT_EQ(scene.motion.influences[0].weight[0], 0.5f);
    EXPECT_FLOAT_EQ(scene.motion.influences[1].weight[0], 1.0f);
    EXPECT_FLOAT_EQ(scene.motion.influences[2].weight[1], 0.5f);
    EXPECT_TRUE(has_notice(scene, "vertices without weights"));
}

TEST(GltfMotion, broken_skins_are_refused) {
    SkinnedFile joint;
    joint.joints[9] = 2;
    EXPECT_CONTAINS(refusal(joint.finish()), "JOINTS_0: element 2 names joint 2, there are 2");
    SkinnedFile negative;
    negative.weights[0] = -0.5f;
    EXPECT_CONTAINS(refusal(negative.finish()), "WEIGHTS_0: element 0");
    SkinnedFile infinite;
    infinite.bind[3] = std::numeric_limits<float>::infinity();
    EXPECT_CONTAINS(refusal(infinite.finish()), "skins[0].inverseBindMatrices");
    SkinnedFile few;
    few.bind.resize(16);
    EXPECT_CONTAINS(refusal(few.finish()), "1 matrices for 2 joints");
    SkinnedFile half;
    half.finish().primitive()["attributes"].erase("WEIGHTS_0");
    EXPECT_CONTAINS(refusal(half), "only one of JOINTS_0 and WEIGHTS_0");
}

TEST(GltfMotion, morph_targets) {
    TriangleFile file;
    const std::vector<float> lift = {0, 0, 1, 0, 0, 2, 0, 0, 3};
    const std::vector<float> bend = {1, 0, 0, 0, 0, 0, 0, 0, 0};
    file.primitive()["targets"] = {{{"POSITION", file.add_accessor(lift, "VEC3")}},
                                   {{"POSITION", file.add_accessor(bend, "VEC3")},
                                    {"NORMAL", file.add_accessor(bend, "VEC3")}}};
    EXPECT_TRUE(load(file).motion.empty()); // nothing weighs them
    file.root["meshes"][0]["weights"] = {0.5, 2.0};
    const Scene scene = load(file);
    ASSERT_EQ(scene.motion.parts.size(), 1u);
    EXPECT_EQ(scene.motion.parts[0].target_count, 2u);
    EXPECT_EQ(scene.motion.deltas[2].position, glm::vec3(0, 0, 3));
    EXPECT_EQ(scene.motion.deltas[3].normal, glm::vec3(1, 0, 0));
    EXPECT_TRUE(near(scene.positions[0], {2, 0, 0.5f}));
    EXPECT_TRUE(near(scene.positions[2], {0, 1, 1.5f}));
    EXPECT_TRUE(near(scene.normals[0], glm::normalize(glm::vec3(2, 0, 1))));

    file.node()["weights"] = {0.0, 1.0}; // a node's own go before its mesh's
    EXPECT_TRUE(near(load(file).positions[0], {1, 0, 0}));
    file.animate(0, "weights", {0, 1}, {1, 0, 0, 0}, "SCALAR");
    EXPECT_TRUE(near(load(file).positions[2], {0, 1, 3}));
}

TEST(GltfMotion, moving_vertices_without_normals_use_their_triangles) {
    TriangleFile file;
    file.primitive()["attributes"].erase("NORMAL");
    file.animate(0, "rotation", {0}, {0, 0, 0, 1}, "VEC4");
    const Scene scene = load(file);
    EXPECT_EQ(scene.normals[0], glm::vec3(0.0f));
}

TEST(GltfMotion, broken_animations_are_refused) {
    const auto with = [](const std::vector<float>& times, const std::vector<float>& values,
                         const char* path = "translation", const char* type = "VEC3",
                         const char* interpolation = "LINEAR") {
        TriangleFile file;
        file.animate(0, path, times, values, type, interpolation);
        return refusal(file);
    };
    const float nan = std::nanf("");
    EXPECT_CONTAINS(with({0, 1, 1}, std::vector<float>(9, 1.0f)),
                    "animations[0].samplers[0].input: key 2 is not after");
    EXPECT_CONTAINS(with({0, nan}, std::vector<float>(6, 1.0f)), "samplers[0].input");
    EXPECT_CONTAINS(with({-1, 0}, std::vector<float>(6, 1.0f)), "before second 0");
    EXPECT_CONTAINS(with({0, 1}, {0, 0, 0, 0, 0, nan}), "samplers[0].output");
    EXPECT_CONTAINS(with({0, 1}, std::vector<float>(9, 1.0f)), "has 3 elements, its keys need 2");
    EXPECT_CONTAINS(with({0, 1}, std::vector<float>(6, 1.0f), "translation", "VEC3", "CUBICSPLINE"),
                    "its keys need 6");
    EXPECT_CONTAINS(with({0, 1}, {0, 0, 0, 1, 0, 0, 0, 0}, "rotation", "VEC4"),
                    "rotation of key 1 has no length");
    EXPECT_CONTAINS(with({0, 1}, {1, 1, 1, 1e9f, 1e9f, 1e9f}, "scale"), "was taken");
    EXPECT_CONTAINS(with({0, 1}, {1, 1, 1, 2e9f, 1, 1}, "scale"), "is beyond");

    TriangleFile twice;
    for (int i = 0; i < 2; ++i)
        twice.animate(0, "scale", {0}, {1, 1, 1}, "VEC3");
    EXPECT_CONTAINS(refusal(twice), "animations[0].channels[1]: a channel before it");

    // Each node alone is sane, all together would leave what a float can hold.
    TriangleFile chain;
    for (int i = 1; i < 8; ++i) {
        chain.root["nodes"][i - 1]["children"] = {i};
        chain.add("nodes", {{"mesh", 0}});
        chain.animate(i, "scale", {0, 1}, {1, 1, 1, 1e8f, 1e8f, 1e8f}, "VEC3");
    }
    EXPECT_CONTAINS(refusal(chain), "animations: may move something further");
}

TEST(GltfMotion, channels_that_move_nothing_known_are_left_out) {
    TriangleFile file;
    file.node()["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 9, 0, 0, 1};
    file.animate(0, "translation", {0, 1}, {0, 0, 0, 5, 0, 0}, "VEC3");
    const Scene scene = load(file);
    EXPECT_EQ(scene.positions[0], glm::vec3(9, 0, 0));
    EXPECT_TRUE(has_notice(scene, "has a matrix"));
    TriangleFile weights;
    weights.animate(0, "weights", {0}, {1}, "SCALAR");
    EXPECT_TRUE(has_notice(load(weights), "morph targets that are not there"));
}

/// Smallest dot product of a triangle's own normal and its vertices'.
float least_agreement(const Scene& scene) {
    float least = 1.0f;
    for (size_t i = 0; i < scene.indices.size(); i += 3) {
        const auto at = [&](size_t k) { return scene.positions[scene.indices[i + k]]; };
        const glm::vec3 own = glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0)));
        for (size_t k = 0; k < 3; ++k)
            least = std::min(least, glm::dot(own, scene.normals[scene.indices[i + k]]));
    }
    return least;
}

TEST(GltfMotion, mirrored_parts_keep_their_outside) {
    for (const json& scale : {json{1, 1, 1}, json{-1, 1, 1}, json{-1, -2, -3}, json{1, 1, -1}}) {
        TriangleFile rigid;
        rigid.node()["scale"] = scale;
        rigid.animate(0, "translation", {0, 1}, {0, 0, 0, 5, 0, 0}, "VEC3");
        EXPECT_GT(least_agreement(load(rigid)), 0.99f) << scale;

        // All vertices follow joint 1; joint 0, which moves none, is mirrored or not.
        SkinnedFile skinned;
        skinned.weights = {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0};
        skinned.joints = {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0};
        skinned.finish();
        skinned.root["nodes"][1]["children"] = json::array();
        skinned.root["nodes"][1]["scale"] = {-1, 1, 1};
        skinned.root["nodes"][2]["scale"] = scale;
        EXPECT_GT(least_agreement(load(skinned)), 0.99f) << scale;
    }
    // One that has no size at second 0 is turned as it will be.
    TriangleFile pop;
    pop.root["nodes"] = {{{"children", {1}}, {"scale", {-1, 1, 1}}}, {{"mesh", 0}}};
    pop.animate(1, "scale", {0, 1}, {0, 0, 0, 1, 1, 1}, "VEC3");
    const Scene scene = load(pop);
    EXPECT_EQ(scene.indices, (std::vector<uint32_t>{0, 2, 1}));
}

TEST(GltfMotion, parts_of_one_skin_share_its_matrices) {
    SkinnedFile file;
    file.finish();
    const json primitive = file.primitive();
    for (int i = 0; i < 300; ++i)
        file.root["meshes"][0]["primitives"].push_back(primitive);
    const Scene scene = load(file);
    EXPECT_EQ(scene.motion.parts.size(), 301u);
    EXPECT_EQ(scene.motion.matrix_count, 2u);
    EXPECT_TRUE(near(scene.positions[3 * 300 + 1], {6, 0, 0}));
}

TEST(GltfMotion, a_camera_is_found_for_what_leaves_all_bounds_later) {
    TriangleFile file;
    file.root["nodes"] = {{{"children", {1}}}, {{"mesh", 0}}};
    for (const size_t node : {0, 1})
        file.animate(node, "translation", {0, 1}, {0, 0, 0, 8e8f, 0, 0}, "VEC3");
    EXPECT_EQ(load(file).cameras.size(), 1u);
    file.root["nodes"][1]["scale"] = {2e9, 1, 1};
    EXPECT_CONTAINS(refusal(file), "animations[0]: moves, at second 0, a vertex beyond");
}

} // namespace
} // namespace romascope
