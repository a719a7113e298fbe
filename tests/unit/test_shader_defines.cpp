// SPDX-License-Identifier: MIT
#include "renderer/settings/shader_defines.h"
#include "tests/support/sample_knobs.h"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <random>
#include <stdexcept>

namespace romascope {
namespace {

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
