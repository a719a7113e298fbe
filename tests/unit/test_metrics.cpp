// SPDX-License-Identifier: MIT
#include "renderer/base/error.h"
#include "renderer/image/color.h"
#include "renderer/image/image_io.h"
#include "renderer/metrics/color_maps.h"
#include "renderer/metrics/compare.h"
#include "renderer/metrics/errors.h"
#include "renderer/metrics/flip.h"

#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <string>
#include <unistd.h>

namespace romascope {
namespace {

/// The text of the Error that `action` throws, empty if it throws none.
template <class Action>
std::string error_of(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        EXPECT_EQ(error.exit_status(), kBadInput);
        return error.what();
    }
    return {};
}

void expect_contains(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << "'" << text << "' lacks '" << part << "'";
}

Image flat(int width, int height, std::vector<float> color) {
    Image image(width, height, static_cast<int>(color.size()));
    for (size_t i = 0; i < image.data.size(); ++i)
        image.data[i] = color[i % color.size()];
    return image;
}

Image random_image(int width, int height, int channels, unsigned seed, float low = 0,
                   float high = 1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(low, high);
    Image image(width, height, channels);
    for (float& v : image.data)
        v = value(random);
    return image;
}

Image mirrored(const Image& image) {
    Image result(image.width, image.height, image.channels);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < image.channels; ++c)
                result.at(x, y, c) = image.at(image.width - 1 - x, y, c);
    return result;
}

// ---- FLIP a second time: slow, in double precision, with whole two-dimensional kernels, straight
// ---- from the published equations. Shares nothing with the library's.

namespace slow {

constexpr double kPi = 3.14159265358979323846;

struct Color {
    double a, b, c;
};
using Picture = std::vector<Color>;
using Weights = std::vector<std::vector<double>>; // [j + radius][i + radius]

struct Size {
    int width, height;
    size_t clamped(int x, int y) const {
        x = x < 0 ? 0 : x >= width ? width - 1 : x;
        y = y < 0 ? 0 : y >= height ? height - 1 : y;
        return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
    }
};

Color xyz_over_white(Color rgb) {
    return {(10135552 * rgb.a + 8788810 * rgb.b + 4435075 * rgb.c) / 24577794 * 1.052156925,
            (2613072 * rgb.a + 8788810 * rgb.b + 887015 * rgb.c) / 12288897,
            (1425312 * rgb.a + 8788810 * rgb.b + 70074185 * rgb.c) / 73733382 * 0.918357670};
}

Color opponent(Color rgb) {
    const Color n = xyz_over_white(rgb);
    return {116 * n.b - 16, 500 * (n.a - n.b), 200 * (n.b - n.c)};
}

Color opponent_to_clamped_rgb(Color o) {
    const double y = (o.a + 16) / 116;
    const double X = (y + o.b / 500) * 0.950428545, Z = (y - o.c / 200) * 1.088900371;
    const auto unit = [](double v) { return v < 0 ? 0 : v > 1 ? 1 : v; };
    return {unit(3.241003275 * X - 1.537398934 * y - 0.498615861 * Z),
            unit(-0.969224334 * X + 1.875930071 * y + 0.041554224 * Z),
            unit(0.055639423 * X - 0.204011202 * y + 1.057148933 * Z)};
}

Color hunt_lab(Color rgb) {
    const auto f = [](double t) {
        const double d = 6.0 / 29;
        return t > d * d * d ? std::cbrt(t) : t / (3 * d * d) + 4.0 / 29;
    };
    const Color n = xyz_over_white(rgb);
    const double L = 116 * f(n.b) - 16;
    return {L, 0.01 * L * 500 * (f(n.a) - f(n.b)), 0.01 * L * 200 * (f(n.b) - f(n.c))};
}

double hyab(Color p, Color q) { return std::abs(p.a - q.a) + std::hypot(p.b - q.b, p.c - q.c); }

Weights contrast_kernel(double p, double a1, double b1, double a2, double b2) {
    const int r = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * p));
    Weights weights;
    double sum = 0;
    for (int j = -r; j <= r; ++j) {
        weights.emplace_back();
        for (int i = -r; i <= r; ++i) {
            const double z = (i * i + j * j) / (p * p);
            weights.back().push_back(a1 * std::sqrt(kPi / b1) * std::exp(-kPi * kPi * z / b1) +
                                     a2 * std::sqrt(kPi / b2) * std::exp(-kPi * kPi * z / b2));
            sum += weights.back().back();
        }
    }
    for (auto& row : weights)
        for (double& w : row)
            w /= sum;
    return weights;
}

