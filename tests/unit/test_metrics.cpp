// SPDX-License-Identifier: MIT
#include "renderer/image/color.h"
#include "renderer/metrics/color_maps.h"
#include "renderer/metrics/compare.h"
#include "renderer/metrics/errors.h"
#include "renderer/metrics/flicker.h"
#include "renderer/metrics/flip.h"
#include "tests/support/expect_error.h"
#include "tests/support/made_images.h"

#include <cmath>
#include <limits>

namespace romascope {
namespace {

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

TEST(Flicker, IsTheChangeThatTheTruthDoesNotExplain) {
    Flicker still, moving, first;
    first.add(flat(2, 1, {0.5f}), flat(2, 1, {0.25f}));
    EXPECT_EQ(first.value(), 0.0) << "of one frame";
    for (const float value : {0.25f, 0.75f, 0.5f}) // changes of 0.5 and 0.25, whatever the error
        still.add(flat(2, 1, {1.0f}), flat(2, 1, {value}));
    EXPECT_DOUBLE_EQ(still.value(), 0.375);
    for (const float value : {0.25f, 0.75f, 0.5f}) // follows the truth, an eighth behind
        moving.add(flat(2, 1, {value}), flat(2, 1, {value - 0.125f}));
    EXPECT_DOUBLE_EQ(moving.value(), 0.0);
    moving.add(flat(2, 1, {1.0f}), flat(2, 1, {0.5f}));
    EXPECT_DOUBLE_EQ(moving.value(), 0.375 / 3);
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
    EXPECT_CONTAINS(error_of([] { error_figures(Image(4, 3, 1), Image(4, 2, 1)); }), "4x2");
    Image bad(5, 4, 1);
    bad.at(3, 2, 0) = -std::numeric_limits<float>::infinity();
    const std::string text = error_of([&] { error_figures(Image(5, 4, 3), bad); });
    EXPECT_CONTAINS(text, "test image holds infinity");
    EXPECT_CONTAINS(text, "(3, 2)");
    EXPECT_CONTAINS(error_of([&] { difference_map(bad, Image(5, 4, 3)); }), "reference image");
}

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

TEST(Compare, NamesAndValuesAgree) {
    for (const MetricInfo& info : metric_table()) {
        EXPECT_EQ(metric_from_name(info.name), info.metric);
        EXPECT_STREQ(metric_name(info.metric), info.name);
    }
    const std::string text = error_of([] { metric_from_name("rsme"); });
    EXPECT_CONTAINS(text, "'rmse'?");
    EXPECT_CONTAINS(text, "flip, rmse, mae, bias");
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
