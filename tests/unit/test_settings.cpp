// SPDX-License-Identifier: MIT
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/settings/settings.h"
#include "renderer/settings/shader_defines.h"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <stdexcept>
#include <unistd.h>

namespace romascope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

enum class Sampling { snap, candidates, a_trous };

const Knob<int> kResolution{{.key = "occupancy.resolution",
                             .unit = "cells",
                             .help = "Cells along the longest side.",
                             .source = "paper, section 4"},
                            128,
                            32,
                            256};
const Knob<double> kRadius{
    {.key = "ao.radius", .unit = "m", .help = "Reach of a ray.", .source = "paper, section 5"},
    kInfinity,
    0.0,
    kInfinity};
const Knob<double> kBias{{.key = "ao.bias", .help = "Any number."}, 0.1, -kInfinity, kInfinity};
const Knob<double> kBlend{{.key = "reuse.taa.blend", .help = "Weight of the new."}, 0.1, 0.0, 1.0};
const Knob<bool> kAntialias{{.key = "reuse.antialias", .help = "Smooth edges."}, false};
const Knob<std::string> kCamera{{.key = "view.camera", .help = "Name of a camera."}, ""};
const Knob<Sampling> kSampling{{.key = "roma.sampling", .help = "How rays are drawn."},
                               Sampling::candidates,
                               {"snap", "candidates", "a-trous"}};
const Knob<int64_t> kSeed{
    {.key = "view.seed", .help = "Seed."}, -1, -(int64_t{1} << 53) + 1, (int64_t{1} << 53) - 1};

const KnobTable& knobs() {
    // "reuse.taa" comes before "reuse", to have a table of the file after a table inside it.
    static const KnobTable table(
        {&kResolution, &kRadius, &kBlend, &kBias, &kAntialias, &kCamera, &kSampling, &kSeed});
    return table;
}

/// What an Error says; fails the test if there is none or it is not one line of bad input.
template <class Action>
std::string error_of(Action action) {
    try {
        action();
    } catch (const Error& error) {
        EXPECT_EQ(error.exit_status(), kBadInput);
        const std::string text = error.what();
        EXPECT_EQ(text.find('\n'), text.npos) << text;
        return text;
    }
    ADD_FAILURE() << "no Error";
    return "";
}

std::string set_error(const char* key, const char* value) {
    Settings settings(knobs());
    const std::string text = error_of([&] { settings.set_text(key, value); });
    EXPECT_EQ(settings, Settings(knobs()));
    return text;
}

std::string load_error(std::string_view toml) {
    Settings settings(knobs());
    settings.set(kResolution, 77);
    const Settings before = settings;
    const std::string text = error_of([&] { settings.load_toml_text(toml, "f.toml"); });
    EXPECT_EQ(settings, before) << toml;
    return text;
}

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != text.npos;
}

// Declarations

TEST(Knob, HoldsItsDeclaration) {
    EXPECT_EQ(kResolution.key(), "occupancy.resolution");
    EXPECT_EQ(kResolution.unit(), "cells");
    EXPECT_EQ(kResolution.help(), "Cells along the longest side.");
    EXPECT_EQ(kResolution.source(), "paper, section 4");
    EXPECT_EQ(kResolution.kind(), KnobKind::integer);
    EXPECT_EQ(kResolution.default_value(), KnobValue(int64_t{128}));
    EXPECT_EQ(kResolution.minimum(), 32);
    EXPECT_EQ(kResolution.maximum(), 256);
    EXPECT_EQ(kSampling.kind(), KnobKind::choice);
    EXPECT_EQ(kSampling.default_value(), KnobValue("candidates"));
    EXPECT_EQ(kSampling.choices(),
              (std::vector<std::string_view>{"snap", "candidates", "a-trous"}));
    EXPECT_EQ(kAntialias.kind(), KnobKind::boolean);
    EXPECT_EQ(kCamera.kind(), KnobKind::text);
    EXPECT_EQ(kRadius.kind(), KnobKind::real);
}

