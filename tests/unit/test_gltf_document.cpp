// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/nodes.h"
#include "tests/support/gltf_document_fixture.h"

#include <fmt/format.h>

#include <cstring>

namespace romascope::gltf {
namespace {

// --- container -------------------------------------------------------------------------------

TEST_F(GltfDocument, square_comes_through) {
    const auto document = open(glb(kSquare, square_bytes()));
    EXPECT_EQ(document->model().meshes.size(), 1u);
    EXPECT_EQ(document->model().nodes[1].translation, (std::vector<double>{0.5, 0.5, 3.0}));
    EXPECT_EQ(bytes_of_view(*document, 0), bytes_of(kCorners));
    EXPECT_EQ(bytes_of_view(*document, 1), bytes_of(kNormals));
    EXPECT_TRUE(document->notices().empty());
}

TEST_F(GltfDocument, glb_lengths_that_lie) {
    const std::string good = glb(kSquare, square_bytes());
    const auto with_word = [&](size_t at, uint32_t value) {
        std::string file = good;
        std::memcpy(file.data() + at, &value, sizeof(value));
        return file;
    };
    uint32_t json_length;
    std::memcpy(&json_length, good.data() + 12, sizeof(json_length));
    const size_t bin = 20 + json_length;
    EXPECT_CONTAINS(refusal(good.substr(0, 19)), "GLB: ends after 19 bytes");
    EXPECT_CONTAINS(refusal(good.substr(0, 100)), "GLB: says it has");
    EXPECT_CONTAINS(refusal(with_word(4, 1)), "GLB: version 1");
    EXPECT_CONTAINS(refusal(with_word(8, 0)), "GLB: says it has 0 bytes");
    EXPECT_CONTAINS(refusal(with_word(8, UINT32_MAX)), "GLB: says it has 4294967295");
    // 20 plus these lengths is 0 or small in 32 bits.
    for (const uint32_t length : {UINT32_MAX, UINT32_MAX - 19, UINT32_MAX - 3})
        EXPECT_CONTAINS(refusal(with_word(12, length)), "GLB: the chunk at byte 12");
    EXPECT_CONTAINS(refusal(with_word(bin, UINT32_MAX)), fmt::format("chunk at byte {}", bin));
    EXPECT_CONTAINS(refusal(with_word(16, 0x004e4942)), "GLB: its first chunk is not JSON");
    EXPECT_CONTAINS(refusal(with_word(bin + 4, 0x4e4f534a)), "GLB: has more than one JSON chunk");
}

TEST_F(GltfDocument, glb_with_other_chunks_and_trailing_bytes) {
    std::string file = glb(kSquare, square_bytes());
    EXPECT_NO_THROW(open(file + "trailing bytes"));
    // A chunk of a kind to come, between JSON and BIN.
    uint32_t json_length, total;
    std::memcpy(&json_length, file.data() + 12, sizeof(json_length));
    std::memcpy(&total, file.data() + 8, sizeof(total));
    total += 12;
    std::memcpy(file.data() + 8, &total, sizeof(total));
    file.insert(20 + json_length, std::string("\4\0\0\0KIND1234", 12));
    EXPECT_EQ(bytes_of_view(*open(file), 0), bytes_of(kCorners));
}

TEST_F(GltfDocument, text_with_byte_order_mark) {
    const std::string uri = "data:application/octet-stream;base64," + base64(square_bytes());
    EXPECT_EQ(bytes_of_view(*open("\xef\xbb\xbf \n" + with_uri(uri)), 1), bytes_of(kNormals));
}

TEST_F(GltfDocument, what_is_no_gltf) {
    for (const char* content : {"", "glTF", "FTlg\2\0\0\0", "v 0 0 0\n", "[1]", "\xef\xbb\xbf"})
        EXPECT_FALSE(refusal(content).empty()) << content;
    EXPECT_CONTAINS(refusal("{\"asset\": "), "JSON: parse error at line 1");
    EXPECT_CONTAINS(refusal("{\"asset\": \"\x80\"}"), "JSON: ");
    EXPECT_CONTAINS(refusal("{\"nodes\": [{\"scale\": [1e999, 1, 1]}]}"), "JSON: number overflow");
    EXPECT_CONTAINS(refusal("{\"a\": " + std::string(100000, '[')), "nested deeper than 128");
    EXPECT_CONTAINS(refusal("{\"a\": " + std::string(200, '[') + std::string(200, ']') + "}"),
                    "nested deeper");
    EXPECT_NO_THROW(
        open(R"({"asset": {"version": "2.0"}, "extras": ")" + std::string(500, '[') + "\\\"\"}"));
}

TEST_F(GltfDocument, messages_are_one_line_of_sane_length) {
    const std::string wild = "\\u0000\\n\\u001b[31m\\r" + std::string(5000, 'x') + "\xc3\xa4";
    const std::string text =
        square_refusal("\"scene\": 0,", "\"extensionsRequired\": [\"" + wild + "\"],");
    EXPECT_CONTAINS(text, "extensionsRequired[0]: needs ?;?[31m?xxx");
    EXPECT_LT(text.size(), 500u);
    for (const char c : text)
        EXPECT_GE(static_cast<unsigned char>(c), 32) << text;
    // A cut never leaves half a character.
    for (size_t n = 350; n < 410; ++n) {
        const std::string line =
            one_line(std::string(n, 'x') + "\xc3\xa4\xc3\xa4" + std::string(100, 'x'));
        const size_t end = line.find(" ...");
        ASSERT_NE(end, std::string::npos);
        EXPECT_NE(line[end - 1], '\xc3');
    }
}

// --- versions and extensions -----------------------------------------------------------------

TEST_F(GltfDocument, versions) {
    const std::string now = "{\"version\": \"2.0\"}";
    for (const char* good : {"{\"version\": \"2.1\"}", "{\"version\": \"2.9\", \"generator\": 7}",
                             "{\"version\": \"2.1\", \"minVersion\": \"2.0\"}"})
        EXPECT_NO_THROW(open_square(now, good)) << good;
    EXPECT_CONTAINS(square_refusal(now, "{\"version\": \"1.0\"}"), "asset.version: '1.0'");
    EXPECT_CONTAINS(square_refusal(now, "{\"version\": \"20.0\"}"), "asset.version: '20.0'");
    EXPECT_CONTAINS(square_refusal(now, "{\"version\": 2.0}"), "asset.version: must be a string");
    EXPECT_CONTAINS(square_refusal(now, "{}"), "asset.version: is missing");
    EXPECT_CONTAINS(square_refusal(now, "{\"version\": \"2.1\", \"minVersion\": \"2.1\"}"),
                    "asset.minVersion: '2.1'");
    EXPECT_CONTAINS(refusal("{}"), "asset: is missing");
}

TEST_F(GltfDocument, required_extensions) {
    const auto requiring = [](const std::string& names) {
        return "\"extensionsRequired\": [" + names + "], \"scene\": 0,";
    };
    const auto document = open_square(
        "\"scene\": 0,", requiring("\"KHR_mesh_quantization\", \"KHR_texture_transform\", "
                                   "\"EXT_meshopt_compression\", \"KHR_draco_mesh_compression\", "
                                   "\"KHR_lights_punctual\", \"KHR_materials_emissive_strength\", "
                                   "\"KHR_materials_variants\""));
    EXPECT_TRUE(document->notices().empty());
    const auto plainer = open_square("\"scene\": 0,", requiring("\"KHR_materials_transmission\""));
    ASSERT_EQ(plainer->notices().size(), 1u);
    EXPECT_CONTAINS(plainer->notices()[0], "KHR_materials_transmission");
    EXPECT_CONTAINS(
        square_refusal("\"scene\": 0,", requiring("\"KHR_mesh_quantization\", \"VENDOR_strange\"")),
        "extensionsRequired[1]: needs VENDOR_strange");
    for (const char* name : {"KHR_texture_basisu", "EXT_texture_webp"})
        EXPECT_CONTAINS(square_refusal("\"scene\": 0,", requiring(fmt::format("\"{}\"", name))),
                        std::string("extensionsRequired[0]: needs ") + name);
    EXPECT_CONTAINS(square_refusal("\"scene\": 0,", requiring("3")),
                    "extensionsRequired[0]: must be a string");
}

TEST_F(GltfDocument, extensions_in_use_that_are_not_known_are_noticed) {
    std::string names;
    for (int i = 10; i < 60; ++i)
        names += fmt::format("\"VENDOR_{}\", ", i);
    const auto document =
        open_square("\"scene\": 0,",
                    "\"extensionsUsed\": [" + names + "\"KHR_texture_basisu\"], \"scene\": 0,");
    ASSERT_EQ(document->notices().size(), 17u);
    EXPECT_CONTAINS(document->notices()[0], "VENDOR_10");
    EXPECT_CONTAINS(document->notices()[16], "34 more");
}

// --- the schema ------------------------------------------------------------------------------

struct Change {
    const char* from;
    const char* to;
    const char* message; ///< or a part of it
};

TEST_F(GltfDocument, faults_are_refused_with_their_path) {
    const std::vector<Change> cases = {
        // Types.
        {"\"accessors\"", "\"accessors\": {}, \"ignored\"", "accessors: must be an array"},
        {"\"nodes\": [0, 1]", "\"nodes\": 0", "scenes[0].nodes: must be an array, but is 0"},
        {"\"material\": 0", "\"material\": null",
         "primitives[0].material: must be an integer, but "
         "is null"},
        {"\"material\": 0", "\"material\": 0.5", "must be an integer, but is 0.5"},
        {"\"material\": 0", "\"material\": \"0\"", "must be an integer, but is \"0\""},
        {"\"yfov\": 0.8", "\"yfov\": \"wide\"", "cameras[0].perspective.yfov: must be a number"},
        {"\"name\": \"clay\"", "\"name\": 3", "materials[0].name: must be a string"},
        {"\"name\": \"clay\"", "\"doubleSided\": 1", "materials[0].doubleSided: must be true"},
        {"\"name\": \"clay\"", "\"extensions\": []", "materials[0].extensions: must be an object"},
        // Indices.
        {"\"POSITION\": 0", "\"POSITION\": 9",
         "meshes[0].primitives[0].attributes.POSITION: 9 does not exist, there are 3"},
        {"\"POSITION\": 0", "\"POSITION\": -7", "attributes.POSITION: -7 does not exist"},
        {"\"indices\": 2", "\"indices\": 4294967295",
         "meshes[0].primitives[0].indices: 4294967295 does not exist, there are 3"},
        {"\"indices\": 2", "\"indices\": 4294967296", "indices: 4294967296 does not exist"},
        {"\"indices\": 2", "\"indices\": 18446744073709551615", "indices: 18446744073709551615"},
        {"\"indices\": 2", "\"indices\": 1e30", "indices: must be an integer, but is 1e+30"},
        {"\"indices\": 2", "\"targets\": [{\"POSITION\": 3}]",
         "primitives[0].targets[0].POSITION: 3 does not exist"},
        {"\"material\": 0", "\"material\": 1",
         "primitives[0].material: 1 does not exist, there are 1"},
        {"\"bufferView\": 2", "\"bufferView\": 5",
         "accessors[2].bufferView: 5 does not exist, there are 3"},
        {"{\"buffer\": 0, \"byteOffset\": 48", "{\"buffer\": 4, \"byteOffset\": 48",
         "bufferViews[1].buffer: 4 does not exist, there are 1"},
        {"\"mesh\": 0", "\"mesh\": 1", "nodes[0].mesh: 1 does not exist"},
        {"\"mesh\": 0", "\"skin\": 0", "nodes[0].skin: 0 does not exist, there are 0"},
        {"\"mesh\": 0", "\"children\": [8]", "nodes[0].children[0]: 8 does not exist"},
        {"\"camera\": 0", "\"camera\": 3", "nodes[1].camera: 3 does not exist"},
        {"\"nodes\": [0, 1]", "\"nodes\": [0, 5]", "scenes[0].nodes[1]: 5 does not exist"},
        {"\"scene\": 0", "\"scene\": 2", "scene: 2 does not exist, there are 1"},
        {"\"name\": \"clay\"", "\"normalTexture\": {\"index\": 0}",
         "materials[0].normalTexture.index: 0 does not exist, there are 0"},
        {"\"mesh\": 0", "\"extensions\": {\"KHR_lights_punctual\": {\"light\": 0}}",
         "nodes[0].extensions.KHR_lights_punctual.light: 0 does not exist"},
        {"\"scene\": 0", "\"skins\": [{\"joints\": [0, 2]}]", "skins[0].joints[1]: 2 does not"},
        {"\"scene\": 0",
         "\"animations\": [{\"channels\": [{\"sampler\": 1, \"target\": {\"path\": \"scale\"}}], "
         "\"samplers\": [{\"input\": 0, \"output\": 0}]}]",
         "animations[0].channels[0].sampler: 1 does not exist, there are 1"},
        // Missing.
        {"\"meshes\"", "\"ignored\"", "nodes[0].mesh: 0 does not exist, there are 0"},
        {"\"attributes\":", "\"attribute\":", "meshes[0].primitives[0].attributes: is missing"},
        {"\"count\": 6,", "", "accessors[2].count: is missing"},
        {"\"byteLength\": 12", "\"byteLenght\": 12", "bufferViews[2].byteLength: is missing"},
        {"\"perspective\": {", "\"orthographic\": {", "cameras[0].orthographic.xmag: is missing"},
        {"\"type\": \"perspective\"", "\"type\": \"orthographic\"",
         "cameras[0].orthographic: is missing"},
        {"\"scene\": 0", "\"images\": [{}]", "images[0]: has neither uri nor bufferView"},
        {"\"scene\": 0", "\"images\": [{\"uri\": \"a.png\", \"bufferView\": 0}]",
         "images[0]: has both uri and bufferView"},
        {"\"scene\": 0", "\"skins\": [{\"joints\": []}]",
         "skins[0].joints: has 0 elements, too few"},
        {"\"scene\": 0",
         "\"extensions\": {\"KHR_lights_punctual\": {\"lights\": [{\"type\": \"spot\"}]}}",
         "extensions.KHR_lights_punctual.lights[0].spot: is missing"},
        // Choices, ranges, lengths.
        {"5123", "5124", "accessors[2].componentType: 5124 is not one of 5120, 5121"},
        {"5123", "-5123", "accessors[2].componentType: -5123 is not one of"},
        {"\"SCALAR\"", "\"SKALAR\"", "accessors[2].type: 'SKALAR' is not one of SCALAR"},
        {"\"indices\": 2", "\"mode\": 7", "meshes[0].primitives[0].mode: 7 is not one of 0, 1"},
        {"\"name\": \"clay\"", "\"alphaMode\": \"MASKED\"", "materials[0].alphaMode: 'MASKED'"},
        {"\"count\": 6", "\"count\": 0", "accessors[2].count: 0 is not from 1"},
        {"\"count\": 6", "\"count\": 4294967295", "accessors[2].count: 4294967295 is not from 1"},
        {"\"count\": 6", "\"count\": 4611686018427387904", "accessors[2].count: 46116860184273879"},
        {"\"bufferView\": 1,", "\"bufferView\": 1, \"byteOffset\": -4,",
         "accessors[1].byteOffset: -4 is not from 0"},
        {"\"bufferView\": 1,", "\"bufferView\": 1, \"byteOffset\": 18446744073709551612,",
         "accessors[1].byteOffset: 18446744073709551612 is not from 0"},
        {"\"byteOffset\": 96", "\"byteOffset\": 18446744073709551605",
         "bufferViews[2].byteOffset: "},
        {"\"byteOffset\": 48,", "\"byteOffset\": 48, \"byteStride\": 2,",
         "bufferViews[1].byteStride: 2 is not from 4 to 252"},
        {"\"byteOffset\": 48,", "\"byteOffset\": 48, \"byteStride\": 256,",
         "bufferViews[1].byteStride: 256 is not from 4 to 252"},
        {"\"byteOffset\": 48,", "\"byteOffset\": 48, \"byteStride\": 14,",
         "bufferViews[1].byteStride: 14 is not a multiple of 4"},
        {"\"yfov\": 0.8", "\"yfov\": 0", "cameras[0].perspective.yfov: 0 is not above 0"},
        {"[0.5, 0.25, 1, 1]", "[0.5, 0.25, 1]", "baseColorFactor: has 3 elements instead of 4"},
        {"[0.5, 0.5, 3]", "[0.5, 0.5]", "nodes[1].translation: has 2 elements instead of 3"},
        {"\"mesh\": 0", "\"matrix\": [1, 2]", "nodes[0].matrix: has 2 elements instead of 16"},
        // Spans.
        {"\"byteOffset\": 96", "\"byteOffset\": 97",
         "bufferViews[2]: 12 bytes from byte 97 reach beyond buffers[0] of 108 bytes"},
        {"\"byteOffset\": 96", "\"byteOffset\": 4294967292", "bufferViews[2]: 12 bytes from byte"},
        {"\"byteOffset\": 96", "\"byteOffset\": 9007199254740991", "bufferViews[2]: 12 bytes from"},
        {"\"count\": 6", "\"count\": 7",
         "accessors[2]: 7 elements from byte 0 reach beyond bufferViews[2] of 12 bytes"},
        {"\"count\": 6", "\"count\": 4294967294", "accessors[2]: 4294967294 elements"},
        {"\"bufferView\": 1,", "\"bufferView\": 1, \"byteOffset\": 4,", "accessors[1]: 4 elements"},
        {"\"bufferView\": 1,", "\"bufferView\": 1, \"byteOffset\": 9007199254740991,",
         "accessors[1]: 4 elements"},
        {"\"byteOffset\": 48,", "\"byteOffset\": 48, \"byteStride\": 8,",
         "accessors[1]: byteStride 8 of bufferViews[1] is less than an element's 12 bytes"},
        {"\"byteOffset\": 48,", "\"byteOffset\": 48, \"byteStride\": 16,",
         "accessors[1]: 4 elements"},
        {"{\"byteLength\": 108}", "{\"byteLength\": 10800}",
         "buffers[0].byteLength: 10800, but the BIN chunk has 108 bytes"},
        // Nodes.
        {"\"nodes\": [0, 1]", "\"nodes\": [0, 0]", "scenes[0].nodes[1]: node 0 is named twice"},
        {"\"mesh\": 0", "\"children\": [0]", "nodes[0]: is its own descendant"},
        {"\"mesh\": 0", "\"children\": [1]",
         "scenes[0].nodes[1]: node 1 is a child of node 0, but must be a root"},
        {"\"mesh\": 0", "\"children\": [1, 1]",
         "nodes[0].children[1]: node 1 is a child of node 0"},
    };
    for (const Change& each : cases)
        EXPECT_CONTAINS(square_refusal(each.from, each.to), each.message);
}

TEST_F(GltfDocument, odd_files_pass) {
    const std::vector<Change> cases = {
        {"\"scene\": 0,", "\"scene\": 0, \"extras\": [[{}]], \"custom\": {\"a\": null},", ""},
        {"\"scene\": 0,", "\"scene\": 0.0, \"images\": [], \"skins\": [], \"animations\": [],", ""},
        {"\"scene\": 0,", "", ""},
        {"\"indices\": 2", "\"indices\": 2.0", ""},
        {"\"count\": 6", "\"count\": 60e-1", ""},
        {"\"indices\": 2", "\"indices\": -0", ""},
        {"\"type\": \"perspective\"", "\"type\": \"fisheye\"", ""},
        {"\"SCALAR\"", "\"SCALAR\", \"min\": [7], \"max\": \"none\"", ""},
        {"\"name\": \"clay\"", "\"name\": \"clay\", \"extensions\": {\"VENDOR_x\": 3}", ""},
        {"\"bufferView\": 0,", "\"byteOffset\": 4,", ""},   // zeros: the offset has no meaning
        {"\"bufferView\": 2,", "", ""},                     // indices, too
        {"\"byteOffset\": 48,", "\"byteOffset\": 47,", ""}, // not aligned
        {"{\"buffer\": 0, \"byteOffset\": 48, \"byteLength\": 48}",
         "{\"buffer\": 0, \"byteOffset\": 48, \"byteLength\": 48, \"target\": 7}", ""},
        {"\"byteOffset\": 96, \"byteLength\": 12", "\"byteOffset\": 88, \"byteLength\": 20", ""},
        {"\"buffers\": [", "\"buffers\": [", ""},
        {"\"nodes\": [{", "\"nodes\": [{\"weights\": [], \"children\": [], ", ""},
        {"\"scene\": 0,",
         "\"extensions\": {\"KHR_lights_punctual\": {\"lights\": [{\"type\": \"area\"}]}},", ""},
        {"\"scene\": 0,",
         "\"animations\": [{\"channels\": [{\"sampler\": 0, \"target\": {\"path\": \"pointer\"}}], "
         "\"samplers\": [{\"input\": 0, \"output\": 0}]}],",
         ""},
    };
    for (const Change& each : cases)
        EXPECT_NO_THROW(open_square(each.from, each.to)) << each.to;
    EXPECT_EQ(
        open_square("\"type\": \"perspective\"", "\"type\": \"fisheye\"")->model().cameras[0].type,
        "fisheye");
    EXPECT_EQ(open_square("\"count\": 6", "\"count\": 60e-1")->model().accessors[2].count, 6u);
    const auto without_views = open(R"({"asset": {"version": "2.0"},
        "accessors": [{"componentType": 5125, "count": 3, "type": "SCALAR"}],
        "meshes": [{"primitives": [{"attributes": {}, "indices": 0}]}]})");
    EXPECT_EQ(without_views->model().accessors[0].bufferView, -1);
    EXPECT_TRUE(without_views->model().bufferViews.empty());
}

