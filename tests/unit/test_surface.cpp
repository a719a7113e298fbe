// SPDX-License-Identifier: MIT
// Masks and textures on the CPU: the lookup that shaders share, mip levels, where texels lie.
#include "renderer/base/error.h"
#include "renderer/image/color.h"
#include "renderer/scene/gpu_surfaces.h"
#include "renderer/scene/mip_chain.h"
#include "renderer/scene/surface_mask.h"
#include "shaders/common/surface_texture.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace romascope {
namespace {

SurfaceTexture random_texture(glm::ivec2 size, std::mt19937& random) {
    SurfaceTexture texture;
    texture.size = size;
    for (int i = 0; i < size.x * size.y; ++i)
        texture.texels.push_back(static_cast<uint32_t>(random()));
    return texture;
}

/// The texel that a wrapped index names, as OpenGL 4.6, table 8.20 defines it for any integer.
int wrapped(int i, int size, TextureWrap wrap) {
    const auto modulo = [](int a, int b) { return ((a % b) + b) % b; };
    const auto mirror = [](int a) { return a >= 0 ? a : -(1 + a); };
    switch (wrap) {
    case TextureWrap::repeat:
        return modulo(i, size);
    case TextureWrap::mirror:
        return (size - 1) - mirror(modulo(i, 2 * size) - size);
    default:
        return std::clamp(i, 0, size - 1);
    }
}

/// Alpha by the formulas of OpenGL 4.6, section 8.14.3, in double precision.
double alpha_by_the_book(const SurfaceTexture& texture, glm::dvec2 uv) {
    const auto at = [&](int x, int y) {
        const int i = wrapped(x, texture.size.x, texture.wrap_u);
        const int j = wrapped(y, texture.size.y, texture.wrap_v);
        return static_cast<double>(texture.texels[static_cast<size_t>(j * texture.size.x + i)] >>
                                   24);
    };
    const glm::dvec2 place = uv * glm::dvec2(texture.size) - (texture.nearest ? 0.0 : 0.5);
    const glm::dvec2 low = glm::floor(place);
    const auto x = static_cast<int>(low.x), y = static_cast<int>(low.y);
    if (texture.nearest)
        return at(x, y);
    const glm::dvec2 f = place - low;
    return (1 - f.x) * (1 - f.y) * at(x, y) + f.x * (1 - f.y) * at(x + 1, y) +
           (1 - f.x) * f.y * at(x, y + 1) + f.x * f.y * at(x + 1, y + 1);
}

TEST(Surface, AlphaIsWhatOpenGlDefines) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> place(-3.0f, 3.0f);
    for (const glm::ivec2 size : {glm::ivec2(1, 1), {2, 3}, {16, 8}, {5, 7}, {64, 1}})
        for (const TextureWrap u : {TextureWrap::repeat, TextureWrap::mirror, TextureWrap::clamp})
            for (const TextureWrap v :
                 {TextureWrap::repeat, TextureWrap::mirror, TextureWrap::clamp})
                for (const bool nearest : {false, true}) {
                    SurfaceTexture texture = random_texture(size, random);
                    texture.wrap_u = u;
                    texture.wrap_v = v;
                    texture.nearest = nearest;
                    for (int i = 0; i < 300; ++i) {
                        const glm::vec2 uv(place(random), place(random));
                        const double expected = alpha_by_the_book(texture, uv);
                        const float alpha = texture_alpha(texture, uv);
                        // A coordinate's rounding is 2^-22 here; times 64 texels and 255 steps.
                        if (std::abs(alpha - expected) < 0.02)
                            continue;
                        // On a border between texels rounding may choose the other one.
                        const glm::dvec2 texels = glm::dvec2(uv) * glm::dvec2(size);
                        const glm::dvec2 off = glm::abs(texels - glm::round(texels));
                        EXPECT_TRUE(nearest && std::min(off.x, off.y) < 1e-4)
                            << uv.x << " " << uv.y << ": " << alpha << ", not " << expected;
                    }
                }
}

