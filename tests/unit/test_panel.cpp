// SPDX-License-Identifier: MIT
// The panel that is made from the knobs, and what is over it: what can be tested without a window.
#include "app/viewer/interface/input_queue.h"
#include "app/viewer/interface/knob_groups.h"
#include "app/viewer/interface/knob_widget.h"
#include "app/viewer/interface/overlay.h"
#include "renderer/frame/idle_knobs.h"
#include "renderer/frame/technique.h"
#include "renderer/passes/compose.h"
#include "renderer/reuse/spatial_hash/hash_knobs.h"
#include "renderer/tracers/roma/roma_knobs.h"
#include "renderer/tracers/tracer.h"

#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

namespace romascope {
namespace {

TEST(KnobGroups, HaveEveryKnobOnceUnderItsKey) {
    std::set<const KnobBase*> seen;
    std::set<std::string> titles;
    for (const KnobGroup& group : knob_groups(all_knobs())) {
        EXPECT_FALSE(group.knobs.empty()) << group.key;
        EXPECT_TRUE(titles.insert(group.title).second) << group.title << " is there twice";
        for (const KnobBase* knob : group.knobs) {
            EXPECT_EQ(group_key(*knob), group.key);
            EXPECT_TRUE(seen.insert(knob).second) << knob->key();
        }
    }
    EXPECT_EQ(seen.size(), all_knobs().all().size());
}

TEST(KnobGroups, ThoseNobodyNamedComeLast) {
    static const Knob<bool> stranger{
        {.key = "new_thing.on", .unit = "", .help = "New.", .source = ""}, true};
    const KnobTable table({&stranger, &kTracer, &kView});
    const std::vector<KnobGroup> groups = knob_groups(table);
    ASSERT_EQ(groups.size(), 3u);
    EXPECT_EQ(groups[0].key, "technique");
    EXPECT_EQ(groups[2].key, "new_thing");
    EXPECT_EQ(groups[2].title, "New thing");
}

TEST(KnobGroups, FilterLooksAtKeyLabelAndHelp) {
    static const Knob<bool> knob{
        {.key = "a.two_words", .unit = "", .help = "How Far it goes.", .source = "nowhere"}, true};
    for (const char* filter : {"", "  ", "two", "two_w", "TWO WORDS", "far", "goes a."})
        EXPECT_TRUE(matches(knob, filter)) << filter;
    for (const char* filter : {"three", "two three", "nowhere"})
        EXPECT_FALSE(matches(knob, filter)) << filter;
}

TEST(KnobGroups, KnobsOfOtherTracersAndViewsAreNotInUse) {
    Settings settings(all_knobs());
    EXPECT_TRUE(is_in_use(kTracer, settings));
    settings.set(kView, PictureKind::lit);
    EXPECT_TRUE(is_in_use(kSunStrength, settings));
    settings.set(kView, PictureKind::normal);
    EXPECT_FALSE(is_in_use(kSunStrength, settings));
    for (const TracerEntry& chosen : tracers()) {
        settings.set(kTracer, std::string(chosen.name));
        for (const TracerEntry& other : tracers())
            for (const KnobBase* knob : other.knobs()) {
                const std::vector<const KnobBase*> own = chosen.knobs();
                const bool is_own = std::find(own.begin(), own.end(), knob) != own.end();
                const bool counts = is_own && setting_that_wakes(*knob, settings).empty();
                EXPECT_EQ(is_in_use(*knob, settings), counts) << chosen.name << ' ' << knob->key();
            }
    }
}

TEST(KnobGroups, WhatWakesAKnobDoes) {
    Settings start(all_knobs());
    size_t asleep = 0;
    for (const PictureKind view : {PictureKind::normal, PictureKind::lit, PictureKind::structure})
        for (const TracerEntry& tracer : tracers()) {
            start.set(kView, view);
            start.set(kTracer, std::string(tracer.name));
            for (const KnobBase* knob : all_knobs().all()) {
                SCOPED_TRACE(knob->key());
                Settings settings = start;
                for (int steps = 0; !is_in_use(*knob, settings); ++steps, ++asleep) {
                    ASSERT_LT(steps, 2);
                    const std::string wakes = what_wakes(*knob, settings);
                    settings.set_assignment(wakes.substr(0, wakes.find(" or ")));
                }
            }
        }
    EXPECT_GT(asleep, 50u);
}

TEST(KnobGroups, TheViewOfTheHashUsesItsKnobs) {
    Settings settings(all_knobs());
    EXPECT_FALSE(is_in_use(kHashFootprint, settings));
    settings.set(kView, PictureKind::hash);
    EXPECT_TRUE(is_in_use(kHashFootprint, settings));
}

TEST(KnobGroups, WhatAnotherSettingDecidesIsDimmed) {
    Settings settings(all_knobs());
    settings.set(kRomaAlignment, RomaAlignment::rotate);
    EXPECT_EQ(what_wakes(kRomaTaps, settings), "roma.alignment=shear");
    EXPECT_EQ(what_wakes(kRomaFit, settings), "");
    settings.set(kRomaAlignment, RomaAlignment::shear);
    EXPECT_EQ(what_wakes(kRomaTaps, settings), "");
    EXPECT_EQ(what_wakes(kRomaFit, settings), "roma.alignment=rotate");
    settings.set(kRomaSnap, false);
    EXPECT_EQ(what_wakes(kRomaSampling, settings), "roma.snap=true");
}

TEST(KnobWidget, SuitsKindAndRange) {
    for (const KnobBase* knob : all_knobs().all()) {
        const WidgetSpec spec = widget_of(*knob);
        const bool number_kind = spec.kind == WidgetKind::slider || spec.kind == WidgetKind::drag;
        const bool is_number = knob->kind() == KnobKind::integer || knob->kind() == KnobKind::real;
        EXPECT_EQ(number_kind, is_number) << knob->key();
        EXPECT_EQ(spec.kind == WidgetKind::checkbox, knob->kind() == KnobKind::boolean);
        EXPECT_EQ(spec.kind == WidgetKind::combo, knob->kind() == KnobKind::choice);
        EXPECT_EQ(spec.can_be_infinite, is_number && std::isinf(knob->maximum())) << knob->key();
        EXPECT_EQ(spec.format.find('%') == 0, is_number) << knob->key();
        if (spec.kind == WidgetKind::slider) {
            EXPECT_TRUE(std::isfinite(knob->minimum()) && std::isfinite(knob->maximum()));
            EXPECT_TRUE(!spec.logarithmic || knob->minimum() >= 0.0) << knob->key();
        }
    }
    EXPECT_TRUE(widget_of(kWidth).logarithmic);
    EXPECT_EQ(widget_of(kSeed).kind, WidgetKind::drag);
}

TEST(KnobWidget, UnitsStandBehindNumbersAsTheyAre) {
    static const Knob<double> knob{
        {.key = "a.b", .unit = "% of all", .help = "Part.", .source = ""}, 1.0, 0.0, 2.0};
    char text[64];
    const std::string format = widget_of(knob).format;
    std::snprintf(text, sizeof text, format.c_str(), 0.25);
    EXPECT_STREQ(text, "0.25 % of all");
}

using Kind = InputEvent::Kind;

InputEvent key(int code, int action, int mods = 0) { return {Kind::key, code, 0, action, mods}; }
InputEvent character(char c) { return {Kind::character, c}; }
InputEvent button(int action) { return {Kind::button, 0, 0, action}; }
InputEvent cursor(double x) { return {Kind::cursor, 0, 0, 0, 0, x, 0.0}; }

/// In how many events each frame of ImGui consists.
std::vector<int> frames_of(const std::vector<InputEvent>& events) {
    std::vector<int> counts;
    for (size_t i = 0; i < events.size();) {
        InputFrame frame;
        int count = 0;
        for (; i < events.size() && frame.takes(events[i]); ++i)
            ++count;
        counts.push_back(count);
        if (count == 0) // would never end
            break;
    }
    return counts;
}

TEST(InputFrame, LettersTypedFastAreOneFrame) {
    EXPECT_EQ(
        frames_of({key(GLFW_KEY_A, GLFW_PRESS), character('a'), key(GLFW_KEY_A, GLFW_RELEASE),
                   key(GLFW_KEY_B, GLFW_PRESS), character('b'), key(GLFW_KEY_B, GLFW_RELEASE)}),
        (std::vector<int>{6}));
}

TEST(InputFrame, TextAndEnterAndTextKeepTheirOrder) {
    EXPECT_EQ(frames_of({character('7'), key(GLFW_KEY_ENTER, GLFW_PRESS),
                         key(GLFW_KEY_ENTER, GLFW_RELEASE), character('8')}),
              (std::vector<int>{1, 1, 2}));
}

TEST(InputFrame, ShortcutsAreSeenWithTheirModifier) {
    EXPECT_EQ(frames_of({character('x'), key(GLFW_KEY_LEFT_CONTROL, GLFW_PRESS, GLFW_MOD_CONTROL),
                         key(GLFW_KEY_A, GLFW_PRESS, GLFW_MOD_CONTROL),
                         key(GLFW_KEY_A, GLFW_RELEASE, GLFW_MOD_CONTROL),
                         key(GLFW_KEY_LEFT_CONTROL, GLFW_RELEASE), character('y')}),
              (std::vector<int>{1, 2, 3}));
}

TEST(InputFrame, ClicksAreWhereTheMouseWas) {
    EXPECT_EQ(frames_of({cursor(1), cursor(2), button(GLFW_PRESS), button(GLFW_RELEASE), cursor(9),
                         button(GLFW_PRESS), cursor(10), cursor(11), character('f')}),
              (std::vector<int>{3, 1, 2, 3}));
    EXPECT_EQ(
        frames_of({cursor(1), button(GLFW_PRESS), cursor(2), cursor(3), button(GLFW_RELEASE)}),
        (std::vector<int>{2, 2, 1}));
}

TEST(Overlay, ErrorsStayAndNothingElseLiesLongOnAPictureAlone) {
    for (const bool panel : {false, true})
        EXPECT_FALSE(seconds_shown(Severity::error, panel));
    EXPECT_EQ(seconds_shown(Severity::info, true), 10.0);
    EXPECT_EQ(seconds_shown(Severity::info, false), 5.0);
    EXPECT_EQ(seconds_shown(Severity::notice, false), 0.0);
}

} // namespace
} // namespace romascope