TEST(Knob, RangesInWords) {
    EXPECT_EQ(range_text(kResolution), "32 to 256");
    EXPECT_EQ(range_text(kRadius), "at least 0");
    EXPECT_EQ(range_text(kBias), "any number");
    EXPECT_EQ(range_text(kSampling), "snap | candidates | a-trous");
    EXPECT_EQ(range_text(kAntialias), "true | false");
    EXPECT_EQ(range_text(kCamera), "any text");
    const Knob<double> below{{.key = "a.b", .help = "h"}, 0, -kInfinity, 0.5};
    EXPECT_EQ(range_text(below), "at most 0.5");
}

TEST(Knob, ValuesInWords) {
    EXPECT_EQ(to_text(true), "true");
    EXPECT_EQ(to_text(int64_t{-3}), "-3");
    EXPECT_EQ(to_text(0.1), "0.1");
    EXPECT_EQ(to_text(128.0), "128");
    EXPECT_EQ(to_text(kInfinity), "inf");
    EXPECT_EQ(to_text("some text"), "some text");
}

template <class... Knobs>
std::string table_mistake(const Knobs&... declared) {
    try {
        const KnobTable table({&declared...});
    } catch (const std::logic_error& mistake) {
        return mistake.what();
    }
    return "";
}

TEST(KnobTable, RefusesBadKeys) {
    for (const char* key : {"", "a", "a.", ".a", "a..b", "A.b", "a.B", "a b.c", "a.b c", "a.1",
                            "1.a", "a._b", "a.b_", "a.b__c", "a.b-c", "a.\xc3\xa9", "a.b\n"}) {
        const Knob<bool> knob{{.key = key, .help = "h"}, false};
        EXPECT_TRUE(contains(table_mistake(knob), "a key is lower-case words")) << key;
    }
    for (const char* key : {"a.b", "a.b.c", "a1.b_2c", "a.b_c_d"}) {
        const Knob<bool> knob{{.key = key, .help = "h"}, false};
        EXPECT_EQ(table_mistake(knob), "") << key;
    }
}

TEST(KnobTable, RefusesKeysThatMeet) {
    const Knob<bool> a{{.key = "a.b", .help = "h"}, false};
    const Knob<int> same{{.key = "a.b", .help = "h"}, 1, 0, 2};
    const Knob<bool> inside{{.key = "a.b.c.d", .help = "h"}, false};
    const Knob<bool> beside{{.key = "a.bc", .help = "h"}, false};
    EXPECT_EQ(table_mistake(a, same), "knob 'a.b': the key is taken");
    EXPECT_EQ(table_mistake(a, a), "knob 'a.b': the key is taken");
    EXPECT_EQ(table_mistake(a, inside), "knob 'a.b.c.d': its group, 'a.b', is a knob too");
    EXPECT_EQ(table_mistake(inside, a), "knob 'a.b.c.d': its group, 'a.b', is a knob too");
    EXPECT_EQ(table_mistake(a, beside), "");
    EXPECT_THROW(KnobTable({nullptr}), std::logic_error);
}

TEST(KnobTable, RefusesBadText) {
    EXPECT_TRUE(contains(table_mistake(Knob<bool>{{.key = "a.b"}, false}), "no help"));
    for (const KnobText& text :
         {KnobText{.key = "a.b", .help = "h\n"}, KnobText{.key = "a.b", .unit = "\n", .help = "h"},
          KnobText{.key = "a.b", .help = "h", .source = "a\nb"}})
        EXPECT_TRUE(contains(table_mistake(Knob<bool>{text, false}), "one line"));
}