TEST(Surface, AnyCoordinateGivesATexel) {
    std::mt19937 random(2);
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (uint32_t rules = 0; rules < 3; ++rules)
        for (const bool nearest : {false, true})
            for (const int size : {1, 2, 7, 16384}) {
                const auto check = [&](float u) {
                    const gpu::TexelPair pair = gpu::texel_pair(u, size, rules, nearest);
                    ASSERT_GE(pair.low, 0);
                    ASSERT_LT(pair.low, size);
                    ASSERT_GE(pair.high, 0);
                    ASSERT_LT(pair.high, size);
                };
                for (const float u : {kInfinity, -kInfinity, std::nanf(""), 3e38f, -3e38f, -1e-30f,
                                      1.0f, 0.0f, 0.99999994f, 16777217.0f, -1.0f})
                    check(u);
                for (int i = 0; i < 3000; ++i)
                    check(gpu::uintBitsToFloat(static_cast<uint32_t>(random())));
            }
}

TEST(Surface, TheMaskKeepsWhatIsNotBelowTheCutoff) {
    SurfaceTexture texture;
    texture.size = {2, 1};
    texture.nearest = true;
    texture.texels = {0x80ffffffu, 0x7fffffffu}; // alpha 128 and 127
    Material material;
    material.alpha_cutoff = 128.0f / 255.0f;
    EXPECT_TRUE(surface_is_there(material, &texture, {0.25f, 0.5f}, 1.0f));
    EXPECT_FALSE(surface_is_there(material, &texture, {0.75f, 0.5f}, 1.0f));
    EXPECT_FALSE(surface_is_there(material, &texture, {0.25f, 0.5f}, 0.99f));
    material.alpha = 0.99f;
    EXPECT_FALSE(surface_is_there(material, &texture, {0.25f, 0.5f}, 1.0f));
    EXPECT_TRUE(surface_is_there(material, nullptr, {0.25f, 0.5f}, 1.0f));
    // Full alpha passes the highest cutoff, also if it was interpolated.
    material.alpha = material.alpha_cutoff = 1.0f;
    EXPECT_TRUE(surface_is_there(material, nullptr, {0, 0}, 1.0f));
    EXPECT_TRUE(surface_is_there(material, nullptr, {0, 0}, 0.9999999f));
    EXPECT_FALSE(surface_is_there(material, nullptr, {0, 0}, 254.0f / 255.0f));
}

/// The mean of a texture over a rectangle given in texels, in linear light.
std::array<double, 4> mean_of(const SurfaceTexture& texture, glm::dvec2 low, glm::dvec2 high,
                              bool by_alpha) {
    std::array<double, 4> plain{}, weighed{};
    for (int y = 0; y < texture.size.y; ++y)
        for (int x = 0; x < texture.size.x; ++x) {
            const glm::dvec2 a = glm::max(glm::dvec2(x, y), low);
            const glm::dvec2 b = glm::min(glm::dvec2(x + 1, y + 1), high);
            const double area = std::max(0.0, b.x - a.x) * std::max(0.0, b.y - a.y);
            const uint32_t texel = texture.texels[static_cast<size_t>(y * texture.size.x + x)];
            const double alpha = (texel >> 24) / 255.0;
            for (size_t c = 0; c < 3; ++c) {
                const double value = decode_srgb8(static_cast<uint8_t>(texel >> 8 * c));
                plain[c] += area * value;
                weighed[c] += area * value * alpha;
            }
            plain[3] += area * alpha;
        }
    const double all = (high.x - low.x) * (high.y - low.y);
    for (size_t c = 0; c < 3; ++c)
        plain[c] = by_alpha && plain[3] > 0 ? weighed[c] / plain[3] : plain[c] / all;
    plain[3] /= all;
    return plain;
}

