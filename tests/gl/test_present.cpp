// SPDX-License-Identifier: MIT
// What a window shows is what a PNG holds.
#include "renderer/image/color.h"
#include "renderer/passes/present.h"
#include "tests/gl/gl_test.h"

#include <bit>
#include <cmath>
#include <limits>

namespace romascope {
namespace {

using Rgba8 = glm::u8vec4;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr Rgba8 kMagenta(255, 0, 255, 255);
constexpr Rgba8 kBlack(0, 0, 0, 255);

class PresentTest : public GlTest {
protected:
    static Texture upload(const std::vector<float>& data, int channels, glm::ivec2 size) {
        Texture texture("linear", GL_TEXTURE_2D, channels == 1 ? GL_R32F : GL_RGBA32F,
                        glm::ivec3(size, 1));
        glTextureSubImage2D(texture.id(), 0, 0, 0, size.x, size.y, channels == 1 ? GL_RED : GL_RGBA,
                            GL_FLOAT, data.data());
        return texture;
    }
    static std::vector<Rgba8> download(const Texture& texture) {
        std::vector<Rgba8> pixels(static_cast<size_t>(texture.size().x) * texture.size().y);
        glGetTextureImage(texture.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                          static_cast<GLsizei>(pixels.size() * sizeof(Rgba8)), pixels.data());
        return pixels;
    }
    std::vector<Rgba8> present(const Texture& linear) {
        return download(present_.run(shaders_, *timer_, linear));
    }

    /// A picture in which every texel tells its place: red its column, green its row.
    static Texture map_of(glm::ivec2 size) {
        Texture texture("map", GL_TEXTURE_2D, GL_RGBA8, glm::ivec3(size, 1));
        std::vector<Rgba8> pixels;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                pixels.emplace_back(x, y, 255, 255);
        glTextureSubImage2D(texture.id(), 0, 0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE,
                            pixels.data());
        return texture;
    }
    /// What a framebuffer of that size shows, its top row first, as on a screen.
    static std::vector<Rgba8> shown(const Texture& picture, glm::ivec2 size) {
        const Texture target("window", GL_TEXTURE_2D, GL_RGBA8, glm::ivec3(size, 1));
        const Texture* const colors[] = {&target};
        const Framebuffer framebuffer("window", colors, nullptr);
        show(picture, framebuffer.id(), size);
        const std::vector<Rgba8> rows = download(target);
        std::vector<Rgba8> flipped;
        for (int y = size.y - 1; y >= 0; --y)
            flipped.insert(flipped.end(), rows.begin() + y * size.x,
                           rows.begin() + (y + 1) * size.x);
        return flipped;
    }

