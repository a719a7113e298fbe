// SPDX-License-Identifier: MIT
// glTF files that must be refused, and what the message names.
#include "tests/support/gltf_fixture.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <random>

namespace romascope {
namespace {

TEST_F(Gltf, text_form_reads_buffers_beside_it_only) {
    const auto with_uri = [&](const std::string& uri) {
        return replaced(kSquare, "{\"byteLength\": 108",
                        "{\"uri\": \"" + uri + "\", \"byteLength\": 108");
    };
    write_file_atomically(folder_ / "asset" / "da ta.bin", square_bytes());
    write_file_atomically(folder_ / "outside.bin", square_bytes());
    EXPECT_EQ(load(with_uri("da%20ta.bin"), "a.gltf").triangle_count(), 2u);
    EXPECT_CONTAINS(refusal(with_uri("../outside.bin"), "a.gltf"), "outside the folder");
    fs::create_symlink(folder_ / "outside.bin", folder_ / "asset" / "link.bin");
    EXPECT_CONTAINS(refusal(with_uri("link.bin"), "a.gltf"), "outside the folder");
    EXPECT_CONTAINS(refusal(with_uri("missing.bin"), "a.gltf"), "missing.bin");
    EXPECT_CONTAINS(refusal(with_uri("."), "a.gltf"), "is not a plain file");
}

TEST_F(Gltf, pictures_that_nothing_shows_are_not_opened) {
    const std::string json = replaced(kSquare, "\"buffers\":",
                                      "\"images\": [{\"uri\": \"no.png\"}, {\"uri\": "
                                      "\"/dev/zero\"}], \"buffers\":");
    EXPECT_EQ(load(glb(json, square_bytes())).triangle_count(), 2u);
}

struct Broken {
    const char* from;
    const char* to;
    const char* element; ///< that the message names
};

TEST_F(Gltf, broken_files_are_refused_with_their_element) {
    const std::vector<Broken> cases = {
        {"\"POSITION\": 0", "\"POSITION\": 9",
         "meshes[0].primitives[0].attributes.POSITION: 9 does not exist, there are 3"},
        {"\"POSITION\": 0", "\"POSITION\": -7",
         "meshes[0].primitives[0].attributes.POSITION: -7 does not exist"},
        {"\"POSITION\": 0, ", "",
         "scene: has no triangles (meshes[0].primitives[0]: has no positions"},
        {"\"POSITION\": 0", "\"POSITION\": 2",
         "attributes.POSITION: accessors[2]: is SCALAR, but VEC3"},
        {"\"NORMAL\": 1", "\"NORMAL\": 77", "attributes.NORMAL: 77 does not exist"},
        {"\"indices\": 2", "\"indices\": 3", "meshes[0].primitives[0].indices: 3 does not exist"},
        {"\"indices\": 2", "\"indices\": -3", "meshes[0].primitives[0].indices: -3 does not exist"},
        {"\"indices\": 2", "\"indices\": 0", "indices: accessors[0]: is VEC3"},
        {"\"indices\": 2", "\"indices\": 2, \"mode\": 9", "meshes[0].primitives[0].mode: 9"},
        {"\"material\": 0", "\"material\": 1",
         "meshes[0].primitives[0].material: 1 does not exist"},
        {"5123", "5122", "indices: accessors[2]: component type 5122"},
        {"\"count\": 6", "\"count\": 7", "accessors[2]: 7 elements"},
        {"\"count\": 6", "\"count\": 4611686018427387904",
         "accessors[2].count: 4611686018427387904"},
        {"\"count\": 6", "\"count\": 0", "accessors[2].count: 0"},
        {"\"bufferView\": 2", "\"bufferView\": 5", "accessors[2].bufferView: 5"},
        {"\"bufferView\": 0,", "\"bufferView\": 5,", "accessors[0].bufferView: 5 does not exist"},
        {"\"bufferView\": 1,", "\"bufferView\": 1, \"byteOffset\": 4,", "accessors[1]: 4 elements"},
        {"\"bufferView\": 1,", "\"bufferView\": 1, \"byteOffset\": 18446744073709551612,",
         "accessors[1].byteOffset: 18446744073709551612"},
        {"\"bufferView\": 1,", "\"bufferView\": 1, \"byteOffset\": 2,",
         "accessors[1]: 4 elements from byte 2"},
        {"\"byteOffset\": 96", "\"byteOffset\": 97", "bufferViews[2]: 12 bytes from byte 97"},
        {"\"byteOffset\": 96", "\"byteOffset\": 18446744073709551605",
         "bufferViews[2].byteOffset: 18446744073709551605"},
        {"{\"buffer\": 0, \"byteOffset\": 48", "{\"buffer\": 4, \"byteOffset\": 48",
         "bufferViews[1].buffer: 4"},
        {"\"byteOffset\": 48,", "\"byteOffset\": 48, \"byteStride\": 8,",
         "accessors[1]: byteStride 8"},
        {"\"byteOffset\": 48,", "\"byteOffset\": 48, \"byteStride\": 16,",
         "accessors[1]: 4 elements"},
        {"\"mesh\": 0", "\"mesh\": 1", "nodes[0].mesh: 1 does not"},
        {"\"camera\": 0", "\"camera\": 3", "nodes[1].camera: 3 does not"},
        {"\"nodes\": [0, 1]", "\"nodes\": [0, 5]", "scenes[0].nodes[1]: 5"},
        {"\"nodes\": [0, 1]", "\"nodes\": [0, -1]", "scenes[0].nodes[1]: -1"},
        {"\"nodes\": [0, 1]", "\"nodes\": [0, 0]", "scenes[0].nodes[1]: node 0 is named twice"},
        {"\"scene\": 0", "\"scene\": 2", "scene: 2 does not"},
        {"\"mesh\": 0", "\"mesh\": 0, \"children\": [0]", "nodes[0]: is its own descendant"},
        {"\"mesh\": 0", "\"mesh\": 0, \"children\": [8]", "nodes[0].children[0]: 8"},
        {"\"mesh\": 0", "\"mesh\": 0, \"matrix\": [1, 2, 3]", "nodes[0].matrix: has 3 elements"},
        {"\"mesh\": 0", "\"mesh\": 0, \"matrix\": [1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1]",
         "nodes[0].matrix: is not affine"},
        {"\"mesh\": 0", "\"mesh\": 0, \"scale\": [1, 2]", "nodes[0].scale: has 2 elements"},
        {"\"mesh\": 0", "\"mesh\": 0, \"rotation\": [0, 0, 0, 0]", "nodes[0].rotation"},
        {"\"mesh\": 0", "\"mesh\": 0, \"translation\": [1e300, 0, 0]", "nodes[0]: places a vertex"},
        {"\"mesh\": 0", "\"mesh\": 0, \"scale\": [1e300, 1e300, 1]", "nodes[0]: places a vertex"},
        {"\"yfov\": 0.8", "\"yfov\": 0", "cameras[0].perspective.yfov"},
        {"\"yfov\": 0.8", "\"yfov\": 3.2", "cameras[0].perspective.yfov"},
        {"[0.5, 0.5, 3]", "[0.5, 0.5, 3], \"scale\": [0, 0, 0]", "nodes[1]: its transform"},
        {"{\"version\": \"2.0\"}", "{\"version\": \"1.0\"}", "asset.version: '1.0'"},
        {"\"scene\": 0,", "\"extensionsRequired\": [\"VENDOR_strange\\nthing\"], \"scene\": 0,",
         "extensionsRequired[0]: needs VENDOR_strange;thing"},
        {"\"indices\": 2", "\"indices\": 2, \"extensions\": {\"KHR_draco_mesh_compression\": {}}",
         "meshes[0].primitives[0].extensions.KHR_draco_mesh_compression.bufferView: is missing"},
        {"\"byteOffset\": 48,",
         "\"byteOffset\": 48, \"extensions\": {\"EXT_meshopt_compression\": {}},",
         "bufferViews[1].extensions.EXT_meshopt_compression.buffer: is missing"},
        {"{\"byteLength\": 108}", "{\"byteLength\": 10800}", "buffers[0].byteLength: 10800"},
        {"\"meshes\"", "\"ignored\"", "nodes[0].mesh: 0 does not exist"},
    };
    for (const Broken& each : cases)
        EXPECT_CONTAINS(refusal(glb(replaced(kSquare, each.from, each.to), square_bytes())),
                        each.element);
}

TEST_F(Gltf, broken_bytes_are_refused_with_their_element) {
    std::vector<float> corners = kCorners;
    corners[4] = std::nanf("");
    EXPECT_CONTAINS(refusal(glb(kSquare, square_bytes(corners))),
                    "meshes[0].primitives[0].attributes.POSITION: element 1 is not finite");
    std::vector<float> normals = kNormals;
    normals[11] = std::numeric_limits<float>::infinity();
    EXPECT_CONTAINS(refusal(glb(kSquare, square_bytes(kCorners, normals))),
                    "attributes.NORMAL: element 3 is not finite");
    EXPECT_CONTAINS(refusal(glb(kSquare, square_bytes(kCorners, kNormals, {0, 1, 2, 0, 2, 4}))),
                    "meshes[0].primitives[0].indices: index 5 names vertex 4, there are 4");
}

TEST_F(Gltf, other_contents_are_refused) {
    const std::string good = glb(kSquare, square_bytes());
    for (const size_t length : {0u, 3u, 4u, 12u, 19u, 20u, 200u, 1000u})
        EXPECT_FALSE(refusal(good.substr(0, length)).empty()) << length;
    EXPECT_CONTAINS(refusal("v 0 0 0\nv 1 0 0\n", "a.obj"), "not a glTF 2.0 file");
    EXPECT_CONTAINS(refusal("{}", "a.gltf"), "asset: is missing");
    EXPECT_CONTAINS(refusal("{\"asset\": {\"version\": \"2.0\"}}", "a.gltf"), "no triangles");
    EXPECT_CONTAINS(refusal("{\"asset\": " + std::string(100000, '['), "a.gltf"), "nested deeper");
    // Brackets in strings are not nesting.
    EXPECT_EQ(load_square("\"square\"", "\"" + std::string(500, '[') + "\\\"\"").triangle_count(),
              2u);
    EXPECT_CONTAINS(error_of([&] { load_gltf(folder_ / "absent.glb"); }), "absent.glb");
    EXPECT_CONTAINS(error_of([&] { load_gltf(folder_); }), "folder");
}

TEST_F(Gltf, deep_hierarchies_and_many_parents) {
    const auto chain = [&](int depth) {
        std::string nodes;
        for (int i = 2; i < depth; ++i)
            nodes += fmt::format(R"(, {{"children": [{}]}})", i + 1);
        nodes += R"(, {"mesh": 0})";
        const std::string json = replaced(kSquare, R"({"name": "square", "mesh": 0})",
                                          R"({"name": "square", "children": [2]})");
        return replaced(json, "[0.5, 0.5, 3]}", "[0.5, 0.5, 3]}" + nodes);
    };
    EXPECT_EQ(load(glb(chain(1000), square_bytes())).triangle_count(), 2u);
    EXPECT_CONTAINS(refusal(glb(chain(100000), square_bytes())), "deeper than 1024 levels");
    const std::string twice = replaced(chain(10), "\"children\": [3]}", "\"children\": [3, 3]}");
    EXPECT_CONTAINS(refusal(glb(twice, square_bytes())), "node 3");
    // Two ways to each of 60 nodes are 2^60 ways to the last.
    std::string paths = "{\"asset\": {\"version\": \"2.0\"}, \"nodes\": [";
    for (int i = 0; i < 60; ++i)
        paths += fmt::format(R"({{"children": [{}, {}]}}, {{"children": [{}, {}]}}, )", 2 * i + 2,
                             2 * i + 3, 2 * i + 2, 2 * i + 3);
    EXPECT_CONTAINS(refusal(paths + "{}, {}]}", "a.gltf"), "nodes[");
}

TEST_F(Gltf, random_damage_is_refused_or_harmless) {
    const std::string json = kSquare;
    const std::string file = glb(json, square_bytes());
    std::mt19937 random(11);
    int refused = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        std::string damaged = file;
        for (uint32_t change = 0; change < 1 + random() % 4; ++change) {
            const size_t at = random() % damaged.size();
            // Digits mostly, so that the JSON often stays well-formed.
            damaged[at] = random() % 3 && std::isdigit(static_cast<unsigned char>(file[at]))
                              ? static_cast<char>('0' + random() % 10)
                              : static_cast<char>(random());
        }
        try {
            expect_sound(load(damaged));
        } catch (const Error&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 1000);
    EXPECT_LT(refused, 3000);
}

} // namespace
} // namespace romascope