/// `order` 1: edge, 2: point; along x.
Weights feature_kernel(double p, int order) {
    const double s = 0.5 * 0.082 * p;
    const int r = static_cast<int>(std::ceil(3 * s));
    std::vector<double> g, d;
    double g_sum = 0, positive = 0, negative = 0;
    for (int i = -r; i <= r; ++i) {
        g.push_back(std::exp(-i * i / (2 * s * s)));
        d.push_back((order == 1 ? -i : i * i / (s * s) - 1) * g.back());
        g_sum += g.back();
        (d.back() > 0 ? positive : negative) += d.back();
    }
    Weights weights;
    for (const double gy : g) {
        weights.emplace_back();
        for (const double dx : d)
            weights.back().push_back(gy / g_sum * dx / (dx > 0 ? positive : -negative));
    }
    return weights;
}

template <class Value>
double correlate(Size size, int x, int y, const Weights& weights, bool transposed,
                 const Value& value) {
    const int r = static_cast<int>(weights.size()) / 2;
    double sum = 0;
    for (int j = -r; j <= r; ++j)
        for (int i = -r; i <= r; ++i) {
            const auto row = static_cast<size_t>((transposed ? i : j) + r);
            const auto column = static_cast<size_t>((transposed ? j : i) + r);
            sum += weights[row][column] * value(size.clamped(x + i, y + j));
        }
    return sum;
}

std::vector<double> flip(Size size, const Picture& reference, const Picture& test, double p) {
    const Weights ky = contrast_kernel(p, 1, 0.0047, 0, 1e-5);
    const Weights kx = contrast_kernel(p, 1, 0.0053, 0, 1e-5);
    const Weights kz = contrast_kernel(p, 34.1, 0.04, 13.5, 0.025);
    const Weights edge = feature_kernel(p, 1), point = feature_kernel(p, 2);
    const double cmax = std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), 0.7);
    const Picture* pictures[2] = {&reference, &test};
    Picture opponents[2];
    for (int k = 0; k < 2; ++k)
        for (const Color& rgb : *pictures[k])
            opponents[k].push_back(opponent(rgb));

    std::vector<double> map;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            Color lab[2];
            double edges[2], points[2];
            for (int k = 0; k < 2; ++k) {
                const Picture& o = opponents[k];
                const auto luma = [&](size_t i) { return (o[i].a + 16) / 116; };
                lab[k] = hunt_lab(opponent_to_clamped_rgb(
                    {correlate(size, x, y, ky, false, [&](size_t i) { return o[i].a; }),
                     correlate(size, x, y, kx, false, [&](size_t i) { return o[i].b; }),
                     correlate(size, x, y, kz, false, [&](size_t i) { return o[i].c; })}));
                edges[k] = std::hypot(correlate(size, x, y, edge, false, luma),
                                      correlate(size, x, y, edge, true, luma));
                points[k] = std::hypot(correlate(size, x, y, point, false, luma),
                                       correlate(size, x, y, point, true, luma));
            }
            const double d = std::pow(hyab(lab[0], lab[1]), 0.7), knee = 0.4 * cmax;
            const double color =
                d < knee ? d * 0.95 / knee : 0.95 + (d - knee) / (cmax - knee) * 0.05;
            const double feature =
                std::sqrt(std::max(std::abs(edges[0] - edges[1]), std::abs(points[0] - points[1])) /
                          std::sqrt(2.0));
            map.push_back(std::pow(color, 1 - feature));
        }
    }
    return map;
}

Picture picture(const Image& image) {
    Picture result;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto channel = [&](int c) {
                const double v = image.at(x, y, image.channels == 1 ? 0 : c);
                return v < 0 ? 0 : v > 1 ? 1 : v;
            };
            result.push_back({channel(0), channel(1), channel(2)});
        }
    return result;
}

} // namespace slow

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
    expect_contains(sizes, "4x3 with 1 channel");
    expect_contains(sizes, "3x4 with 3 channels");
    expect_contains(error_of([] { flip(Image(), Image()); }), "0x0");
    Image bad(4, 3, 3);
    bad.at(2, 1, 0) = std::numeric_limits<float>::quiet_NaN();
    expect_contains(error_of([&] { flip(bad, Image(4, 3, 3)); }), "reference image holds NaN");
    expect_contains(error_of([&] { flip(Image(4, 3, 3), bad); }), "test image holds NaN");
    expect_contains(error_of([&] { flip(Image(4, 3, 3), bad); }), "(2, 1)");
    for (const float p : {0.0f, -1.0f, 1e6f, std::numeric_limits<float>::quiet_NaN()})
        expect_contains(error_of([&] { flip(Image(1, 1, 1), Image(1, 1, 1), p); }),
                        "pixels per degree");
}

