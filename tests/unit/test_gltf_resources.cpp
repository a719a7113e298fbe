// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/resources.h"
#include "tests/support/gltf_document_fixture.h"

#include <fmt/format.h>

#include <sys/stat.h>

namespace romascope::gltf {
namespace {

using GltfResources = GltfDocument;

constexpr size_t kPlenty = size_t{1} << 30;

TEST_F(GltfResources, data_uris) {
    const std::string text = base64(square_bytes());
    for (const std::string& uri :
         {"data:application/octet-stream;base64," + text, "data:;base64," + text,
          "data:application/gltf-buffer;charset=x;base64," + text + "QUJD"})
        EXPECT_EQ(bytes_of_view(*open(with_uri(uri)), 0), bytes_of(kCorners));
    // Percent-encoded, as base64 or as bytes.
    std::string encoded, raw;
    for (const char c : text)
        encoded += c == '+' ? "%2B" : c == '/' ? "%2f" : c == '=' ? "%3D" : std::string(1, c);
    for (const char c : square_bytes())
        raw += fmt::format("%{:02x}", static_cast<unsigned char>(c));
    EXPECT_EQ(bytes_of_view(*open(with_uri("data:;base64," + encoded)), 0), bytes_of(kCorners));
    EXPECT_EQ(bytes_of_view(*open(with_uri("data:application/octet-stream," + raw)), 2),
              square_bytes().substr(96));
}

TEST_F(GltfResources, broken_data_uris) {
    const std::string text = base64(square_bytes());
    EXPECT_CONTAINS(refusal(with_uri("data:;base64," + text.substr(0, 40) + "!" + text.substr(41))),
                    "buffers[0].uri: character 40 of its data is no base64");
    EXPECT_CONTAINS(refusal(with_uri("data:;base64," + text.substr(0, 100))),
                    "buffers[0].uri: holds 75 bytes instead of 108");
    EXPECT_CONTAINS(refusal(with_uri("data:;base64," + text.substr(0, 101))), "is cut off");
    EXPECT_CONTAINS(refusal(with_uri("data:;base64")),
                    "buffers[0].uri: a data URI without a comma");
    const std::string huge = replaced(with_uri("data:;base64," + text), "\"byteLength\": 108",
                                      "\"byteLength\": 1099511627776");
    EXPECT_CONTAINS(refusal(huge), "holds 108 bytes instead of 1099511627776");
}

TEST_F(GltfResources, external_buffers) {
    for (const char* name : {"da ta.bin", "per%25cent.bin", "\xc3\xa4.bin"})
        write_file_atomically(folder_ / "asset" / name, square_bytes() + "and more");
    fs::create_directories(folder_ / "asset" / "sub");
    fs::create_symlink("../da ta.bin", folder_ / "asset" / "sub" / "link.bin");
    for (const char* uri : {"da%20ta.bin", "da ta.bin", "per%2525cent.bin", "per%25cent.bin",
                            "%C3%A4.bin", "./sub/../da%20ta.bin", "sub/link.bin"})
        EXPECT_EQ(bytes_of_view(*open(with_uri(uri)), 0), bytes_of(kCorners)) << uri;
}

TEST_F(GltfResources, paths_stay_in_the_folder_of_the_asset) {
    write_file_atomically(folder_ / "outside.bin", square_bytes());
    fs::create_symlink(folder_ / "outside.bin", folder_ / "asset" / "link.bin");
    fs::create_symlink("..", folder_ / "asset" / "up");
    write_file_atomically(folder_ / "asset_2" / "near.bin", square_bytes());
    fs::create_symlink("/dev/zero", folder_ / "asset" / "zero.bin");
    ASSERT_EQ(mkfifo((folder_ / "asset" / "pipe.bin").c_str(), 0600), 0);
    const std::string absolute = (folder_ / "asset" / "a.bin").string();
    const std::vector<std::pair<std::string, const char*>> cases = {
        {"../outside.bin", "lies outside the folder"},
        {"%2e%2E/outside.bin", "lies outside the folder"},
        {"..%2foutside.bin", "lies outside the folder"},
        {"sub/../../outside.bin", "lies outside the folder"},
        {"../asset_2/near.bin", "lies outside the folder"},
        {"link.bin", "lies outside the folder"},
        {"up/outside.bin", "lies outside the folder"},
        {"zero.bin", "lies outside the folder"},
        {"/dev/zero", "absolute path"},
        {"%2Fdev%2Fzero", "absolute path"},
        {absolute, "absolute path"},
        {"file:///dev/zero", "no relative path"},
        {"http://example.com/a.bin", "no relative path"},
        {"pipe.bin", "not a plain file"},
        {".", "not a plain file"},
        {"missing.bin", "there is no file 'missing.bin'"},
        {"a%00b", "is no path"},
        {"`touch poc`", "there is no file"},
        {"$(touch poc)", "there is no file"},
        {std::string(5000, 'x'), "buffers[0].uri: '"},
    };
    for (const auto& [uri, message] : cases) {
        const std::string text = refusal(with_uri(uri));
        EXPECT_CONTAINS(text, message);
        EXPECT_EQ(text.rfind("buffers[0].uri: ", 0), 0u) << text;
    }
    EXPECT_FALSE(fs::exists("poc"));
}

TEST_F(GltfResources, external_buffers_that_are_too_short_or_too_large) {
    write_file_atomically(folder_ / "asset" / "short.bin", square_bytes().substr(1));
    EXPECT_CONTAINS(refusal(with_uri("short.bin")),
                    "buffers[0].uri: 'short.bin' has 107 bytes instead of 108");
    write_file_atomically(folder_ / "asset" / "a.bin", square_bytes());
    const std::string content = with_uri("a.bin");
    budget_ = MemoryBudget(kPlenty);
    const size_t needed = [&] {
        const auto document = open(content);
        return budget_.taken();
    }();
    EXPECT_EQ(budget_.taken(), 0u); // given back
    EXPECT_GE(needed, content.size() + 108);
    // All that is read is counted before: the file, what its JSON becomes, the buffer.
    budget_ = MemoryBudget(content.size() - 1);
    EXPECT_CONTAINS(refusal(content), "the file: needs");
    fs::resize_file(folder_ / "asset" / "a.bin", size_t{1} << 40); // sparse: takes no room
    budget_ = MemoryBudget(kPlenty);
    EXPECT_CONTAINS(
        refusal(replaced(content, "\"byteLength\": 108", "\"byteLength\": 1099511627776")),
        "buffers[0].uri: needs");
}

TEST_F(GltfResources, buffers_without_data_are_refused_only_if_read) {
    EXPECT_CONTAINS(refusal(kSquare),
                    "accessors[0].bufferView: reads buffers[0], which has no data");
    EXPECT_CONTAINS(refusal(glb(kSquare, "")), "accessors[0].bufferView: reads buffers[0]");
    EXPECT_NO_THROW(open_square("\"buffers\": [{\"byteLength\": 108}",
                                "\"buffers\": [{\"byteLength\": 108}, {\"byteLength\": 1e12}"));
    EXPECT_CONTAINS(
        refusal(
            glb(replaced(replaced(kSquare, "{\"buffer\": 0, \"byteOffset\": 0,", "{\"buffer\": 1,"),
                         "\"buffers\": [{\"byteLength\": 108}",
                         "\"buffers\": [{\"byteLength\": 108}, {\"byteLength\": 48}"),
                square_bytes())),
        "accessors[0].bufferView: reads buffers[1], which has no data");
}

TEST_F(GltfResources, images_come_encoded) {
    write_file_atomically(folder_ / "asset" / "a b.png", std::string("picture"));
    const std::string json = replaced(
        kSquare, "\"scene\": 0,",
        R"("images": [{"uri": "a%20b.png", "name": "first"}, {"bufferView": 2, "mimeType": "image/png"},
                     {"uri": "data:image/png;base64,QUJD"}, {"uri": "none.png"},
                     {"uri": "../a.png"}, {"uri": "data:image/png;base64,Q"}],)");
    const auto document = open(glb(json, square_bytes()));
    const auto text = [&](int image) {
        const auto bytes = document->image(image);
        return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    };
    EXPECT_EQ(document->model().images[0].name, "first");
    EXPECT_EQ(text(0), "picture");
    EXPECT_EQ(text(1), square_bytes().substr(96));
    EXPECT_EQ(text(2), "ABC");
    EXPECT_CONTAINS(error_of([&] { document->image(3); }), "images[3].uri: there is no file");
    EXPECT_CONTAINS(error_of([&] { document->image(4); }),
                    "images[4].uri: '../a.png' lies outside");
    EXPECT_CONTAINS(error_of([&] { document->image(5); }), "images[5].uri: its base64 data");
    const size_t before = budget_.taken();
    document->image(0);
    EXPECT_EQ(budget_.taken(), before + 7);
}

TEST(PercentDecoding, of_uris) {
    EXPECT_EQ(percent_decoded("a%20b%2Fc%c3%a4"), "a b/c\xc3\xa4");
    EXPECT_EQ(percent_decoded("100%"), "100%");
    EXPECT_EQ(percent_decoded("%2"), "%2");
    EXPECT_EQ(percent_decoded("%zz%41"), "%zzA");
}

} // namespace
} // namespace romascope::gltf
