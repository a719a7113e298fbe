// SPDX-License-Identifier: MIT
#include "renderer/image/text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace romascope {
namespace {

/// Pixels that are drawn, and the box around them.
struct Ink {
    int pixels = 0, left = 1 << 20, right = -1, top = 1 << 20, bottom = -1;
};

Ink ink_of(const Image& image) {
    Ink ink;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (image.at(x, y, 0) != 0.0f) {
                ++ink.pixels;
                ink.left = std::min(ink.left, x);
                ink.right = std::max(ink.right, x);
                ink.top = std::min(ink.top, y);
                ink.bottom = std::max(ink.bottom, y);
            }
    return ink;
}

Image drawn(const std::string& text, int x = 0, int y = 0, int scale = 1) {
    Image image(200, 60, 3);
    draw_text(image, x, y, text, scale, 0.5f);
    return image;
}

TEST(Text, lies_in_its_box) {
    for (const std::string text : {"Hg|", "MAE 0.0407", "@#{}~", "jyq_"}) {
        const Ink ink = ink_of(drawn(text, 10, 20));
        EXPECT_GT(ink.pixels, 20) << text;
        EXPECT_GE(ink.left, 10) << text;
        EXPECT_LT(ink.right, 10 + text_width(text, 1)) << text;
        EXPECT_GE(ink.top, 20) << text;
        EXPECT_LT(ink.bottom, 20 + kTextLine) << text;
    }
}

TEST(Text, letters_differ_and_all_of_ascii_is_there) {
    std::vector<std::vector<float>> seen;
    for (int c = '!'; c < 127; ++c) {
        const Image image = drawn(std::string(1, static_cast<char>(c)));
        EXPECT_GT(ink_of(image).pixels, 0) << c;
        if (c == '|')
            continue; // looks like an l
        for (const std::vector<float>& other : seen)
            EXPECT_NE(image.data, other) << c;
        seen.push_back(image.data);
    }
    EXPECT_EQ(ink_of(drawn("   ")).pixels, 0);
}

TEST(Text, scale_makes_each_pixel_a_square) {
    const Image small = drawn("Abc 3"), large = drawn("Abc 3", 0, 0, 3);
    for (int y = 0; y < 15; ++y)
        for (int x = 0; x < 50; ++x)
            for (int i = 0; i < 9; ++i)
                ASSERT_EQ(large.at(3 * x + i % 3, 3 * y + i / 3, 1), small.at(x, y, 1));
    EXPECT_EQ(text_width("Abc 3", 3), 3 * text_width("Abc 3", 1));
}

TEST(Text, other_characters_are_question_marks) {
    EXPECT_EQ(drawn("a\xc3\xa4z\n").data, drawn("a?z?").data);
    EXPECT_EQ(text_width("\xe2\x82\xac", 2), text_width("?", 2));
    EXPECT_EQ(drawn("\x7f").data, drawn("?").data);
}

TEST(Text, is_cut_off_at_the_edges) {
    Image image(20, 6, 1);
    draw_text(image, -4, -3, "a long text that goes beyond", 2, 1.0f);
    EXPECT_GT(ink_of(image).pixels, 0);
    draw_text(image, 1000, 1000, "far away", 1, 1.0f);
}

TEST(Text, what_does_not_fit_ends_in_dots) {
    EXPECT_EQ(text_that_fits("short", 1, 100), "short");
    const std::string cut = text_that_fits("a text that is a little too long", 2, 150);
    EXPECT_TRUE(cut.starts_with("a text") && cut.ends_with("...")) << cut;
    EXPECT_LE(text_width(cut, 2), 150);
    EXPECT_GT(text_width(cut, 2), 120);
    EXPECT_EQ(text_that_fits("x", 4, 3), "");
}

} // namespace
} // namespace romascope