    Present present_;
};

/// Numbers of all sizes and signs, and those next to where the code changes.
std::vector<float> telling_numbers() {
    std::vector<float> numbers = {0.0f,  -0.0f,  1.0f,  0.5f,      2.0f,
                                  -1.0f, 1e-40f, 3e38f, kInfinity, -kInfinity};
    for (const float threshold : srgb8_thresholds())
        for (const float number :
             {threshold, std::nextafter(threshold, 2.0f), std::nextafter(threshold, -1.0f)})
            numbers.push_back(number);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> usual(-0.1f, 1.1f);
    for (int i = 0; i < 20000; ++i)
        numbers.push_back(usual(random));
    while (numbers.size() < 200 * 200)
        if (const auto any = std::bit_cast<float>(static_cast<uint32_t>(random()));
            !std::isnan(any))
            numbers.push_back(any);
    return numbers;
}

TEST_F(PresentTest, OneChannelIsEncodedAsInAPng) {
    const std::vector<float> numbers = telling_numbers();
    const std::vector<Rgba8> pixels = present(upload(numbers, 1, {200, 200}));
    for (size_t i = 0; i < numbers.size(); ++i) {
        const uint8_t code = encode_srgb8(numbers[i]);
        ASSERT_EQ(pixels[i], Rgba8(code, code, code, 255)) << numbers[i];
    }
}

TEST_F(PresentTest, ColoursAreEncodedAsInAPng) {
    const std::vector<float> numbers = telling_numbers(); // alpha among them
    const std::vector<Rgba8> pixels = present(upload(numbers, 4, {100, 100}));
    for (size_t i = 0; i < pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            ASSERT_EQ(pixels[i][c], encode_srgb8(numbers[4 * i + static_cast<size_t>(c)]));
}

TEST_F(PresentTest, NanIsMagenta) {
    const float negative_nan = std::bit_cast<float>(0xFFC00001u);
    EXPECT_EQ(present(upload({0.5f, kNan, negative_nan, kInfinity}, 1, {4, 1})),
              (std::vector<Rgba8>{Rgba8(188, 188, 188, 255), kMagenta, kMagenta, Rgba8(255)}));
    EXPECT_EQ(
        present(upload({kNan, 0, 0, 1, 0, kNan, 0, 1, 0, 0, kNan, 1, 0, 0, 0, kNan}, 4, {4, 1})),
        (std::vector<Rgba8>{kMagenta, kMagenta, kMagenta, kBlack}));
}

TEST_F(PresentTest, ThePipelineShowsThePictureItWouldWrite) {
    const Scene scene = scene_of_triangles(rectangle({0, 0, 0}, {0, 1, 0}, 1.0f));
    Pipeline pipeline(scene, ShaderLibrary());
    EXPECT_EQ(pipeline.shown().size().x, 0) << "there is no frame";
    Settings settings(all_knobs());
    settings.set(kWidth, 37);
    settings.set(kHeight, 23);
    for (const PictureKind kind : {PictureKind::lit, PictureKind::ambient_occlusion}) {
        settings.set(kView, kind);
        pipeline.render(settings, scene.cameras.front());
        pipeline.render(settings, scene.cameras.front());
        const Image picture = pipeline.picture();
        const std::vector<Rgba8> pixels = download(pipeline.shown());
        ASSERT_EQ(pixels.size(), 37u * 23u);
        for (size_t i = 0; i < pixels.size(); ++i)
            for (size_t c = 0; c < 3; ++c)
                ASSERT_EQ(pixels[i][static_cast<int>(c)],
                          encode_srgb8(picture.channels == 1 ? picture.data[i]
                                                             : picture.data[3 * i + c]));
    }
}

TEST_F(PresentTest, EqualSizesAreShownTexelForPixelTopUp) {
    const glm::ivec2 size(19, 11);
    const Texture map = map_of(size);
    EXPECT_EQ(shown(map, size), download(map));
}

TEST_F(PresentTest, OtherSizesAreFittedInTheMiddle) {
    struct Case {
        glm::ivec2 picture, window, corner, fitted;
    };
    for (const Case& c :
         {Case{{20, 10}, {60, 50}, {0, 10}, {60, 30}}, Case{{20, 10}, {70, 20}, {15, 0}, {40, 20}},
          Case{{40, 40}, {10, 30}, {0, 10}, {10, 10}}, Case{{200, 1}, {3, 3}, {0, 1}, {3, 1}}}) {
        const std::vector<Rgba8> pixels = shown(map_of(c.picture), c.window);
        for (int y = 0; y < c.window.y; ++y) {
            for (int x = 0; x < c.window.x; ++x) {
                const glm::ivec2 place = glm::ivec2(x, y) - c.corner;
                const bool inside = glm::all(glm::greaterThanEqual(place, glm::ivec2(0))) &&
                                    glm::all(glm::lessThan(place, c.fitted));
                const Rgba8 pixel = pixels[static_cast<size_t>(y * c.window.x + x)];
                ASSERT_EQ(pixel.z, inside ? 255 : 0) << x << " " << y;
                if (!inside)
                    continue;
                // The texel at the pixel's place, up to interpolation with its neighbours.
                const glm::vec2 texel =
                    (glm::vec2(place) + 0.5f) * glm::vec2(c.picture) / glm::vec2(c.fitted) - 0.5f;
                EXPECT_NEAR(pixel.x, texel.x, 1.0f) << x << " " << y;
                EXPECT_NEAR(pixel.y, texel.y, 1.0f) << x << " " << y;
            }
        }
    }
}

TEST_F(PresentTest, WithoutAPictureAllIsBlack) {
    EXPECT_EQ(shown(Texture(), {3, 2}), std::vector<Rgba8>(6, kBlack));
    show(Texture(), 0, {0, 0});
}

} // namespace
} // namespace romascope
