// SPDX-License-Identifier: MIT
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/image/color.h"
#include "renderer/image/image_io.h"

#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <stb/stb_image_write.h>
#include <string>
#include <unistd.h>

namespace romascope {
namespace {

namespace fs = std::filesystem;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A folder of its own for each test, removed afterwards.
class ImageFile : public testing::Test {
protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() /
                  ("romascope-image-" + std::string(test->name()) + std::to_string(getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path file(const std::string& name) const { return folder_ / name; }
    fs::path store(const std::string& name, const std::string& bytes) const {
        write_file_atomically(file(name), bytes);
        return file(name);
    }
    size_t files_in_folder() const {
        return static_cast<size_t>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

    fs::path folder_;
};

/// The text of the Error that `action` throws, empty if it throws none.
template <class Action>
std::string error_of(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "one line";
        return error.what();
    }
    return {};
}

void expect_contains(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << "'" << text << "' lacks '" << part << "'";
}

Image random_image(int width, int height, int channels, float low, float high) {
    std::mt19937 random(static_cast<unsigned>(width * 100 + height * 10 + channels));
    std::uniform_real_distribution<float> value(low, high);
    Image image(width, height, channels);
    for (float& v : image.data)
        v = value(random);
    return image;
}

std::vector<uint8_t> encoded(const Image& image) {
    std::vector<uint8_t> bytes;
    for (const float v : image.data)
        bytes.push_back(encode_srgb8(v));
    return bytes;
}

void append(void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<size_t>(size));
}

std::string big_endian(uint32_t value) {
    return {static_cast<char>(value >> 24), static_cast<char>(value >> 16),
            static_cast<char>(value >> 8), static_cast<char>(value)};
}

/// A PNG of rows that begin with their filter byte; stored, not compressed, without checksums
/// (which the reader does not look at).
std::string plain_png(uint32_t width, uint32_t height, char bits, char color_type,
                      const std::string& rows) {
    const auto chunk = [](const std::string& type, const std::string& data) {
        return big_endian(static_cast<uint32_t>(data.size())) + type + data + big_endian(0);
    };
    const auto low = [](size_t v) { return static_cast<char>(v & 255); };
    const std::string length = {low(rows.size()), low(rows.size() >> 8), low(~rows.size()),
                                low(~rows.size() >> 8)};
    return "\x89PNG\r\n\x1a\n" +
           chunk("IHDR", big_endian(width) + big_endian(height) + bits + color_type +
                             std::string(3, '\0')) +
           chunk("IDAT", "\x78\x01\x01" + length + rows + big_endian(0)) + chunk("IEND", "");
}

TEST(Color, ThresholdsAreWhereTheCodeChanges) {
    EXPECT_EQ(srgb8_thresholds()[0], 0.0f);
    for (int code = 1; code < 256; ++code) {
        const float threshold = srgb8_thresholds()[static_cast<size_t>(code)];
        EXPECT_EQ(encode_srgb8(threshold), code);
        EXPECT_EQ(encode_srgb8(std::nextafter(threshold, 0.0f)), code - 1);
    }
}

TEST(Color, KnownValues) {
    EXPECT_FLOAT_EQ(encode_srgb(0), 0);
    EXPECT_FLOAT_EQ(encode_srgb(1), 1);
    EXPECT_FLOAT_EQ(encode_srgb(0.5f), 0.735356983f);
    EXPECT_FLOAT_EQ(encode_srgb(0.002f), 0.02584f); // the straight piece
    EXPECT_FLOAT_EQ(decode_srgb(0.5f), 0.214041140f);
    EXPECT_FLOAT_EQ(decode_srgb(0.04f), 0.04f / 12.92f);
    EXPECT_EQ(encode_srgb8(0.214041140f), 128); // 127.5 and a little
    EXPECT_EQ(encode_srgb8(0.18f), 118);
}

TEST(Color, BothWaysAreInverse) {
    for (int i = 0; i <= 10000; ++i) {
        const float value = static_cast<float>(i) / 10000;
        EXPECT_NEAR(decode_srgb(encode_srgb(value)), value, 3e-7f);
    }
    for (int i = 0; i < 256; ++i)
        EXPECT_EQ(encode_srgb8(decode_srgb8(static_cast<uint8_t>(i))), i);
}

TEST(Color, EightBitsAreTheNearest) {
    int previous = 0;
    for (int i = 0; i <= 100000; ++i) {
        const float value = static_cast<float>(i) / 100000;
        const int code = encode_srgb8(value);
        EXPECT_LE(std::abs(static_cast<float>(code) / 255 - encode_srgb(value)), 0.5001f / 255);
        EXPECT_GE(code, previous);
        previous = code;
    }
}

TEST(Color, OutOfRangeIsClamped) {
    EXPECT_EQ(encode_srgb8(-1), 0);
    EXPECT_EQ(encode_srgb8(2), 255);
    EXPECT_EQ(encode_srgb8(kInfinity), 255);
    EXPECT_EQ(encode_srgb8(-kInfinity), 0);
    EXPECT_EQ(encode_srgb8(kNan), 0);
}

TEST_F(ImageFile, PngKeepsEightBitsExactly) {
    for (const int channels : {1, 3}) {
        const Image image = random_image(37, 23, channels, -0.2f, 1.2f);
        write_image(file("a.png"), image);
        const Image read = read_image(file("a.png"));
        ASSERT_EQ(read.width, 37);
        ASSERT_EQ(read.height, 23);
        ASSERT_EQ(read.channels, channels);
        EXPECT_EQ(encoded(read), encoded(image));
        for (size_t i = 0; i < read.data.size(); ++i)
            ASSERT_EQ(read.data[i], decode_srgb8(encode_srgb8(image.data[i])));
        write_image(file("b.png"), read);
        EXPECT_EQ(read_text_file(file("a.png")), read_text_file(file("b.png")));
    }
}

TEST_F(ImageFile, RowsStartAtTheTop) {
    Image image(1, 2, 1);
    image.at(0, 0, 0) = 1;
    for (const char* name : {"a.png", "a.hdr"}) {
        write_image(file(name), image);
        EXPECT_EQ(read_image(file(name)).at(0, 0, 0), 1) << name;
        EXPECT_EQ(read_image(file(name)).at(0, 1, 0), 0) << name;
    }
}

TEST_F(ImageFile, ReadsSixteenBits) {
    const std::string rows = std::string("\0\x80\x00\xff\xff", 5) + std::string("\0\0\1\0\0", 5);
    const Image image = read_image(store("a.png", plain_png(2, 2, 16, 0, rows)));
    ASSERT_EQ(image.channels, 1);
    EXPECT_FLOAT_EQ(image.at(0, 0, 0), decode_srgb(32768 / 65535.0f));
    EXPECT_FLOAT_EQ(image.at(1, 0, 0), 1);
    EXPECT_FLOAT_EQ(image.at(0, 1, 0), 1 / 65535.0f / 12.92f);
    EXPECT_FLOAT_EQ(image.at(1, 1, 0), 0);
}

TEST_F(ImageFile, DropsAlpha) {
    const uint8_t rgba[] = {10, 20, 30, 0, 40, 50, 60, 128};
    std::string bytes;
    stbi_write_png_to_func(append, &bytes, 2, 1, 4, rgba, 8);
    EXPECT_EQ(encoded(read_image(store("rgba.png", bytes))),
              (std::vector<uint8_t>{10, 20, 30, 40, 50, 60}));
    bytes.clear();
    stbi_write_png_to_func(append, &bytes, 4, 1, 2, rgba, 8);
    const Image grey = read_image(store("grey_alpha.png", bytes));
    EXPECT_EQ(grey.channels, 1);
    EXPECT_EQ(encoded(grey), (std::vector<uint8_t>{10, 30, 40, 60}));
}

TEST_F(ImageFile, ReadsJpeg) {
    const std::vector<uint8_t> pixels(16 * 16 * 3, 100);
    std::string bytes;
    stbi_write_jpg_to_func(append, &bytes, 16, 16, 3, pixels.data(), 95);
    for (const uint8_t code : encoded(read_image(store("a.jpg", bytes))))
        EXPECT_NEAR(code, 100, 2);
    expect_contains(
        error_of([&] { read_image(store("cut.jpg", bytes.substr(0, bytes.size() - 9))); }),
        "no end marker");
}

TEST_F(ImageFile, HdrIsWithinItsPrecisionAndUnbiased) {
    // Wide enough and too narrow for run-length coding; values over 80 binary orders.
    for (const int width : {40, 5}) {
        Image image = random_image(width, 50, 3, -40, 40);
        for (float& v : image.data)
            v = std::exp2(v);
        image.data[0] = image.data[1] = image.data[2] = 0;
        write_image(file("a.hdr"), image);
        const Image read = read_image(file("a.hdr"));
        ASSERT_EQ(read.data.size(), image.data.size());
        double bias = 0;
        for (size_t i = 0; i < read.data.size(); i += 3) {
            const float largest = std::max({image.data[i], image.data[i + 1], image.data[i + 2]});
            for (size_t c = i; c < i + 3; ++c)
                ASSERT_LE(std::abs(read.data[c] - image.data[c]), largest / 255) << c;
            if (largest > 0 && largest == image.data[i])
                bias += static_cast<double>(read.data[i] / largest) - 1;
        }
        // Cutting off instead of rounding would give -0.0027 on average.
        EXPECT_LT(std::abs(bias) / (width * 50 / 3.0), 6e-4);
        write_image(file("b.hdr"), read);
        EXPECT_EQ(read_text_file(file("a.hdr")), read_text_file(file("b.hdr")));
    }
}

TEST_F(ImageFile, HdrRoundsUpToTheNextPowerOfTwo) {
    Image image(1, 1, 3);
    image.data = {0.9999f, 0.5f, 0.2f};
    write_image(file("a.hdr"), image);
    const Image read = read_image(file("a.hdr"));
    EXPECT_EQ(read.data[0], 1);
    EXPECT_EQ(read.data[1], 0.5f);
    EXPECT_NEAR(read.data[2], 0.2f, 1 / 256.0f);
}

TEST_F(ImageFile, HdrOfGreyAndOfValuesItCannotHold) {
    Image image(10, 1, 1);
    image.data = {0.25f, kNan, -1, kInfinity, 3e38f, 1, 2, 3, 1e-37f, 1e30f};
    write_image(file("a.HDR"), image);
    const Image read = read_image(file("a.HDR"));
    ASSERT_EQ(read.channels, 3);
    const float largest = 255 * std::exp2(119.0f);
    const float expected[] = {0.25f, 0, 0, largest, largest, 1, 2, 3, 0, 1e30f};
    for (size_t i = 0; i < 30; ++i)
        EXPECT_NEAR(read.data[i], expected[i / 3], expected[i / 3] / 256) << i;
    EXPECT_EQ(read.data[0], 0.25f);
    EXPECT_EQ(read.data[9], largest);
}

TEST_F(ImageFile, ExtensionsAreCheckedEarlyWhateverTheirCase) {
    EXPECT_NO_THROW(check_image_extension("a.png"));
    EXPECT_NO_THROW(check_image_extension("x.y/a.Png"));
    EXPECT_NO_THROW(check_image_extension("a.HDR"));
    for (const char* name : {"a.jpg", "a", "a.png.txt", "png", ".png", ""}) {
        const std::string text = error_of([&] { check_image_extension(name); });
        expect_contains(text, ".png or .hdr");
        expect_contains(text, name);
    }
    expect_contains(error_of([&] { write_image(file("a.exr"), Image(1, 1, 1)); }), "a.exr");
    EXPECT_EQ(files_in_folder(), 0u);
}

TEST_F(ImageFile, RefusesEmptyImages) {
    expect_contains(error_of([&] { write_image(file("a.png"), Image()); }), "0x0");
    expect_contains(error_of([&] { write_image(file("a.png"), Image(2, 2, 4)); }), "4 channels");
    EXPECT_EQ(files_in_folder(), 0u);
}

TEST_F(ImageFile, FailedWritesLeaveNothing) {
    // A file in the place of the parent folder, and a folder in the place of the file: root, too,
    // cannot write these.
    store("file", "text");
    const fs::path below_file = file("file") / "a.png";
    expect_contains(error_of([&] { write_image(below_file, Image(1, 1, 1)); }),
                    below_file.string());
    fs::create_directories(file("folder.png") / "inside");
    expect_contains(error_of([&] { write_image(file("folder.png"), Image(1, 1, 1)); }),
                    "folder.png");
    EXPECT_EQ(files_in_folder(), 2u);
    EXPECT_EQ(read_text_file(file("file")), "text");
}

TEST_F(ImageFile, MakesMissingFolders) {
    write_image(file("new/folder/a.png"), Image(1, 1, 1));
    EXPECT_TRUE(fs::exists(file("new/folder/a.png")));
}

TEST_F(ImageFile, UnreadableFilesAreNamed) {
    expect_contains(error_of([&] { read_image(file("missing.png")); }), "missing.png");
    expect_contains(error_of([&] { read_image(folder_); }), "folder");
    expect_contains(error_of([&] { read_image(store("empty.png", "")); }), "the file is empty");
    const std::string text =
        error_of([&] { read_image(store("text.png", "This is a text of some length, no PNG.")); });
    expect_contains(text, "text.png");
    expect_contains(text, "not a .png, .jpg or .hdr");
    expect_contains(error_of([&] {
                        read_image(store("huge.hdr", "#?RADIANCE\n"
                                                     "FORMAT=32-bit_rle_rgbe\n\n"
                                                     "-Y 20000 +X 20000\n"));
                    }),
                    "cut off or damaged");
}

TEST_F(ImageFile, EveryCutOffFileIsRefused) {
    const Image image = random_image(12, 3, 3, 0, 1);
    Image flat(12, 3, 3); // long runs
    for (const char* name : {"a.png", "a.hdr"}) {
        for (const Image* source : {&image, static_cast<const Image*>(&flat)}) {
            write_image(file(name), *source);
            const std::string whole = read_text_file(file(name));
            // The reader does not ask for a PNG's last 4 bytes, the checksum of an empty chunk.
            const size_t tail = name == std::string("a.png") ? 4 : 0;
            for (size_t size = 0; size + tail < whole.size(); ++size)
                ASSERT_NE(error_of([&] { read_image(store("cut", whole.substr(0, size))); }), "")
                    << name << " " << size << " of " << whole.size();
        }
    }
}

TEST_F(ImageFile, DamagedFilesAreReadOrRefusedButNeverHang) {
    std::mt19937 random(1);
    const Image image = random_image(12, 5, 3, 0, 1);
    for (const char* name : {"a.png", "a.hdr"}) {
        write_image(file(name), image);
        const std::string whole = read_text_file(file(name));
        for (int i = 0; i < 500; ++i) {
            std::string damaged = whole;
            // Behind the signature and the size, which only say "not a picture" or ask for memory.
            const size_t start = name == std::string("a.png") ? 33 : whole.find("+X 12") + 6;
            for (int change = 0; change < 3; ++change)
                damaged[start + random() % (whole.size() - start)] = static_cast<char>(random());
            try {
                EXPECT_EQ(read_image(store("damaged", damaged)).width, 12);
            } catch (const Error&) {
            }
        }
    }
}

} // namespace
} // namespace romascope
