// SPDX-License-Identifier: MIT
// The panel that is made from the knobs: what can be tested of it without a window. Widgets are
// real ones of ImGui, moved by a hand that is not there.
#include "app/viewer/interface/input_queue.h"
#include "app/viewer/interface/knob_editor.h"
#include "app/viewer/interface/knob_groups.h"
#include "app/viewer/interface/knob_widget.h"
#include "app/viewer/interface/overlay.h"
#include "renderer/frame/technique.h"
#include "renderer/passes/compose.h"
#include "renderer/tracers/tracer.h"

#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <cmath>
#include <limits>
#include <set>

namespace romascope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double number(const KnobValue& value) {
    if (const auto* integer = std::get_if<int64_t>(&value))
        return static_cast<double>(*integer);
    return std::get<double>(value);
}

/// A window of ImGui without a screen, in which one widget at a time is shown.
class Hand {
public:
    Hand() : context_(ImGui::CreateContext()) {
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {600.0f, 200.0f};
        io.DeltaTime = 1.0f; // no two clicks are one double click
        for (int key = 0; key < ImGuiKey_COUNT; ++key)
            io.KeyMap[key] = key;
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    }
    ~Hand() { ImGui::DestroyContext(context_); }
    Hand(const Hand&) = delete;
    Hand& operator=(const Hand&) = delete;

    /// A frame with the widget of the knob, or with its tick for infinity. What it gave is kept in
    /// `value` and returned.
    std::optional<KnobValue> frame() {
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0.0f, 0.0f});
        ImGui::SetNextWindowSize({600.0f, 200.0f});
        ImGui::Begin("hand");
        ImGui::SetNextItemWidth(400.0f);
        auto made = infinity ? editor_.edit_infinity(*knob, std::get<double>(value))
                             : editor_.edit(*knob, value, {});
        low_ = ImGui::GetItemRectMin();
        high_ = ImGui::GetItemRectMax();
        ImGui::End();
        ImGui::EndFrame();
        if (made)
            value = *made;
        return made;
    }
    void show(const KnobBase& shown) {
        press(false);
        ImGui::GetIO().MousePos = {-1.0f, -1.0f};
        knob = &shown;
        value = shown.default_value();
        for (int i = 0; i < 3; ++i) // a widget that is gone lets go
            frame();
    }
    /// To a part of the widget's width; beyond 0 and 1: beside it.
    void move(double part) {
        ImGui::GetIO().MousePos = {low_.x + static_cast<float>(part) * (high_.x - low_.x),
                                   0.5f * (low_.y + high_.y)};
    }
    void press(bool down) { ImGui::GetIO().MouseDown[0] = down; }
    void hold(ImGuiKey key, bool down) { ImGui::GetIO().KeysDown[key] = down; }
    std::optional<KnobValue> click() {
        press(true);
        auto made = frame();
        press(false);
        const auto later = frame();
        return later ? later : made;
    }
    std::optional<KnobValue> hit(ImGuiKey key) {
        hold(key, true);
        auto made = frame();
        hold(key, false);
        const auto later = frame();
        return later ? later : made;
    }
    /// Ctrl+click, then the text; not yet the key that ends it. No value must come meanwhile.
    void begin_typing(const char* text) {
        move(0.5);
        frame();
        ImGui::GetIO().KeyCtrl = true;
        EXPECT_FALSE(click());
        ImGui::GetIO().KeyCtrl = false;
        EXPECT_FALSE(frame());
        for (const char* c = text; *c != '\0'; ++c) {
            ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(*c));
            EXPECT_FALSE(frame()) << "half of a number counts";
        }
    }

    const KnobBase* knob = nullptr;
    KnobValue value;
    bool infinity = false;

private:
    ImGuiContext* context_;
    KnobEditor editor_;
    ImVec2 low_{0.0f, 0.0f}, high_{1.0f, 1.0f};
};

std::vector<const KnobBase*> knobs_with(WidgetKind kind) {
    std::vector<const KnobBase*> found;
    for (const KnobBase* knob : all_knobs().all())
        if (widget_of(*knob).kind == kind)
            found.push_back(knob);
    return found;
}

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
                EXPECT_EQ(is_in_use(*knob, settings), is_own) << chosen.name << ' ' << knob->key();
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

