// SPDX-License-Identifier: MIT
// What of a glTF file becomes a scene: materials, texture coordinates, colours, meshes, lights.
#include "tests/support/gltf_files.h"

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include <cmath>

namespace romascope {
namespace {

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

} // namespace
} // namespace romascope