// ---- Errors

TEST(Errors, AnalyticCase) {
    Image reference(2, 1, 3), test(2, 1, 3);
    reference.data = {1, 2, 3, 4, 5, 6};
    test.data = {2, 2, 0, 4, 5, 7}; // differences 1 0 -3 0 0 1
    const ErrorFigures figures = error_figures(reference, test);
    EXPECT_DOUBLE_EQ(figures.rmse, std::sqrt(11.0 / 6));
    EXPECT_DOUBLE_EQ(figures.mae, 5.0 / 6);
    EXPECT_DOUBLE_EQ(figures.bias, -1.0 / 6);
    EXPECT_DOUBLE_EQ(figures.max_abs, 3);
    EXPECT_EQ(difference_map(reference, test).data, (std::vector<float>{1, 0, -3, 0, 0, 1}));
}

TEST(Errors, ConstantOffset) {
    const ErrorFigures figures = error_figures(flat(9, 7, {0.5f}), flat(9, 7, {0.25f}));
    EXPECT_DOUBLE_EQ(figures.rmse, 0.25);
    EXPECT_DOUBLE_EQ(figures.mae, 0.25);
    EXPECT_DOUBLE_EQ(figures.bias, -0.25);
    EXPECT_DOUBLE_EQ(figures.max_abs, 0.25);
}

TEST(Errors, GreyAgainstColor) {
    const Image grey = flat(3, 2, {0.5f}), color = flat(3, 2, {0.5f, 1, 0.75f});
    const ErrorFigures figures = error_figures(grey, color);
    EXPECT_DOUBLE_EQ(figures.bias, 0.25);
    EXPECT_DOUBLE_EQ(figures.max_abs, 0.5);
    EXPECT_DOUBLE_EQ(error_figures(color, grey).bias, -0.25);
    EXPECT_EQ(difference_map(grey, color).channels, 3);
    EXPECT_EQ(difference_map(color, grey).at(1, 1, 2), -0.25f);
    EXPECT_EQ(difference_map(grey, grey).channels, 1);
}

TEST(Errors, PropertiesOnNoise) {
    const Image a = random_image(50, 40, 3, 50, -2, 5), b = random_image(50, 40, 3, 51, -2, 5);
    const ErrorFigures ab = error_figures(a, b), ba = error_figures(b, a);
    EXPECT_DOUBLE_EQ(ab.rmse, ba.rmse);
    EXPECT_DOUBLE_EQ(ab.mae, ba.mae);
    EXPECT_DOUBLE_EQ(ab.bias, -ba.bias);
    EXPECT_LE(std::abs(ab.bias), ab.mae);
    EXPECT_LE(ab.mae, ab.rmse);
    EXPECT_LE(ab.rmse, ab.max_abs);
    // Two uniform variables over 7: the variance of their difference is 49 / 6.
    EXPECT_NEAR(ab.rmse, std::sqrt(49 / 6.0), 0.1);
    EXPECT_EQ(error_figures(a, a).rmse, 0);
}

TEST(Errors, RefusesWhatItCannotCompare) {
    expect_contains(error_of([] { error_figures(Image(4, 3, 1), Image(4, 2, 1)); }), "4x2");
    Image bad(5, 4, 1);
    bad.at(3, 2, 0) = -std::numeric_limits<float>::infinity();
    const std::string text = error_of([&] { error_figures(Image(5, 4, 3), bad); });
    expect_contains(text, "test image holds infinity");
    expect_contains(text, "(3, 2)");
    expect_contains(error_of([&] { difference_map(bad, Image(5, 4, 3)); }), "reference image");
}

// ---- Pictures of errors

std::vector<int> srgb_of(const Image& image, int x) {
    return {encode_srgb8(image.at(x, 0, 0)), encode_srgb8(image.at(x, 0, 1)),
            encode_srgb8(image.at(x, 0, 2))};
}