TEST(Surface, SmallerLevelsAreMeansInLinearLight) {
    std::mt19937 random(3);
    for (const bool by_alpha : {false, true})
        for (const glm::ivec2 size :
             {glm::ivec2(8, 8), {16, 4}, {7, 5}, {13, 1}, {1, 6}, {9, 32}}) {
            const SurfaceTexture texture = random_texture(size, random);
            const std::vector<uint32_t> levels = smaller_levels(size, texture.texels, by_alpha);
            ASSERT_EQ(levels.size(), texels_from_level(size, 1));
            size_t next = 0;
            // A side that is odd on its way is covered by texels of equal size, level by level.
            for (int level = 1; level < level_count(size); ++level) {
                const glm::ivec2 side = gpu::level_size(size, level);
                const glm::dvec2 step = glm::dvec2(size) / glm::dvec2(side);
                for (int y = 0; y < side.y; ++y)
                    for (int x = 0; x < side.x; ++x) {
                        const auto mean = mean_of(texture, glm::dvec2(x, y) * step,
                                                  glm::dvec2(x + 1, y + 1) * step, by_alpha);
                        const uint32_t texel = levels[next++];
                        for (size_t c = 0; c < 3; ++c)
                            // Half a step of rounding, and that of floats.
                            EXPECT_NEAR(texel >> 8 * c & 0xff,
                                        255.0 * encode_srgb(static_cast<float>(mean[c])), 0.51)
                                << size.x << "x" << size.y << " level " << level;
                        EXPECT_NEAR(texel >> 24, 255.0 * mean[3], 0.51);
                    }
            }
        }
}

TEST(Surface, OneColourStaysItselfInEveryLevel) {
    for (uint32_t code = 0; code < 256; ++code) {
        const uint32_t texel = code * 0x01010101u;
        for (const uint32_t smaller :
             smaller_levels({5, 4}, std::vector<uint32_t>(20, texel), code % 2 == 0))
            EXPECT_EQ(smaller, texel);
    }
}

/// Textures of these sizes, a material for each; the first `masked` of them mask.
Scene scene_with_textures(const std::vector<glm::ivec2>& sizes, size_t masked) {
    Scene scene;
    for (size_t i = 0; i < sizes.size(); ++i) {
        SurfaceTexture texture;
        texture.size = sizes[i];
        scene.textures.push_back(texture);
        Material material;
        material.texture = static_cast<int>(i);
        material.alpha_cutoff = i < masked ? 0.5f : 0.0f;
        scene.materials.push_back(material);
    }
    return scene;
}

TEST(Surface, TexturesFollowEachOther) {
    Scene scene = scene_with_textures({{4, 4}, {8, 2}, {1, 1}}, 1);
    scene.textures.push_back({.size = {1024, 1024}}); // of no material
    const auto places = place_textures(scene, 1000);
    EXPECT_EQ(places[0].first_texel, 0u);
    EXPECT_EQ(places[1].first_texel, 21u);       // 16 + 4 + 1
    EXPECT_EQ(places[2].first_texel, 21u + 23u); // 16 + 4 + 2 + 1
    EXPECT_EQ(places[0].levels, 3);
    EXPECT_EQ(places[1].levels, 4);
    EXPECT_EQ(places[2].levels, 1);
    EXPECT_EQ(places[3].levels, 0);
    EXPECT_TRUE(places[0].masks);
    EXPECT_FALSE(places[1].masks);
}

TEST(Surface, WhereTexturesAreTooManyTheLargestLoseLevelsButNotMasks) {
    const Scene scene = scene_with_textures({{256, 256}, {64, 64}, {128, 128}}, 1);
    const size_t mask = texels_from_level({256, 256}, 0);
    const size_t small = texels_from_level({64, 64}, 0);
    const auto places = place_textures(scene, mask + 2 * small);
    EXPECT_EQ(places[0].first_level, 0);
    EXPECT_EQ(places[1].first_level, 0);
    EXPECT_EQ(places[2].first_level, 1);
    EXPECT_EQ(places[2].levels, 7);
    EXPECT_EQ(places[2].first_texel, mask + small);
    EXPECT_THROW(place_textures(scene, mask + 1), Error);
    EXPECT_EQ(place_textures(scene, mask + 2)[2].levels, 1);
}

} // namespace
} // namespace romascope
