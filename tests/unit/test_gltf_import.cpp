// SPDX-License-Identifier: MIT
// What of a glTF file becomes a scene: materials, texture coordinates, colours, cameras, lights,
// skins, morph targets, animations.
#include "renderer/base/error.h"
#include "renderer/scene/gltf/import.h"
#include "tests/support/expect_error.h"
#include "tests/support/gltf_builder.h"

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace romascope {
namespace {

using nlohmann::json;

Scene load(const GltfBuilder& file, size_t max_memory = size_t{1} << 28) {
    return import_gltf(file.glb(), "asset.glb", max_memory);
}

std::string refusal(const GltfBuilder& file, size_t max_memory = size_t{1} << 28) {
    try {
        load(file, max_memory);
    } catch (const Error& error) {
        EXPECT_EQ(error.exit_status(), kBadInput);
        return error.what();
    }
    return "was taken";
}

const std::vector<float> kTriangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};
const std::vector<float> kUp = {0, 0, 1, 0, 0, 1, 0, 0, 1};

/// One triangle in z = 0 with normals, as mesh 0 of node 0.
struct TriangleFile : GltfBuilder {
    TriangleFile() {
        add_mesh(
            {{"POSITION", add_accessor(kTriangle, "VEC3")}, {"NORMAL", add_accessor(kUp, "VEC3")}});
        add("nodes", {{"mesh", 0}});
    }
    json& primitive() { return root["meshes"][0]["primitives"][0]; }
    json& node() { return root["nodes"][0]; }
    void animate(size_t node, const char* path, const std::vector<float>& times,
                 const std::vector<float>& values, const char* type,
                 const char* interpolation = "LINEAR") {
        json sampler = {{"input", add_accessor(times, "SCALAR")},
                        {"output", add_accessor(values, type)},
                        {"interpolation", interpolation}};
        json channel = {{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}};
        if (!root.contains("animations"))
            root["animations"] = {{{"samplers", json::array()}, {"channels", json::array()}}};
        json& animation = root["animations"][0];
        channel["sampler"] = animation["samplers"].size();
        animation["samplers"].push_back(sampler);
        animation["channels"].push_back(channel);
    }
};

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

bool near(glm::vec3 a, glm::vec3 b, float tolerance = 1e-6f) {
    return glm::distance(a, b) <= tolerance;
}

bool has_notice(const Scene& scene, const std::string& part) {
    return std::ranges::any_of(scene.notices, [&](const std::string& line) {
        return line.find(part) != std::string::npos;
    });
}

TEST(GltfMaterials, factors_masks_and_sides) {
    TriangleFile file;
    file.primitive()["material"] = 1;
    file.add("materials", {{"name", "unused"}});
    file.add("materials",
             {{"name", "leaf"},
              {"alphaMode", "MASK"},
              {"alphaCutoff", 0.25},
              {"doubleSided", true},
              {"emissiveFactor", {0.5, 0.25, 1.0}},
              {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4.0}}}}},
              {"pbrMetallicRoughness", {{"baseColorFactor", {0.1, 0.2, 0.3, 0.5}}}}});
    const Scene scene = load(file);
    ASSERT_EQ(scene.materials.size(), 1u); // only what is in use
    const Material& material = scene.materials[0];
    EXPECT_EQ(material.name, "leaf");
    EXPECT_EQ(material.base_color, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(material.emissive, glm::vec3(2.0f, 1.0f, 4.0f));
    EXPECT_FLOAT_EQ(material.alpha, 0.5f);
    EXPECT_FLOAT_EQ(material.alpha_cutoff, 0.25f);
    EXPECT_TRUE(material.double_sided);
    EXPECT_TRUE(scene.notices.empty());

    file.root["materials"][1]["alphaMode"] = "OPAQUE";
    EXPECT_EQ(load(file).materials[0].alpha_cutoff, 0.0f);
    file.root["materials"][1]["alphaMode"] = "MASK";
    file.root["materials"][1].erase("alphaCutoff");
    EXPECT_EQ(load(file).materials[0].alpha_cutoff, 0.5f);
    // A threshold above 1 lets nothing through, whatever the alpha.
    file.root["materials"][1]["alphaCutoff"] = 1.5;
    EXPECT_LT(load(file).materials[0].alpha, load(file).materials[0].alpha_cutoff);
    file.root["materials"][1]["alphaMode"] = "BLEND";
    EXPECT_EQ(load(file).materials[0].alpha_cutoff, 0.0f);
    EXPECT_TRUE(has_notice(load(file), "materials[1]: alphaMode BLEND is drawn opaque"));
}