TEST_F(GltfDocument, duplicate_keys_take_the_last) {
    EXPECT_EQ(open_square("\"name\": \"clay\"", "\"name\": \"mud\", \"name\": \"clay\"")
                  ->model()
                  .materials[0]
                  .name,
              "clay");
}

// --- nodes -----------------------------------------------------------------------------------

std::string chain(int length) {
    std::string nodes;
    for (int i = 1; i < length; ++i)
        nodes += fmt::format("{{\"children\": [{}]}}, ", i);
    return "{\"asset\": {\"version\": \"2.0\"}, \"nodes\": [" + nodes + "{}]}";
}

TEST_F(GltfDocument, depth_of_the_node_tree) {
    EXPECT_NO_THROW(open(chain(kMaxNodeDepth)));
    EXPECT_CONTAINS(refusal(chain(kMaxNodeDepth + 1)),
                    fmt::format("nodes[{}]: its tree is deeper than", kMaxNodeDepth));
    EXPECT_CONTAINS(refusal(chain(100000)), "deeper than");
}

TEST_F(GltfDocument, graphs_with_exponentially_many_paths) {
    // Rows of two nodes, each a parent of both below: 2^60 ways down.
    std::string nodes;
    for (int i = 2; i < 122; i += 2)
        for (int k = 0; k < 2; ++k)
            nodes += fmt::format("{{\"children\": [{}, {}]}}, ", i, i + 1);
    EXPECT_CONTAINS(
        refusal("{\"asset\": {\"version\": \"2.0\"}, \"nodes\": [" + nodes + "{}, {}]}"),
        "nodes[1].children[0]: node 2 is a child of node 0 already");
}

TEST_F(GltfDocument, cycles_far_from_the_scene_are_refused) {
    EXPECT_CONTAINS(refusal(R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}],
        "nodes": [{}, {"children": [2]}, {"children": [3]}, {"children": [1]}]})"),
                    "nodes[1]: is its own descendant");
}

} // namespace
} // namespace romascope::gltf
