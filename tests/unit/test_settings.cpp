// SPDX-License-Identifier: MIT
#include "tests/support/sample_knobs.h"

#include <cmath>
#include <stdexcept>

namespace romascope {
namespace {

std::string set_error(const char* key, const char* value) {
    Settings settings(knobs());
    const std::string text = expect_error([&] { settings.set_text(key, value); });
    EXPECT_EQ(settings, Settings(knobs()));
    return text;
}

TEST(Settings, StartWithDefaults) {
    const Settings settings(knobs());
    EXPECT_EQ(settings.get(kResolution), 128);
    EXPECT_EQ(settings.get(kRadius), kInfinity);
    EXPECT_EQ(settings.get(kAntialias), false);
    EXPECT_EQ(settings.get(kCamera), "");
    EXPECT_EQ(settings.get(kSampling), Sampling::candidates);
    for (const KnobBase* knob : knobs().all()) {
        EXPECT_TRUE(settings.is_default(*knob));
        EXPECT_EQ(settings.value(*knob), knob->default_value());
    }
}

TEST(Settings, SetGetReset) {
    Settings settings(knobs());
    settings.set(kResolution, 64);
    settings.set(kRadius, 2);
    settings.set(kAntialias, true);
    settings.set(kCamera, "hall");
    settings.set(kSampling, Sampling::a_trous);
    EXPECT_EQ(settings.get(kResolution), 64);
    EXPECT_EQ(settings.get(kRadius), 2.0);
    EXPECT_EQ(settings.get(kAntialias), true);
    EXPECT_EQ(settings.get(kCamera), "hall");
    EXPECT_EQ(settings.get(kSampling), Sampling::a_trous);
    EXPECT_EQ(settings.value(kSampling), KnobValue("a-trous"));
    EXPECT_FALSE(settings.is_default(kCamera));
    EXPECT_TRUE(settings.is_default(kBias));

    const Settings copy = settings;
    EXPECT_EQ(copy, settings);
    settings.reset(kCamera);
    EXPECT_TRUE(settings.is_default(kCamera));
    EXPECT_NE(copy, settings);
    EXPECT_EQ(copy.get(kCamera), "hall");
}

TEST(Settings, OtherKnobsAreAMistake) {
    // The same key, so that only the address tells them apart.
    const Knob<int> other{{.key = "occupancy.resolution", .help = "h"}, 5, 0, 9};
    const Knob<int> unknown{{.key = "no.such", .help = "h"}, 5, 0, 9};
    Settings settings(knobs());
    EXPECT_THROW(settings.get(other), std::logic_error);
    EXPECT_THROW(settings.set(other, 3), std::logic_error);
    EXPECT_THROW(settings.get(unknown), std::logic_error);
    const KnobTable table({&other});
    EXPECT_NE(Settings(table), settings);
    const KnobTable copy = knobs();
    EXPECT_EQ(Settings(copy), settings);
}

TEST(Settings, RangesIncludeTheirEnds) {
    Settings settings(knobs());
    for (const int good : {32, 256})
        EXPECT_NO_THROW(settings.set(kResolution, good));
    for (const int bad : {31, 257, -64, std::numeric_limits<int>::max()})
        EXPECT_THROW(settings.set(kResolution, bad), Error);
    EXPECT_EQ(settings.get(kResolution), 256);

    for (const double good : {0.0, -0.0, 1.0, 5e-324})
        EXPECT_NO_THROW(settings.set(kBlend, good));
    for (const double bad : {-5e-324, std::nextafter(1.0, 2.0), kInfinity, -kInfinity, kNan})
        EXPECT_THROW(settings.set(kBlend, bad), Error);
    EXPECT_NO_THROW(settings.set(kRadius, kInfinity));
    EXPECT_THROW(settings.set(kRadius, -kInfinity), Error);
    EXPECT_NO_THROW(settings.set(kBias, -kInfinity));
    EXPECT_THROW(settings.set(kBias, kNan), Error);

    const int64_t limit = int64_t{1} << 53;
    EXPECT_NO_THROW(settings.set(kSeed, limit - 1));
    EXPECT_NO_THROW(settings.set(kSeed, 1 - limit));
    for (const int64_t bad : {limit, limit + 1, -limit, std::numeric_limits<int64_t>::max()})
        EXPECT_THROW(settings.set(kSeed, bad), Error);
    EXPECT_THROW(settings.set(kSampling, static_cast<Sampling>(3)), Error);
    EXPECT_THROW(settings.set(kSampling, static_cast<Sampling>(-1)), Error);
    EXPECT_THROW(settings.set(kCamera, "\xff"), Error);
}

TEST(Settings, SetValueTakesTheRightTypeOnly) {
    Settings settings(knobs());
    settings.set_value(kRadius, int64_t{3});
    EXPECT_EQ(settings.get(kRadius), 3.0);
    EXPECT_THROW(settings.set_value(kResolution, 64.0), Error);
    EXPECT_THROW(settings.set_value(kResolution, true), Error);
    EXPECT_THROW(settings.set_value(kAntialias, int64_t{1}), Error);
    EXPECT_THROW(settings.set_value(kCamera, true), Error);
    EXPECT_THROW(settings.set_value(kRadius, "3"), Error);
    EXPECT_THROW(settings.set_value(kSampling, int64_t{0}), Error);
}

TEST(Settings, TakesText) {
    Settings settings(knobs());
    settings.set_text("occupancy.resolution", "64");
    EXPECT_EQ(settings.get(kResolution), 64);
    settings.set_text("occupancy.resolution", " +65 ");
    EXPECT_EQ(settings.get(kResolution), 65);
    for (const auto& [text, value] : {std::pair{"0.1", 0.1},
                                      {"1e-3", 1e-3},
                                      {"2", 2.0},
                                      {"inf", kInfinity},
                                      {"-inf", -kInfinity},
                                      {".5", 0.5}}) {
        settings.set_text("ao.bias", text);
        EXPECT_EQ(settings.get(kBias), value) << text;
    }
    for (const char* text : {"true", "on", "1"}) {
        settings.reset(kAntialias);
        settings.set_text("reuse.antialias", text);
        EXPECT_TRUE(settings.get(kAntialias)) << text;
    }
    for (const char* text : {"false", "off", "0"}) {
        settings.set(kAntialias, true);
        settings.set_text("reuse.antialias", text);
        EXPECT_FALSE(settings.get(kAntialias)) << text;
    }
    settings.set_text("roma.sampling", "snap");
    EXPECT_EQ(settings.get(kSampling), Sampling::snap);
    settings.set_text("view.camera", " a b ");
    EXPECT_EQ(settings.get(kCamera), " a b ");
}

TEST(Settings, TakesAssignments) {
    Settings settings(knobs());
    settings.set_assignment("occupancy.resolution=64");
    EXPECT_EQ(settings.get(kResolution), 64);
    settings.set_assignment(" occupancy.resolution = 65");
    EXPECT_EQ(settings.get(kResolution), 65);
    settings.set_assignment("view.camera=a=b");
    EXPECT_EQ(settings.get(kCamera), "a=b");
    settings.set_assignment("view.camera=");
    EXPECT_EQ(settings.get(kCamera), "");
    EXPECT_EQ(expect_error([&] { settings.set_assignment("view.camera"); }),
              "'view.camera' sets nothing: write key=value");
    EXPECT_CONTAINS(expect_error([&] { settings.set_assignment("=3"); }), "unknown setting ''");
}

TEST(Settings, TextErrorsSayWhatIsAllowed) {
    EXPECT_EQ(set_error("occupancy.resolution", "16"),
              "setting 'occupancy.resolution' cannot be '16': it takes a whole number, "
              "32 to 256 (cells)");
    EXPECT_EQ(set_error("ao.radius", "far"),
              "setting 'ao.radius' cannot be 'far': it takes a number, at least 0 (m)");
    EXPECT_EQ(set_error("ao.bias", "nan"), "setting 'ao.bias' cannot be 'nan': it takes a number");
    EXPECT_EQ(set_error("reuse.antialias", "yes!"),
              "setting 'reuse.antialias' cannot be 'yes!': it takes true or false");
    EXPECT_EQ(set_error("roma.sampling", "snip"),
              "setting 'roma.sampling' cannot be 'snip': it takes one of snap | candidates | "
              "a-trous; did you mean 'snap'?");
    EXPECT_EQ(set_error("view.camera", "\xc0\x80"),
              "setting 'view.camera' cannot be '\xc0\x80': it takes text in valid UTF-8");
    EXPECT_EQ(set_error("roma.sampler", "snap"),
              "unknown setting 'roma.sampler': did you mean 'roma.sampling'?");
}

TEST(Settings, TextThatIsNoNumber) {
    for (const char* text : {"1.5", "12abc", "", " ", "0x40", "6 4", "1e2", "64.0", "+-64", "++64",
                             "99999999999999999999", "inf", "true"})
        EXPECT_CONTAINS(set_error("occupancy.resolution", text),
                        "setting 'occupancy.resolution' cannot be '" + std::string(text));
    for (const char* text : {"", "1.5x", "1,5", "0x1p3", "NaN", "-nan", "1e999", "--1", "1 2"})
        EXPECT_CONTAINS(set_error("ao.bias", text),
                        "setting 'ao.bias' cannot be '" + std::string(text));
}

TEST(Settings, ErrorsStayShortAndOnOneLine) {
    EXPECT_CONTAINS(set_error("ao.bias", "1\n2\t3"), "cannot be '1?2?3'");
    const std::string text = set_error("ao.bias", std::string(100000, 'x').c_str());
    EXPECT_LT(text.size(), 200u);
    EXPECT_LT(set_error(std::string(10000, 'x').c_str(), "1").size(), 200u);
}

TEST(Settings, OnlyValidUtf8) {
    Settings settings(knobs());
    for (const char* good : {"", "a", "\xc2\x80", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf",
                             "\xee\x80\x80", "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf"})
        EXPECT_NO_THROW(settings.set(kCamera, good));
    for (const char* bad :
         {"\x80", "\xc3", "\xc3(", "\xc0\x80", "\xc1\xbf", "\xe0\x9f\xbf", "\xed\xa0\x80",
          "\xe2\x82", "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80", "\xf8\x88\x80\x80\x80", "\xff",
          "a\xe2\x82"
          "b"})
        EXPECT_THROW(settings.set(kCamera, bad), Error);
}

} // namespace
} // namespace romascope