TEST(GltfMaterials, triangles_are_sorted_by_how_they_are_drawn) {
    TriangleFile file;
    file.add("materials", {{"alphaMode", "MASK"}});
    file.add("materials", {{"doubleSided", true}});
    json& primitives = file.root["meshes"][0]["primitives"];
    for (const int material : {0, 1, -1, 0, 1}) {
        json primitive = primitives[0];
        if (material >= 0)
            primitive["material"] = material;
        primitives.push_back(primitive);
    }
    const Scene scene = load(file);
    EXPECT_EQ(scene.triangle_count(), 6u);
    const auto groups = triangle_groups(scene);
    ASSERT_EQ(groups.size(), 3u);
    EXPECT_TRUE(!groups[0].masked && !groups[0].double_sided && groups[0].count == 2);
    EXPECT_TRUE(!groups[1].masked && groups[1].double_sided && groups[1].count == 2);
    EXPECT_TRUE(groups[2].masked && !groups[2].double_sided && groups[2].count == 2);
    EXPECT_EQ(groups[2].first, 4u);
}

/// A 1x1 white PNG.
std::string white_png() {
    constexpr unsigned char kBytes[] = {
        0x89, 'P',  'N',  'G',  0x0d, 0x0a, 0x1a, 0x0a, 0,    0,    0,    13,   'I',  'H',
        'D',  'R',  0,    0,    0,    1,    0,    0,    0,    1,    8,    2,    0,    0,
        0,    0x90, 0x77, 0x53, 0xde, 0,    0,    0,    12,   'I',  'D',  'A',  'T',  0x08,
        0xd7, 0x63, 0xf8, 0xff, 0xff, 0x3f, 0,    0x05, 0xfe, 0x02, 0xfe, 0xdc, 0xcc, 0x59,
        0xe7, 0,    0,    0,    0,    'I',  'E',  'N',  'D',  0xae, 0x42, 0x60, 0x82};
    return {reinterpret_cast<const char*>(kBytes), sizeof(kBytes)};
}

struct TexturedFile : TriangleFile {
    TexturedFile() {
        add("images", {{"bufferView", add_view(white_png())}, {"mimeType", "image/png"}});
        add("textures", {{"source", 0}});
        add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
        primitive()["material"] = 0;
        primitive()["attributes"]["TEXCOORD_0"] =
            add_accessor(std::vector<float>{0, 0, 1, 0, 0, 1}, "VEC2");
    }
    json& texture() { return root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]; }
};

TEST(GltfTexcoords, are_read_from_their_set_and_transformed) {
    TexturedFile file;
    const Scene plain = load(file);
    ASSERT_EQ(plain.textures.size(), 1u);
    EXPECT_EQ(plain.materials[0].texture, 0);
    ASSERT_EQ(plain.texcoords.size(), 3u);
    EXPECT_EQ(plain.texcoords[1], glm::vec2(1, 0));

    // Normalised integers of another set.
    file.primitive()["attributes"]["TEXCOORD_2"] =
        file.add_accessor(std::vector<uint16_t>{0, 65535, 65535, 0, 13107, 0}, "VEC2", true);
    file.texture()["texCoord"] = 2;
    EXPECT_EQ(load(file).texcoords[0], glm::vec2(0, 1));
    EXPECT_NEAR(load(file).texcoords[2].x, 0.2f, 1e-6f);

    // Scaled by (2, 3), then turned a quarter, which takes the picture's right to its top, then
    // moved. The extension's own set goes before the other.
    file.texture()["extensions"]["KHR_texture_transform"] = {{"texCoord", 0},
                                                             {"scale", {2, 3}},
                                                             {"rotation", glm::half_pi<double>()},
                                                             {"offset", {10, 20}}};
    const Scene moved = load(file);
    EXPECT_LT(glm::distance(moved.texcoords[0], glm::vec2(10, 20)), 1e-5f);
    EXPECT_LT(glm::distance(moved.texcoords[1], glm::vec2(10, 18)), 1e-5f); // (2, 0) -> (0, -2)
    EXPECT_LT(glm::distance(moved.texcoords[2], glm::vec2(13, 20)), 1e-5f); // (0, 3) -> (3, 0)

    file.texture().erase("extensions");
    file.texture()["texCoord"] = 1;
    EXPECT_TRUE(has_notice(load(file), "no texture coordinates"));
}

