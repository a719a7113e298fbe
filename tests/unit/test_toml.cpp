// SPDX-License-Identifier: MIT
// Settings from TOML and back.
#include "renderer/base/files.h"
#include "tests/support/sample_knobs.h"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <unistd.h>

namespace romascope {
namespace {

std::string load_error(std::string_view toml) {
    Settings settings(knobs());
    settings.set(kResolution, 77);
    const Settings before = settings;
    const std::string text = expect_error([&] { settings.load_toml_text(toml, "f.toml"); });
    EXPECT_EQ(settings, before) << toml;
    return text;
}

TEST(Toml, SetsWhatTheFileGives) {
    Settings settings(knobs());
    settings.set(kCamera, "kept");
    settings.load_toml_text(R"(# dotted keys, tables, tables in tables
ao.radius = 2            # an integer for a real
[occupancy]
resolution = 64
[reuse]
antialias = true
taa.blend = 0.25
[roma]
sampling = "snap"
[view]
)",
                            "f.toml");
    Settings expected(knobs());
    expected.set(kCamera, "kept");
    expected.set(kRadius, 2.0);
    expected.set(kResolution, 64);
    expected.set(kAntialias, true);
    expected.set(kBlend, 0.25);
    expected.set(kSampling, Sampling::snap);
    EXPECT_EQ(settings, expected);
    settings.load_toml_text("", "empty");
    EXPECT_EQ(settings, expected);
    settings.load_toml_text("[reuse.taa]\nblend = 1\n", "f.toml");
    EXPECT_EQ(settings.get(kBlend), 1.0);
}

TEST(Toml, InfinityAndNan) {
    Settings settings(knobs());
    settings.load_toml_text("ao = { bias = -inf, radius = inf }", "f.toml");
    EXPECT_EQ(settings.get(kBias), -kInfinity);
    EXPECT_EQ(settings.get(kRadius), kInfinity);
    EXPECT_EQ(load_error("ao.bias = nan"),
              "f.toml:1: setting 'ao.bias' cannot be 'nan': it takes a number");
    EXPECT_CONTAINS(load_error("ao.radius = -inf"), "cannot be '-inf'");
    EXPECT_CONTAINS(load_error("reuse.taa.blend = inf"), "0 to 1");
}

TEST(Toml, ErrorsNameFileLineAndKey) {
    EXPECT_EQ(load_error("# comment\n[occupancy]\nresolution = 16\n"),
              "f.toml:3: setting 'occupancy.resolution' cannot be '16': it takes a whole number, "
              "32 to 256 (cells)");
    EXPECT_EQ(load_error("[occupancy]\n\nresolutoin = 64\n"),
              "f.toml:3: unknown setting 'occupancy.resolutoin': did you mean "
              "'occupancy.resolution'?");
    EXPECT_EQ(load_error("\n[ocupancy]\nresolution = 64\n"),
              "f.toml:3: unknown setting 'ocupancy.resolution': did you mean "
              "'occupancy.resolution'?");
    EXPECT_EQ(load_error("radius = 64\n"),
              "f.toml:1: unknown setting 'radius': did you mean 'ao.radius'?");
    EXPECT_CONTAINS(load_error("\n\n[nothing]\n"), "f.toml:3: unknown setting 'nothing'");
    EXPECT_CONTAINS(load_error("roma.sampling = 'snip'"), "did you mean 'snap'?");
}

TEST(Toml, TypesAreNotGuessed) {
    for (const char* value : {"64.0", "64.5", "'64'", "true", "1979-05-27", "[64]", "{}"})
        EXPECT_CONTAINS(load_error("occupancy.resolution = " + std::string(value)),
                        "f.toml:1: setting 'occupancy.resolution' cannot be ")
            << value;
    for (const char* value : {"1", "'true'", "1.0"})
        EXPECT_CONTAINS(load_error("reuse.antialias = " + std::string(value)), "cannot be ");
    for (const char* value : {"1", "true", "1.0"})
        EXPECT_CONTAINS(load_error("view.camera = " + std::string(value)), "cannot be ");
    EXPECT_CONTAINS(load_error("ao.radius = '1'"), "cannot be ");
    EXPECT_CONTAINS(load_error("ao.radius = [1]"), "a list");
    EXPECT_CONTAINS(load_error("[ao.radius]\n"), "a table");
    EXPECT_CONTAINS(load_error("ao = 1"), "unknown setting 'ao'");
    EXPECT_CONTAINS(load_error("[[ao]]\nradius = 1"), "unknown setting 'ao'");
    EXPECT_CONTAINS(load_error("[ao.radius]\nx = 1\n"), "unknown setting 'ao.radius.x'");
}

TEST(Toml, SyntaxErrors) {
    for (const char* text :
         {"\n\nao.radius = ", "\n\nao.radius = 1 2", "\n\n[ao\nradius = 1", "\n\nao.radius = 'x\n",
          "\n\nao.radius = 1\n\xff", "\n\nao.bias = 99999999999999999999"})
        EXPECT_EQ(load_error(text).substr(0, 7), "f.toml:") << text;
    EXPECT_TRUE(load_error("\n\nao.radius = 1 2\n").starts_with("f.toml:3: "));
    EXPECT_TRUE(load_error("ao.radius = 1\nao.radius = 2\n").starts_with("f.toml:2: "));
    EXPECT_CONTAINS(load_error("ao.radius = 1\n'ao.radius' = 2\n"),
                    "f.toml:2: setting 'ao.radius' is given twice");
}

TEST(Toml, TheFirstMistakeIsReported) {
    EXPECT_TRUE(load_error("[view]\ncamera = 1\n[ao]\nradius = -1\n").starts_with("f.toml:2: "));
}

TEST(Toml, AllOrNothing) {
    // load_error compares the settings before and after.
    EXPECT_NE(load_error("[occupancy]\nresolution = 64\n[ao]\nradius = -1\n"), "");
    EXPECT_NE(load_error("ao.radius = 1\nreuse.antialias = true\nzzz = 1\n"), "");
    EXPECT_NE(load_error("ao.radius = 1\nocupancy = ["), "");
}

TEST(Toml, Files) {
    std::string path = testing::TempDir() + "romascope-settings-XXXXXX";
    const int descriptor = mkstemp(path.data());
    ASSERT_GE(descriptor, 0);
    close(descriptor);
    write_file_atomically(path, "[ao]\nradius = 3.5\n");
    Settings settings(knobs());
    settings.load_toml(path);
    EXPECT_EQ(settings.get(kRadius), 3.5);
    write_file_atomically(path, "[ao]\nradius = -1\n");
    EXPECT_TRUE(expect_error([&] { settings.load_toml(path); }).starts_with(path + ":2: setting"));
    std::filesystem::remove(path);
    EXPECT_CONTAINS(expect_error([&] { settings.load_toml(path); }), "cannot read " + path);
    EXPECT_EQ(settings.get(kRadius), 3.5);
}

TEST(Toml, WritesCommentsInTables) {
    const KnobTable table({&kResolution, &kSampling, &kRadius, &kBias});
    Settings settings(table);
    settings.set(kBias, 3);
    EXPECT_EQ(settings.to_toml(),
              "[occupancy]\n"
              "# Cells along the longest side. (32 to 256 cells; default 128)\n"
              "resolution = 128\n"
              "\n"
              "[roma]\n"
              "# How rays are drawn. (snap | candidates | a-trous; default \"candidates\")\n"
              "sampling = \"candidates\"\n"
              "\n"
              "[ao]\n"
              "# Reach of a ray. (at least 0 m; default inf)\n"
              "radius = inf\n"
              "# Any number. (any number; default 0.1)\n"
              "bias = 3.0\n");
}

/// Doubles of every size: random bits, but no NaN.
double any_real(std::mt19937_64& random) {
    double value = 0;
    do
        value = std::bit_cast<double>(random());
    while (std::isnan(value));
    return value;
}

/// Text with quotes, backslashes, control characters, and characters of 1 to 4 bytes.
std::string any_text(std::mt19937_64& random) {
    const std::string pieces[] = {"a",
                                  "\"",
                                  "'",
                                  "\\",
                                  "\n",
                                  "\r\n",
                                  "\t",
                                  "'''",
                                  "\x7f",
                                  "#",
                                  "\x01",
                                  "=",
                                  "\xc3\xa9",
                                  "\"\"\"",
                                  " ",
                                  "\\u",
                                  "\b",
                                  "\f",
                                  "\x1b",
                                  "]",
                                  "\xe2\x82\xac",
                                  "\xf0\x9f\x98\x80"};
    std::string text;
    for (size_t n = random() % 12; n > 0; --n)
        text += pieces[random() % std::size(pieces)];
    if (random() % 8 == 0)
        text += '\0';
    return text;
}

Settings any_settings(std::mt19937_64& random) {
    Settings settings(knobs());
    settings.set(kResolution, 32 + static_cast<int>(random() % 225));
    settings.set(kRadius, random() % 4 ? std::abs(any_real(random)) : kInfinity);
    settings.set(kBias, any_real(random));
    settings.set(kBlend, static_cast<double>(random() >> 11) * 0x1p-53);
    settings.set(kAntialias, random() % 2 == 0);
    settings.set(kCamera, any_text(random));
    settings.set(kSampling, static_cast<Sampling>(random() % 3));
    settings.set(kSeed, static_cast<int64_t>(random() >> 11) * (random() % 2 ? 1 : -1));
    return settings;
}

TEST(Toml, WhatIsWrittenLoadsBack) {
    std::mt19937_64 random(3);
    for (int i = 0; i < 2000; ++i) {
        const Settings settings = any_settings(random);
        const std::string toml = settings.to_toml();
        Settings loaded = any_settings(random);
        ASSERT_NO_THROW(loaded.load_toml_text(toml, "f.toml")) << toml;
        ASSERT_EQ(loaded, settings) << toml;
        // == does not tell 0 from -0.
        ASSERT_EQ(std::signbit(loaded.get(kBias)), std::signbit(settings.get(kBias)));
        ASSERT_EQ(loaded.to_toml(), toml);
    }
}

TEST(Toml, EveryControlCharacterLoadsBack) {
    for (int c = 0; c < 128; ++c) {
        Settings settings(knobs());
        settings.set(kCamera, std::string(1, static_cast<char>(c)));
        Settings loaded(knobs());
        ASSERT_NO_THROW(loaded.load_toml_text(settings.to_toml(), "f.toml")) << c;
        EXPECT_EQ(loaded, settings) << c;
    }
}

TEST(Toml, AwkwardRealsLoadBackToTheBit) {
    for (const double value :
         {0.1, 1.0 / 3.0, -0.0, 0.0, 5e-324, 2.2250738585072014e-308, 1e22, 1e23,
          std::numeric_limits<double>::max(), 9007199254740993.0, 128.0, kInfinity, -kInfinity}) {
        Settings settings(knobs());
        settings.set(kBias, value);
        Settings loaded(knobs());
        loaded.set(kBias, 7.0);
        loaded.load_toml_text(settings.to_toml(), "f.toml");
        EXPECT_EQ(std::bit_cast<uint64_t>(loaded.get(kBias)), std::bit_cast<uint64_t>(value));
        loaded.set_text("ao.bias", to_text(value));
        EXPECT_EQ(std::bit_cast<uint64_t>(loaded.get(kBias)), std::bit_cast<uint64_t>(value));
    }
}

} // namespace
} // namespace romascope