TEST(ColorMaps, Magma) {
    Image map(5, 1, 1);
    map.data = {0, 0.5f, 1, 7, -1};
    const Image picture = flip_heatmap(map);
    EXPECT_EQ(srgb_of(picture, 0), (std::vector<int>{0, 0, 4}));
    EXPECT_EQ(srgb_of(picture, 1), (std::vector<int>{183, 55, 121})); // entry 128
    EXPECT_EQ(srgb_of(picture, 2), (std::vector<int>{252, 253, 191}));
    EXPECT_EQ(srgb_of(picture, 3), srgb_of(picture, 2));
    EXPECT_EQ(srgb_of(picture, 4), srgb_of(picture, 0));
    EXPECT_EQ(srgb_of(magma_picture(map, 7), 3), srgb_of(picture, 2));
}

TEST(ColorMaps, MagmaGetsBrighterAllTheWay) {
    Image map(256, 1, 1);
    for (int i = 0; i < 256; ++i)
        map.at(i, 0, 0) = static_cast<float>(i) / 255;
    const Image picture = magma_picture(map);
    for (int i = 1; i < 256; ++i) {
        const auto luminance = [&](int x) {
            return 0.2126f * picture.at(x, 0, 0) + 0.7152f * picture.at(x, 0, 1) +
                   0.0722f * picture.at(x, 0, 2);
        };
        EXPECT_GT(luminance(i), luminance(i - 1) - 1e-3f) << i;
    }
}

TEST(ColorMaps, Diverging) {
    Image map(5, 1, 1);
    map.data = {0, 2, -2, 1, -9};
    const Image picture = diverging_picture(map, 2);
    EXPECT_EQ(srgb_of(picture, 0), (std::vector<int>{255, 255, 255}));
    EXPECT_EQ(srgb_of(picture, 1), (std::vector<int>{255, 0, 0}));
    EXPECT_EQ(srgb_of(picture, 2), (std::vector<int>{0, 0, 255}));
    EXPECT_EQ(srgb_of(picture, 3), (std::vector<int>{255, 128, 128}));
    EXPECT_EQ(srgb_of(picture, 4), srgb_of(picture, 2));
}

// ---- Metrics by name

TEST(Compare, NamesAndValuesAgree) {
    for (const MetricInfo& info : metric_table()) {
        EXPECT_EQ(metric_from_name(info.name), info.metric);
        EXPECT_STREQ(metric_name(info.metric), info.name);
    }
    const std::string text = error_of([] { metric_from_name("rsme"); });
    expect_contains(text, "'rmse'?");
    expect_contains(text, "flip, rmse, mae, bias");
}

TEST(Compare, ValuesAndPictures) {
    Image reference = flat(3, 1, {0.5f, 0.5f, 0.5f}), test = reference;
    test.at(0, 0, 0) = test.at(0, 0, 1) = test.at(0, 0, 2) = 0.25f;
    test.at(2, 0, 1) = 0.8f;
    const ErrorFigures figures = error_figures(reference, test);
    EXPECT_EQ(metric_value(Metric::rmse, reference, test), figures.rmse);
    EXPECT_EQ(metric_value(Metric::mae, reference, test), figures.mae);
    EXPECT_EQ(metric_value(Metric::bias, reference, test), figures.bias);
    EXPECT_EQ(metric_value(Metric::flip, reference, test), flip(reference, test).mean);
    for (const MetricInfo& info : metric_table()) {
        const MetricPicture picture = metric_picture(info.metric, reference, test);
        EXPECT_EQ(picture.value, metric_value(info.metric, reference, test)) << info.name;
        EXPECT_EQ(picture.picture.channels, 3);
        EXPECT_FLOAT_EQ(picture.scale, info.metric == Metric::flip ? 1 : 0.25f) << info.name;
    }
    const Image bias = metric_picture(Metric::bias, reference, test).picture;
    EXPECT_EQ(srgb_of(bias, 0), (std::vector<int>{0, 0, 255})); // too dark
    EXPECT_EQ(srgb_of(bias, 1), (std::vector<int>{255, 255, 255}));
    EXPECT_EQ(srgb_of(bias, 2)[0], 255); // too bright by 0.1: 40 % of the way to red
    EXPECT_EQ(srgb_of(bias, 2)[1], 153);
    const MetricPicture equal = metric_picture(Metric::mae, reference, reference);
    EXPECT_EQ(equal.scale, 1);
    EXPECT_EQ(srgb_of(equal.picture, 1), (std::vector<int>{0, 0, 4}));
}

} // namespace
} // namespace romascope