TEST(KnobTable, RefusesBadDefaults) {
    const KnobText text{.key = "a.b", .help = "h"};
    EXPECT_EQ(table_mistake(Knob<int>{text, 3, 4, 5}),
              "knob 'a.b': its default, 3, is outside its range, 4 to 5");
    EXPECT_NE(table_mistake(Knob<int>{text, 6, 4, 5}), "");
    EXPECT_NE(table_mistake(Knob<int>{text, 4, 5, 4}), "");
    EXPECT_EQ(table_mistake(Knob<int>{text, 4, 4, 4}), "");
    EXPECT_NE(table_mistake(Knob<double>{text, kNan, 0, 1}), "");
    EXPECT_NE(table_mistake(Knob<double>{text, 0, kNan, 1}), "");
    EXPECT_NE(table_mistake(Knob<double>{text, 0, 0, kNan}), "");
    EXPECT_NE(table_mistake(Knob<double>{text, kInfinity, 0, 1}), "");
    EXPECT_NE(table_mistake(Knob<std::string>{text, "\xff"}), "");
    const int64_t large = std::numeric_limits<int64_t>::max();
    EXPECT_TRUE(contains(table_mistake(Knob<int64_t>{text, 0, 0, large}), "2^53"));
    EXPECT_EQ(table_mistake(Knob<uint32_t>{text, 0, 0, ~0u}), "");
}

TEST(KnobTable, RefusesBadChoices) {
    const KnobText text{.key = "a.b", .help = "h"};
    const auto mistake = [&](Sampling value, std::initializer_list<std::string_view> names) {
        return table_mistake(Knob<Sampling>{text, value, names});
    };
    EXPECT_EQ(mistake(Sampling::a_trous, {"a", "b_1", "2c-d"}), "");
    EXPECT_EQ(mistake(Sampling::a_trous, {"a", "b"}),
              "knob 'a.b': its default is none of its choices");
    EXPECT_NE(mistake(Sampling::snap, {}), "");
    EXPECT_NE(mistake(static_cast<Sampling>(-1), {"a"}), "");
    EXPECT_EQ(mistake(Sampling::snap, {"a", "a"}), "knob 'a.b': choice 'a' is there twice");
    for (const char* name : {"", "A", "a b", "-a", "a--b"})
        EXPECT_NE(mistake(Sampling::snap, {"good", name}), "") << name;
}

TEST(KnobTable, FindsByKey) {
    EXPECT_EQ(knobs().find("ao.radius"), &kRadius);
    EXPECT_EQ(&knobs().at("ao.radius"), &kRadius);
    EXPECT_EQ(knobs().find("ao.radio"), nullptr);
    EXPECT_EQ(knobs().find("ao"), nullptr);
    EXPECT_EQ(knobs().find(""), nullptr);
    EXPECT_EQ(error_of([] { knobs().at("ao.radio"); }),
              "unknown setting 'ao.radio': did you mean 'ao.radius'?");
    const KnobTable empty({});
    EXPECT_EQ(error_of([&] { empty.at("x"); }), "unknown setting 'x'");
    EXPECT_EQ(Settings(empty).to_toml(), "");
}

TEST(KnobTable, AsText) {
    const KnobTable table({&kResolution, &kCamera});
    EXPECT_EQ(knobs_as_text(table),
              "key                   type     default  range      unit\n"
              "occupancy.resolution  integer  128      32 to 256  cells\n"
              "    Cells along the longest side. [default: paper, section 4]\n"
              "view.camera           text     ''       any text\n"
              "    Name of a camera.\n");
}

// Values

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

// Text of the command line

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
    EXPECT_EQ(error_of([&] { settings.set_assignment("view.camera"); }),
              "'view.camera' sets nothing: write key=value");
    EXPECT_TRUE(contains(error_of([&] { settings.set_assignment("=3"); }), "unknown setting ''"));
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
        EXPECT_TRUE(contains(set_error("occupancy.resolution", text),
                             "setting 'occupancy.resolution' cannot be '" + std::string(text)));
    for (const char* text : {"", "1.5x", "1,5", "0x1p3", "NaN", "-nan", "1e999", "--1", "1 2"})
        EXPECT_TRUE(contains(set_error("ao.bias", text),
                             "setting 'ao.bias' cannot be '" + std::string(text)));
}

