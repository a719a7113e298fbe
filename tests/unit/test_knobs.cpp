// SPDX-License-Identifier: MIT
#include "tests/support/sample_knobs.h"

#include <stdexcept>

namespace romascope {
namespace {

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
        EXPECT_CONTAINS(table_mistake(knob), "a key is lower-case words") << key;
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
    EXPECT_CONTAINS(table_mistake(Knob<bool>{{.key = "a.b"}, false}), "no help");
    for (const KnobText& text :
         {KnobText{.key = "a.b", .help = "h\n"}, KnobText{.key = "a.b", .unit = "\n", .help = "h"},
          KnobText{.key = "a.b", .help = "h", .source = "a\nb"}})
        EXPECT_CONTAINS(table_mistake(Knob<bool>{text, false}), "one line");
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
    EXPECT_CONTAINS(table_mistake(Knob<int64_t>{text, 0, 0, large}), "2^53");
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
    EXPECT_EQ(expect_error([] { knobs().at("ao.radio"); }),
              "unknown setting 'ao.radio': did you mean 'ao.radius'?");
    const KnobTable empty({});
    EXPECT_EQ(expect_error([&] { empty.at("x"); }),
              "unknown setting 'x': 'romascope info --knobs' lists all");
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

} // namespace
} // namespace romascope