TEST(GltfTexcoords, are_there_for_all_vertices_or_for_none) {
    EXPECT_TRUE(load(TriangleFile()).texcoords.empty());
    TexturedFile file;
    const json textured = file.primitive();
    json plain = textured;
    plain.erase("material");
    file.root["meshes"][0]["primitives"] = {plain, textured, plain};
    const Scene scene = load(file);
    ASSERT_EQ(scene.texcoords.size(), 9u);
    EXPECT_EQ(scene.texcoords[4], glm::vec2(1, 0));
    EXPECT_EQ(scene.texcoords[8], glm::vec2(0, 0));
}

TEST(GltfColors, of_every_type) {
    for (const char* type : {"VEC3", "VEC4"}) {
        const bool alpha = std::string(type) == "VEC4";
        std::vector<float> floats;
        std::vector<uint8_t> bytes;
        std::vector<uint16_t> shorts;
        for (int i = 0; i < 3; ++i)
            for (int c = 0; c < (alpha ? 4 : 3); ++c) {
                const auto value = static_cast<uint8_t>(10 * i + 60 * c);
                floats.push_back(value / 255.0f);
                bytes.push_back(value);
                shorts.push_back(static_cast<uint16_t>(value * 257));
            }
        for (int kind = 0; kind < 3; ++kind) {
            TriangleFile file;
            file.primitive()["attributes"]["COLOR_0"] = kind == 0 ? file.add_accessor(floats, type)
                                                        : kind == 1
                                                            ? file.add_accessor(bytes, type, true)
                                                            : file.add_accessor(shorts, type, true);
            const Scene scene = load(file);
            ASSERT_EQ(scene.colors.size(), 3u);
            EXPECT_EQ(scene.colors[2], 20u | 80u << 8 | 140u << 16 | (alpha ? 200u : 255u) << 24);
        }
    }
    EXPECT_TRUE(load(TriangleFile()).colors.empty());
}

TEST(GltfMeshes, quantised_positions_and_normals) {
    TriangleFile file;
    file.primitive()["attributes"] = {
        {"POSITION",
         file.add_accessor(std::vector<int16_t>{0, 0, 0, 400, 0, 0, 0, -300, 0}, "VEC3")},
        {"NORMAL",
         file.add_accessor(std::vector<int8_t>{0, 0, 127, 0, 0, 127, 0, 127, 0}, "VEC3", true)}};
    file.node()["scale"] = {0.01, 0.01, 0.01};
    file.root["extensionsUsed"] = file.root["extensionsRequired"] = {"KHR_mesh_quantization"};
    const Scene scene = load(file);
    EXPECT_TRUE(near(scene.positions[1], {4, 0, 0}));
    EXPECT_TRUE(near(scene.positions[2], {0, -3, 0}));
    EXPECT_EQ(scene.normals[2], glm::vec3(0, 1, 0));
}

TEST(GltfMeshes, points_and_lines_are_left_out_with_one_notice) {
    TriangleFile file;
    const json triangles = file.primitive();
    for (int mode = 0; mode < 4; ++mode) {
        json other = triangles;
        other["mode"] = mode;
        file.root["meshes"][0]["primitives"].push_back(other);
    }
    const Scene scene = load(file);
    EXPECT_EQ(scene.triangle_count(), 1u);
    ASSERT_EQ(scene.notices.size(), 1u);
    EXPECT_EQ(scene.notices[0],
              "meshes[0].primitives[1] and 3 more: points and lines are left out");
    file.root["meshes"][0]["primitives"].erase(0);
    EXPECT_CONTAINS(refusal(file), "scene: has no triangles");
}

