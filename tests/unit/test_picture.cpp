// SPDX-License-Identifier: MIT
// Decoding of pictures that a scene brings along.
#include "renderer/base/error.h"
#include "renderer/image/picture.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <stb/stb_image_write.h>

#include <cstring>
#include <random>

namespace romascope {
namespace {

void append(void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<size_t>(size));
}

std::string png(int width, int height, int channels, const std::vector<uint8_t>& samples) {
    std::string bytes;
    stbi_write_png_to_func(append, &bytes, width, height, channels, samples.data(),
                           width * channels);
    return bytes;
}

std::string jpeg(int width, int height, const std::vector<uint8_t>& samples) {
    std::string bytes;
    stbi_write_jpg_to_func(append, &bytes, width, height, 3, samples.data(), 95);
    return bytes;
}

/// A PNG that says it has another size. Its checksums are not right; nobody asks.
std::string resized(std::string png, int width, int height) {
    for (size_t i = 0; i < 4; ++i) {
        png[16 + i] = static_cast<char>(width >> (24 - 8 * i) & 0xff);
        png[20 + i] = static_cast<char>(height >> (24 - 8 * i) & 0xff);
    }
    return png;
}

Picture decode(const std::string& bytes, MemoryBudget& budget) {
    return decode_picture(std::as_bytes(std::span(bytes)), "images[3]", budget);
}

/// The text of the Error, empty if there is none; `limit` in bytes.
std::string refusal(const std::string& bytes, size_t limit = size_t{1} << 32) {
    MemoryBudget budget(limit);
    try {
        decode(bytes, budget);
    } catch (const Error& error) {
        EXPECT_EQ(error.exit_status(), kBadInput);
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        return error.what();
    }
    return {};
}

std::vector<uint8_t> noise(size_t count) {
    std::mt19937 random(7);
    std::vector<uint8_t> samples(count);
    for (uint8_t& sample : samples)
        sample = static_cast<uint8_t>(random());
    return samples;
}

TEST(Picture, PngOfAnyChannelsAsFour) {
    for (int channels = 1; channels <= 4; ++channels) {
        const std::vector<uint8_t> samples = noise(static_cast<size_t>(5 * 3 * channels));
        MemoryBudget budget(1 << 20);
        const Picture picture = decode(png(5, 3, channels, samples), budget);
        ASSERT_EQ(picture.width, 5);
        ASSERT_EQ(picture.height, 3);
        EXPECT_EQ(budget.taken(), 5u * 3u * 4u); // what decoding took besides is given back
        for (size_t i = 0; i < 15; ++i) {
            const uint8_t* at = &samples[i * static_cast<size_t>(channels)];
            const bool grey = channels < 3;
            const uint32_t alpha = channels % 2 == 0 ? at[channels - 1] : 255;
            const uint32_t expected = at[0] | static_cast<uint32_t>(at[grey ? 0 : 1]) << 8 |
                                      static_cast<uint32_t>(at[grey ? 0 : 2]) << 16 | alpha << 24;
            EXPECT_EQ(picture.texels[i], expected) << channels << " channels, texel " << i;
        }
    }
}

TEST(Picture, JpegIsOpaque) {
    MemoryBudget budget(1 << 20);
    const Picture picture = decode(jpeg(16, 8, std::vector<uint8_t>(16 * 8 * 3, 100)), budget);
    EXPECT_EQ(picture.texels.size(), 16u * 8u);
    for (const uint32_t texel : picture.texels) {
        EXPECT_EQ(texel >> 24, 255u);
        EXPECT_NEAR(texel & 255u, 100.0, 2.0); // quality 95 of one colour
    }
}

TEST(Picture, WhatIsNotOneIsNamed) {
    EXPECT_EQ(refusal(""), "images[3]: the picture is empty");
    EXPECT_EQ(refusal("RIFF....WEBPVP8 "), "images[3]: not a PNG or JPEG picture");
    // stb_image alone would read these two.
    EXPECT_EQ(refusal("P5\n2 2\n255\nabcd"), "images[3]: not a PNG or JPEG picture");
    EXPECT_EQ(refusal("GIF89a\1\0\1\0\0\0\0"), "images[3]: not a PNG or JPEG picture");
}

TEST(Picture, SizesAreCheckedBeforeAnythingIsDecoded) {
    const std::string small = png(10, 10, 1, std::vector<uint8_t>(100));
    EXPECT_NE(refusal(resized(small, 16385, 1)).find("at most 16384 a side"), std::string::npos);
    EXPECT_NE(refusal(resized(small, 16384, 16384)).find("pixels are missing"), std::string::npos);
    EXPECT_NE(refusal(resized(small, 0, 4)), "");
    EXPECT_NE(refusal(resized(small, -4, 4)), "");
    // Height and width of a JPEG stand behind its frame header, five bytes in.
    std::string wide = jpeg(16, 16, noise(16 * 16 * 3));
    const size_t frame = wide.find("\xff\xc0");
    ASSERT_NE(frame, wide.npos);
    wide.replace(frame + 5, 4, "\x40\x00\x40\x00", 4);
    EXPECT_NE(refusal(wide).find("pixels are missing"), std::string::npos);
}

TEST(Picture, MoreThanTheLimitIsRefused) {
    const std::string bytes = png(100, 100, 4, noise(40000));
    EXPECT_NE(refusal(bytes, 60000).find("images[3]: needs "), std::string::npos);
    EXPECT_EQ(refusal(bytes, 1 << 20), "");
}

TEST(Picture, StreamsThatInflateBeyondTheirSizeAreRefusedBefore) {
    const std::string large = png(8192, 8192, 1, std::vector<uint8_t>(size_t{8192} * 8192));
    EXPECT_NE(refusal(resized(large, 64, 64), 4 << 20).find("its stream"), std::string::npos);
    // The same check lets a good one pass.
    EXPECT_EQ(refusal(png(2048, 2048, 1, std::vector<uint8_t>(2048 * 2048)), 44 << 20), "");
}

TEST(Picture, EveryCutOffPictureIsRefused) {
    for (const std::string& whole : {png(12, 3, 3, noise(108)), jpeg(12, 3, noise(108))})
        for (size_t size = 0; size < whole.size() - 1; ++size)
            ASSERT_NE(refusal(whole.substr(0, size)), "") << size << " of " << whole.size();
}

TEST(Picture, DamagedOnesAreDecodedOrRefused) {
    std::mt19937 random(3);
    for (const std::string& whole : {png(12, 5, 4, noise(240)), jpeg(12, 5, noise(180))})
        for (int i = 0; i < 1000; ++i) {
            std::string damaged = whole;
            for (int change = 0; change < 3; ++change)
                damaged[random() % whole.size()] = static_cast<char>(random());
            MemoryBudget budget(1 << 24);
            try {
                const Picture picture = decode(damaged, budget);
                EXPECT_EQ(picture.texels.size(),
                          static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height));
            } catch (const Error&) {
            }
        }
}

TEST(Picture, EndlessJpegScansAreRefused) {
    std::string bytes = jpeg(8, 8, noise(192));
    const size_t scan = bytes.find("\xff\xda");
    std::string header = bytes.substr(scan, 14);
    for (int i = 0; i < 200; ++i)
        bytes.insert(scan, header);
    EXPECT_NE(refusal(bytes).find("scans"), std::string::npos);
}

} // namespace
} // namespace romascope