TEST(Settings, ErrorsStayShortAndOnOneLine) {
    EXPECT_TRUE(contains(set_error("ao.bias", "1\n2\t3"), "cannot be '1?2?3'"));
    const std::string text = set_error("ao.bias", std::string(100000, 'x').c_str());
    EXPECT_LT(text.size(), 200u);
    EXPECT_LT(set_error(std::string(10000, 'x').c_str(), "1").size(), 200u);
}

// TOML

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
    EXPECT_TRUE(contains(load_error("ao.radius = -inf"), "cannot be '-inf'"));
    EXPECT_TRUE(contains(load_error("reuse.taa.blend = inf"), "0 to 1"));
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
    EXPECT_TRUE(contains(load_error("\n\n[nothing]\n"), "f.toml:3: unknown setting 'nothing'"));
    EXPECT_TRUE(contains(load_error("roma.sampling = 'snip'"), "did you mean 'snap'?"));
}

TEST(Toml, TypesAreNotGuessed) {
    for (const char* value : {"64.0", "64.5", "'64'", "true", "1979-05-27", "[64]", "{}"})
        EXPECT_TRUE(contains(load_error("occupancy.resolution = " + std::string(value)),
                             "f.toml:1: setting 'occupancy.resolution' cannot be "))
            << value;
    for (const char* value : {"1", "'true'", "1.0"})
        EXPECT_TRUE(contains(load_error("reuse.antialias = " + std::string(value)), "cannot be "));
    for (const char* value : {"1", "true", "1.0"})
        EXPECT_TRUE(contains(load_error("view.camera = " + std::string(value)), "cannot be "));
    EXPECT_TRUE(contains(load_error("ao.radius = '1'"), "cannot be "));
    EXPECT_TRUE(contains(load_error("ao.radius = [1]"), "a list"));
    EXPECT_TRUE(contains(load_error("[ao.radius]\n"), "a table"));
    EXPECT_TRUE(contains(load_error("ao = 1"), "unknown setting 'ao'"));
    EXPECT_TRUE(contains(load_error("[[ao]]\nradius = 1"), "unknown setting 'ao'"));
    EXPECT_TRUE(contains(load_error("[ao.radius]\nx = 1\n"), "unknown setting 'ao.radius.x'"));
}