TEST(GltfScenes, only_the_default_scene_is_drawn) {
    TriangleFile file;
    file.add("nodes", {{"mesh", 0}, {"translation", {0, 0, 7}}});
    file.add("nodes", {{"children", {1}}, {"translation", {0, 0, 1}}});
    EXPECT_EQ(load(file).triangle_count(), 2u); // without scenes: all
    file.add("scenes", {{"nodes", {0}}});
    file.add("scenes", {{"nodes", {2}}});
    EXPECT_EQ(load(file).positions[0], glm::vec3(0, 0, 0));
    file.root["scene"] = 1;
    const Scene scene = load(file);
    EXPECT_EQ(scene.triangle_count(), 1u);
    EXPECT_EQ(scene.positions[0], glm::vec3(0, 0, 8));
}

TEST(GltfLights, of_every_kind) {
    TriangleFile file;
    file.root["extensionsUsed"] = {"KHR_lights_punctual"};
    file.root["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "directional"}, {"name", "sun"}, {"intensity", 3}, {"color", {1, 0.5, 0}}},
        {{"type", "point"}, {"range", 12.5}},
        {{"type", "spot"},
         {"intensity", 40},
         {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.4}}}}};
    for (int light = 0; light < 3; ++light)
        file.add("nodes", {{"name", fmt::format("lamp {}", light)},
                           {"translation", {light, 2, 3}},
                           {"rotation", {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)}},
                           {"scale", {2, 2, 2}},
                           {"extensions", {{"KHR_lights_punctual", {{"light", light}}}}}});
    const Scene scene = load(file);
    ASSERT_EQ(scene.lights.size(), 3u);
    EXPECT_EQ(scene.lights[0].kind, LightKind::directional);
    EXPECT_EQ(scene.lights[0].name, "sun");
    EXPECT_EQ(scene.lights[0].color, glm::vec3(3.0f, 1.5f, 0.0f));
    EXPECT_TRUE(near(scene.lights[0].direction, {0, -1, 0}));
    EXPECT_EQ(scene.lights[1].kind, LightKind::point);
    EXPECT_EQ(scene.lights[1].name, "lamp 1");
    EXPECT_EQ(scene.lights[1].position, glm::vec3(1, 2, 3));
    EXPECT_EQ(scene.lights[1].range, 12.5f);
    EXPECT_EQ(scene.lights[2].kind, LightKind::spot);
    EXPECT_FLOAT_EQ(scene.lights[2].inner_cone, 0.1f);
    EXPECT_FLOAT_EQ(scene.lights[2].outer_cone, 0.4f);
    EXPECT_TRUE(std::isinf(scene.lights[2].range));
    EXPECT_TRUE(scene.motion.empty());
}

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

TEST(GltfMaterials, blend_with_holes_is_a_mask) {
    TexturedFile file;
    const std::string clear =
        "data:image/png;base64,"
        "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNgYGBgAAAABQ"
        "ABh6FO1AAAAABJRU5ErkJggg==";
    json& material = file.root["materials"][0];
    material["alphaMode"] = "BLEND";
    material["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0.25};
    EXPECT_EQ(load(file).materials[0].alpha_cutoff, 0.0f);
    file.root["images"][0] = {{"uri", clear}};
    const Scene scene = load(file);
    EXPECT_EQ(scene.materials[0].alpha_cutoff, 0.5f);
    EXPECT_EQ(scene.materials[0].alpha, 1.0f);
    EXPECT_TRUE(has_notice(scene, "drawn as a mask at one half"));
}

TEST(GltfMaterials, textures_of_one_picture_are_one) {
    TexturedFile file;
    for (int i = 1; i < 200; ++i) {
        file.add("textures", {{"source", 0}});
        json primitive = file.primitive();
        primitive["material"] = i;
        file.root["meshes"][0]["primitives"].push_back(primitive);
        file.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", i}}}}}});
    }
    file.add("samplers", {{"wrapS", 33071}});
    file.root["textures"][7]["sampler"] = 0;
    const Scene scene = load(file);
    EXPECT_EQ(scene.materials.size(), 200u);
    EXPECT_EQ(scene.textures.size(), 2u);
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