TEST(KnobEditor, ListsSayWhatIsChosen) {
    const KnownNames names{.names = {{"", "the first", {}}, {"0", "0 walk", {}}},
                           .empty = "nothing written"};
    EXPECT_EQ(shown_name(names, ""), "the first");
    EXPECT_EQ(shown_name(names, "0"), "0 walk");
    EXPECT_EQ(shown_name(names, "own"), "own");
    EXPECT_EQ(shown_name({.names = {}, .empty = "nothing written"}, ""), "nothing written");
}

TEST(KnobEditor, SlidersReachBothEndsAndStayInRange) {
    Hand hand;
    for (const KnobBase* knob : knobs_with(WidgetKind::slider)) {
        SCOPED_TRACE(knob->key());
        hand.show(*knob);
        hand.move(0.5);
        hand.frame();
        hand.press(true);
        hand.frame();
        Settings settings(all_knobs());
        double before = -kInfinity;
        for (int i = -10; i <= 110; ++i) {
            hand.move(i / 100.0);
            hand.frame();
            EXPECT_NO_THROW(settings.set_value(*knob, hand.value));
            EXPECT_GE(number(hand.value), before) << "the slider turns back at " << i;
            before = number(hand.value);
            if (i <= 0) {
                EXPECT_EQ(number(hand.value), knob->minimum());
            }
        }
        EXPECT_EQ(number(hand.value), knob->maximum());
    }
}

TEST(KnobEditor, LogarithmicSlidersGiveRoomToSmallNumbers) {
    Hand hand;
    hand.show(kWidth);
    hand.move(0.5);
    hand.frame();
    hand.click();
    // 1 to 16384: the middle is 2^7.
    EXPECT_NEAR(std::log2(number(hand.value)), 7.0, 0.5);
}

TEST(KnobEditor, DragsStayInRange) {
    Hand hand;
    for (const KnobBase* knob : knobs_with(WidgetKind::drag)) {
        SCOPED_TRACE(knob->key());
        hand.show(*knob);
        if (std::isinf(number(hand.value)))
            hand.value = KnobValue(1.0);
        Settings settings(all_knobs());
        hand.move(0.5);
        hand.frame();
        hand.press(true);
        hand.frame();
        const double start = number(hand.value);
        for (const double end : {-100.0, 100.0}) {
            hand.move(end);
            for (int i = 0; i < 3; ++i) {
                hand.frame();
                EXPECT_NO_THROW(settings.set_value(*knob, hand.value));
            }
            EXPECT_TRUE(end < 0.0 ? number(hand.value) <= start : number(hand.value) > start);
            EXPECT_TRUE(std::isfinite(number(hand.value)));
        }
    }
}

TEST(KnobEditor, TypedNumbersCountWhenCompleteAndAsTheyAre) {
    Hand hand;
    hand.show(kWidth);
    hand.begin_typing("99999");
    EXPECT_EQ(hand.hit(ImGuiKey_Enter), KnobValue(int64_t{99999})) << "the session refuses it";
    EXPECT_FALSE(hand.frame());

    hand.show(kWidth);
    hand.begin_typing("640");
    EXPECT_FALSE(hand.hit(ImGuiKey_Escape));
    EXPECT_EQ(hand.value, kWidth.default_value());

    hand.show(kWidth);
    hand.begin_typing("640");
    hand.move(1.3);
    EXPECT_EQ(hand.click(), KnobValue(int64_t{640})) << "a click elsewhere ends typing";
}

TEST(KnobEditor, InfinityIsTickedAndTakenBack) {
    Hand hand;
    const std::vector<const KnobBase*> knobs = knobs_with(WidgetKind::drag);
    const auto endless = std::find_if(knobs.begin(), knobs.end(), [](const KnobBase* knob) {
        return widget_of(*knob).can_be_infinite;
    });
    ASSERT_NE(endless, knobs.end());
    hand.infinity = true;
    hand.show(**endless);
    hand.value = KnobValue(kInfinity);
    hand.move(0.1);
    hand.frame();
    ASSERT_TRUE(hand.click());
    EXPECT_TRUE(std::isfinite(number(hand.value)));
    hand.value = KnobValue(2.5);
    hand.frame();
    ASSERT_TRUE(hand.click());
    EXPECT_EQ(number(hand.value), kInfinity);
    ASSERT_TRUE(hand.click());
    EXPECT_EQ(number(hand.value), 2.5) << "the last finite one comes back";
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
