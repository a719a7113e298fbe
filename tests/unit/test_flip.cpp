// SPDX-License-Identifier: MIT
#include "renderer/image/color.h"
#include "renderer/image/image_io.h"
#include "renderer/metrics/flip.h"
#include "tests/support/expect_error.h"
#include "tests/support/made_images.h"
#include "tests/support/slow_flip.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <unistd.h>

namespace romascope {
namespace {

Image mirrored(const Image& image) {
    Image result(image.width, image.height, image.channels);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < image.channels; ++c)
                result.at(x, y, c) = image.at(image.width - 1 - x, y, c);
    return result;
}

/// The limits are those within which implementations of FLIP differ by float rounding alone.
void expect_as_slow(const Image& reference, const Image& test, float p = kDefaultPixelsPerDegree) {
    const FlipResult fast = flip(reference, test, p);
    const std::vector<double> map =
        slow::flip({reference.width, reference.height}, slow::picture(reference),
                   slow::picture(test), static_cast<double>(p));
    ASSERT_EQ(fast.map.data.size(), map.size());
    double mean = 0;
    for (size_t i = 0; i < map.size(); ++i) {
        ASSERT_NEAR(fast.map.data[i], map[i], 2e-4) << "pixel " << i;
        mean += map[i] / static_cast<double>(map.size());
    }
    EXPECT_NEAR(fast.mean, mean, 1e-5);
}

// The means in the next three tests are the FLIP authors' program's.

TEST(Flip, BlackAgainstWhite) {
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 30}, {30, 1}, {64, 48}})
        EXPECT_NEAR(flip(flat(width, height, {0}), flat(width, height, {1})).mean, 0.967388332,
                    2e-5);
}

TEST(Flip, GreenAgainstBlue) {
    EXPECT_NEAR(flip(flat(32, 32, {0, 1, 0}), flat(32, 32, {0, 0, 1})).mean, 1, 1e-6);
}

TEST(Flip, OneStepOfGreyInEightBitFiles) {
    const auto folder =
        std::filesystem::temp_directory_path() / ("romascope-metrics-" + std::to_string(getpid()));
    write_image(folder / "a.png", flat(32, 32, {decode_srgb8(128)}));
    write_image(folder / "b.png", flat(32, 32, std::vector<float>(3, decode_srgb8(129))));
    const double mean = flip(read_image(folder / "a.png"), read_image(folder / "b.png")).mean;
    std::filesystem::remove_all(folder);
    EXPECT_NEAR(mean, 0.029863086, 2e-5);
}

TEST(Flip, AsTheSlowOneOnNoise) {
    expect_as_slow(random_image(40, 30, 3, 1), random_image(40, 30, 3, 2));
    expect_as_slow(random_image(40, 30, 1, 3), random_image(40, 30, 3, 4));
}

TEST(Flip, AsTheSlowOneOnSmallChanges) {
    const Image reference = random_image(40, 30, 3, 5);
    Image test = reference;
    std::mt19937 random(6);
    for (float& v : test.data)
        v += std::uniform_real_distribution<float>(-0.02f, 0.02f)(random);
    expect_as_slow(reference, test);
}

TEST(Flip, AsTheSlowOneOnEdgesAndDots) {
    Image reference = flat(40, 30, {0.6f, 0.5f, 0.1f}), test = reference;
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x) {
            if (x + 2 * y > 50)
                reference.at(x, y, 0) = test.at(x, y, 2) = 1;
            if (x == 11 && y == 7)
                test.at(x, y, 1) = 0;
        }
    expect_as_slow(reference, test);
    expect_as_slow(test, reference);
}

TEST(Flip, AsTheSlowOneOnPicturesSmallerThanItsFilters) {
    unsigned seed = 10;
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 17}, {17, 1}, {3, 2}, {9, 25}}) {
        expect_as_slow(random_image(width, height, 3, seed),
                       random_image(width, height, 3, seed + 1));
        seed += 2;
    }
}

TEST(Flip, AsTheSlowOneAtOtherDistances) {
    const Image reference = random_image(25, 20, 3, 30), test = random_image(25, 20, 3, 31);
    for (const float p : {1.0f, 5.0f, 20.0f, 100.0f})
        expect_as_slow(reference, test, p);
}

TEST(Flip, EqualPicturesAreZeroEverywhere) {
    const Image image = random_image(31, 17, 3, 40);
    const FlipResult result = flip(image, image);
    EXPECT_EQ(result.mean, 0);
    for (const float v : result.map.data)
        EXPECT_EQ(v, 0);
}

TEST(Flip, ChangeIsSeenOnlyAroundIt) {
    const Image reference = random_image(60, 5, 3, 41);
    Image test = reference;
    test.at(20, 2, 1) = 1 - test.at(20, 2, 1);
    const Image map = flip(reference, test).map;
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 60; ++x)
            if (std::abs(x - 20) > 10) {
                EXPECT_EQ(map.at(x, y, 0), 0) << x;
            }
    EXPECT_GT(map.at(20, 2, 0), 0.05f);
}

TEST(Flip, ExchangingOrMirroringBothChangesNothing) {
    const Image a = random_image(33, 21, 3, 42), b = random_image(33, 21, 3, 43);
    const FlipResult result = flip(a, b);
    EXPECT_EQ(flip(b, a).map.data, result.map.data);
    const Image mirror = mirrored(flip(mirrored(a), mirrored(b)).map);
    for (size_t i = 0; i < mirror.data.size(); ++i)
        EXPECT_NEAR(mirror.data[i], result.map.data[i], 1e-4f);
}

TEST(Flip, GreyIsThreeEqualChannelsAndRangeIsClamped) {
    const Image grey = random_image(20, 10, 1, 44, -0.5f, 1.5f),
                other = random_image(20, 10, 3, 45);
    Image rgb(20, 10, 3), clamped(20, 10, 1);
    for (size_t i = 0; i < grey.data.size(); ++i) {
        rgb.data[3 * i] = rgb.data[3 * i + 1] = rgb.data[3 * i + 2] = grey.data[i];
        clamped.data[i] = std::min(std::max(grey.data[i], 0.0f), 1.0f);
    }
    const Image map = flip(grey, other).map;
    EXPECT_EQ(map.channels, 1);
    EXPECT_EQ(flip(rgb, other).map.data, map.data);
    EXPECT_EQ(flip(clamped, other).map.data, map.data);
}

TEST(Flip, RefusesWhatItCannotCompare) {
    const std::string sizes = error_of([] { flip(Image(4, 3, 1), Image(3, 4, 3)); });
    EXPECT_CONTAINS(sizes, "4x3 with 1 channel");
    EXPECT_CONTAINS(sizes, "3x4 with 3 channels");
    EXPECT_CONTAINS(error_of([] { flip(Image(), Image()); }), "0x0");
    Image bad(4, 3, 3);
    bad.at(2, 1, 0) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_CONTAINS(error_of([&] { flip(bad, Image(4, 3, 3)); }), "reference image holds NaN");
    EXPECT_CONTAINS(error_of([&] { flip(Image(4, 3, 3), bad); }), "test image holds NaN");
    EXPECT_CONTAINS(error_of([&] { flip(Image(4, 3, 3), bad); }), "(2, 1)");
    for (const float p : {0.0f, -1.0f, 1e6f, std::numeric_limits<float>::quiet_NaN()})
        EXPECT_CONTAINS(error_of([&] { flip(Image(1, 1, 1), Image(1, 1, 1), p); }),
                        "pixels per degree");
}

} // namespace
} // namespace romascope