TEST(Toml, SyntaxErrors) {
    for (const char* text :
         {"\n\nao.radius = ", "\n\nao.radius = 1 2", "\n\n[ao\nradius = 1", "\n\nao.radius = 'x\n",
          "\n\nao.radius = 1\n\xff", "\n\nao.bias = 99999999999999999999"})
        EXPECT_EQ(load_error(text).substr(0, 7), "f.toml:") << text;
    EXPECT_TRUE(load_error("\n\nao.radius = 1 2\n").starts_with("f.toml:3: "));
    EXPECT_TRUE(load_error("ao.radius = 1\nao.radius = 2\n").starts_with("f.toml:2: "));
    EXPECT_TRUE(contains(load_error("ao.radius = 1\n'ao.radius' = 2\n"),
                         "f.toml:2: setting 'ao.radius' is given twice"));
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
    EXPECT_TRUE(error_of([&] { settings.load_toml(path); }).starts_with(path + ":2: setting"));
    std::filesystem::remove(path);
    EXPECT_TRUE(contains(error_of([&] { settings.load_toml(path); }), "cannot read " + path));
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

// Shader defines

TEST(ShaderDefines, OneForEachKnobAndChoice) {
    Settings settings(knobs());
    settings.set(kAntialias, true);
    settings.set(kSeed, 5);
    const std::vector<ShaderDefine> defines =
        shader_defines(settings, {&kResolution, &kAntialias, &kSampling, &kBlend, &kRadius});
    const std::vector<ShaderDefine> expected = {
        {"OCCUPANCY_RESOLUTION", "128"},
        {"REUSE_ANTIALIAS", "1"},
        {"ROMA_SAMPLING", "1"},
        {"ROMA_SAMPLING_SNAP", "0"},
        {"ROMA_SAMPLING_CANDIDATES", "1"},
        {"ROMA_SAMPLING_A_TROUS", "2"},
        {"REUSE_TAA_BLEND", "0.1"},
        {"AO_RADIUS", "uintBitsToFloat(0x7F800000u)"},
    };
    EXPECT_EQ(defines, expected);
    EXPECT_TRUE(shader_defines(settings, {}).empty());
}

std::string real_define(double value) {
    Settings settings(knobs());
    settings.set(kBias, value);
    return shader_defines(settings, {&kBias}).at(0).value;
}

TEST(ShaderDefines, Reals) {
    EXPECT_EQ(real_define(0.0), "0.0");
    EXPECT_EQ(real_define(2.0), "2.0");
    EXPECT_EQ(real_define(-1.5), "(-1.5)");
    EXPECT_EQ(real_define(-0.0), "(-0.0)");
    EXPECT_EQ(real_define(-kInfinity), "uintBitsToFloat(0xFF800000u)");
    EXPECT_EQ(real_define(1e300), "uintBitsToFloat(0x7F800000u)");
    std::mt19937 random(5);
    for (int i = 0; i < 20000; ++i) {
        const float value = std::bit_cast<float>(static_cast<uint32_t>(random()));
        if (!std::isfinite(value))
            continue;
        const std::string text = real_define(value);
        const bool negative = std::signbit(value);
        ASSERT_EQ(text.starts_with("(-") && text.ends_with(')'), negative) << text;
        const float back = std::strtof(text.c_str() + (negative ? 1 : 0), nullptr);
        ASSERT_EQ(std::bit_cast<uint32_t>(back), std::bit_cast<uint32_t>(value)) << text;
        ASSERT_NE(text.find_first_of(".e"), text.npos) << text; // else it is an int in GLSL
    }
}

TEST(ShaderDefines, Integers) {
    const Knob<int> negative{{.key = "a.b", .help = "h"}, -3, -5, 5};
    const Knob<uint32_t> wide{{.key = "a.c", .help = "h"}, 1, 0, ~0u};
    const Knob<int> largest{{.key = "a.d", .help = "h"}, 0x7fffffff, -0x7fffffff, 0x7fffffff};
    const KnobTable table({&negative, &wide, &largest});
    const Settings settings(table);
    EXPECT_EQ(shader_defines(settings, {&negative}).at(0).value, "(-3)");
    EXPECT_EQ(shader_defines(settings, {&largest}).at(0).value, "2147483647");
    EXPECT_THROW(shader_defines(settings, {&wide}), std::logic_error);
}

TEST(ShaderDefines, Mistakes) {
    const Settings settings(knobs());
    EXPECT_THROW(shader_defines(settings, {&kCamera}), std::logic_error);
    EXPECT_THROW(shader_defines(settings, {&kBias, &kBias}), std::logic_error);
    const Knob<bool> reserved{{.key = "gl.debug", .help = "h"}, false};
    const Knob<bool> one{{.key = "a.b_c", .help = "h"}, false};
    const Knob<bool> same{{.key = "a_b.c", .help = "h"}, false};
    const KnobTable table({&reserved, &one, &same});
    const Settings others(table);
    EXPECT_THROW(shader_defines(others, {&reserved}), std::logic_error);
    EXPECT_THROW(shader_defines(others, {&one, &same}), std::logic_error);
    EXPECT_EQ(shader_defines(others, {&same}).at(0).name, "A_B_C");
    EXPECT_THROW(shader_defines(others, {&kBias}), std::logic_error); // not in the table
}

} // namespace
} // namespace romascope
