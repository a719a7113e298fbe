// SPDX-License-Identifier: MIT
// Widgets for the values of knobs: real ones of ImGui, moved by a hand that is not there.
#include "app/viewer/interface/knob_editor.h"
#include "app/viewer/interface/knob_widget.h"
#include "renderer/frame/technique.h"

#include <gtest/gtest.h>

#include <imgui.h>

#include <cmath>
#include <limits>

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

} // namespace
} // namespace romascope
