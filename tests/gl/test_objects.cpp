// SPDX-License-Identifier: MIT
#include "renderer/base/error.h"
#include "renderer/gl/capabilities.h"
#include "renderer/gl/program.h"
#include "tests/gl/gl_test.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace romascope {
namespace {

using ObjectsTest = GlTest;

TEST_F(ObjectsTest, BufferKeepsWhatIsUploaded) {
    const std::vector<uint32_t> data = {1, 2, 3, 0xFFFFFFFFu};
    Buffer buffer = Buffer::from("test", std::span(data));
    EXPECT_EQ(buffer.download<uint32_t>(), data);
    const uint32_t seven = 7;
    buffer.upload(std::as_bytes(std::span(&seven, 1)), 4);
    EXPECT_EQ(buffer.download<uint32_t>(), (std::vector<uint32_t>{1, 7, 3, 0xFFFFFFFFu}));
}

TEST_F(ObjectsTest, NewBufferIsZero) {
    const Buffer buffer("test", 64);
    EXPECT_EQ(buffer.download<uint32_t>(), std::vector<uint32_t>(16, 0u));
}

TEST_F(ObjectsTest, ALargeNewBufferKeepsWhatIsUploadedAtOnce) {
    // Large, as drivers take other ways for that.
    const std::vector<uint32_t> ones(1 << 18, 1u);
    for (int trial = 0; trial < 10; ++trial) {
        Buffer buffer("test", 3 * ones.size() * 4);
        buffer.upload(std::as_bytes(std::span(ones)), 4 * ones.size());
        const std::vector<uint32_t> found = buffer.download<uint32_t>();
        EXPECT_EQ(std::count(found.begin(), found.end(), 1u), std::ssize(ones));
        EXPECT_EQ(
            std::count(found.begin() + std::ssize(ones), found.begin() + 2 * std::ssize(ones), 1u),
            std::ssize(ones));
        EXPECT_EQ(std::count(found.begin(), found.end(), 0u), 2 * std::ssize(ones));
    }
}

TEST_F(ObjectsTest, MovedFromOwnersAreEmpty) {
    Buffer a("test", 16);
    const GLuint id = a.id();
    const Buffer b = std::move(a);
    EXPECT_EQ(b.id(), id);
    EXPECT_EQ(a.id(), 0u); // NOLINT: a moved-from owner is promised to be empty
    EXPECT_TRUE(glIsBuffer(id));
}

TEST_F(ObjectsTest, DestroyedOwnersDeleteTheirObject) {
    GLuint id = 0;
    {
        const Texture texture("test", GL_TEXTURE_2D, GL_R32F, {4, 4, 1});
        id = texture.id();
        EXPECT_TRUE(glIsTexture(id));
    }
    EXPECT_FALSE(glIsTexture(id));
}

TEST_F(ObjectsTest, TextureIsReadInOrder) {
    Texture texture("test", GL_TEXTURE_3D, GL_R32UI, {2, 3, 2});
    std::vector<GLuint> data(12);
    for (GLuint i = 0; i < 12; ++i)
        data[i] = i * i;
    glTextureSubImage3D(texture.id(), 0, 0, 0, 0, 2, 3, 2, GL_RED_INTEGER, GL_UNSIGNED_INT,
                        data.data());
    EXPECT_EQ(texture.download_uint(1), data);
    texture.clear_uint(5);
    EXPECT_EQ(texture.download_uint(1), std::vector<GLuint>(12, 5u));
    EXPECT_EQ(texture.bytes(), 48u);
}

TEST_F(ObjectsTest, TooLargeATextureIsAnErrorThatNamesIt) {
    try {
        const Texture texture("huge thing", GL_TEXTURE_2D, GL_RGBA32F, {1 << 20, 1 << 20, 1});
        FAIL() << "the driver took it";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("huge thing"), std::string::npos);
    }
    log_.emplace(); // the driver's own message about it is what was provoked
}

TEST_F(ObjectsTest, ShaderErrorsNameFileAndLine) {
    shaders_.add("outer.glsl", "// one\n#include \"inner.glsl\"\nvoid main() {}\n");
    shaders_.add("inner.glsl", "float fine;\n\nfloat broken = nonsense;\n");
    try {
        const Program program(shaders_, {"broken", {{GL_COMPUTE_SHADER, "outer.glsl"}}, {}, {}});
        FAIL() << "it compiled";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("inner.glsl:3"), std::string::npos)
            << error.what();
    }
    log_.emplace();
}

TEST_F(ObjectsTest, LinesAfterAnIncludeKeepTheirNumber) {
    shaders_.add("outer.glsl", "\n#include \"inner.glsl\"\nfloat broken = nonsense;\n");
    shaders_.add("inner.glsl", "float a;\nfloat b;\nfloat c;\n");
    try {
        const Program program(shaders_, {"broken", {{GL_COMPUTE_SHADER, "outer.glsl"}}, {}, {}});
        FAIL() << "it compiled";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("outer.glsl:3"), std::string::npos)
            << error.what();
    }
    log_.emplace();
}

TEST_F(ObjectsTest, MissingIncludeNamesTheIncludingLine) {
    shaders_.add("outer.glsl", "\n#include \"nowhere.glsl\"\n");
    try {
        const Program program(shaders_, {"broken", {{GL_COMPUTE_SHADER, "outer.glsl"}}, {}, {}});
        FAIL() << "it compiled";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("outer.glsl:2"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("nowhere.glsl"), std::string::npos);
    }
}

TEST_F(ObjectsTest, AFailedChangeKeepsTheOldProgram) {
    shaders_.add("good.glsl", "layout(local_size_x = 1) in;\nvoid main() {}\n");
    shaders_.add("bad.glsl", "nonsense\n");
    ProgramSlot slot;
    const ShaderVariant good{"test", {{GL_COMPUTE_SHADER, "good.glsl"}}, {}, {}};
    const GLuint id = slot.get(shaders_, good).id();
    EXPECT_THROW(slot.get(shaders_, {"test", {{GL_COMPUTE_SHADER, "bad.glsl"}}, {}, {}}), Error);
    EXPECT_EQ(slot.get(shaders_, good).id(), id);
    log_.emplace();
}

TEST_F(ObjectsTest, TimerCountsEveryPass) {
    for (int i = 0; i < 5; ++i) {
        auto pass = timer_->compute("work");
        glFinish();
    }
    { auto pass = timer_->raster("drawing"); }
    timer_->finish();
    ASSERT_EQ(timer_->timings().size(), 2u);
    EXPECT_EQ(timer_->timings()[0].pass, "work");
    EXPECT_FALSE(timer_->timings()[0].rasterises);
    EXPECT_TRUE(timer_->timings()[1].rasterises);
    if (timer_->clock() == TimerClock::none)
        GTEST_SKIP() << "this driver has no timestamps";
    EXPECT_EQ(timer_->timings()[0].milliseconds.size(), 5u);
    for (const double ms : timer_->timings()[0].milliseconds)
        EXPECT_GE(ms, 0.0);
}

TEST_F(ObjectsTest, ShortPassesAreTimedInBatches) {
    if (timer_->clock() == TimerClock::none)
        GTEST_SKIP() << "this driver has no timestamps";
    int short_done = 0, long_done = 0;
    const auto frame = [&] {
        {
            auto pass = timer_->compute("short");
            pass.repeat([&] { ++short_done; });
        }
        {
            auto pass = timer_->compute("long");
            pass.repeat([&] { ++long_done; });
        }
        auto pass = timer_->compute("short, once");
    };
    frame();
    EXPECT_EQ(short_done, 1); // nobody has asked yet
    // An hour: all are short.
    timer_->clear_and_batch(3.6e6, 10);
    EXPECT_TRUE(timer_->timings().empty());
    frame();
    frame();
    timer_->clear(); // batches outlive it
    frame();
    EXPECT_EQ(short_done, 31);
    EXPECT_EQ(long_done, 31);
    timer_->finish();
    ASSERT_EQ(timer_->timings().size(), 3u);
    EXPECT_EQ(timer_->timings()[0].batch, 10);
    EXPECT_EQ(timer_->timings()[2].batch, 1); // it does not repeat
    EXPECT_EQ(timer_->timings()[0].milliseconds.size(), 1u);
    // No time is below none.
    PassTimer other;
    { auto pass = other.compute("short"); }
    other.clear_and_batch(0.0, 10);
    {
        auto pass = other.compute("short");
        pass.repeat([&] { ++long_done; });
    }
    EXPECT_EQ(long_done, 32);
}

TEST_F(ObjectsTest, ABatchIsDividedByItsSize) {
    PassTimer timer(TimerClock::cpu_with_finish);
    const auto wait = [] { std::this_thread::sleep_for(std::chrono::milliseconds(2)); };
    timer.compute("wait").repeat(wait);
    timer.clear_and_batch(3.6e6, 20);
    timer.compute("wait").repeat(wait);
    // 20 waits of 2 ms, not 40 ms; a machine that is busy may take longer, but not twenty times.
    EXPECT_GE(timer.timings()[0].median(), 2.0);
    EXPECT_LT(timer.timings()[0].median(), 30.0);
}

TEST_F(ObjectsTest, SoftwareRasterisersAreTimedByTheCpu) {
    const bool software = query_driver().software;
    EXPECT_EQ(software, timer_->clock() == TimerClock::cpu_with_finish);
}

TEST(PassTimingTest, QuantilesAreThoseOfTheSortedTimes) {
    PassTiming timing{"pass", false, {5, 1, 4, 2, 3}};
    EXPECT_DOUBLE_EQ(timing.median(), 3.0);
    EXPECT_DOUBLE_EQ(timing.percentile_95(), 4.8);
    timing.milliseconds = {2, 1};
    EXPECT_DOUBLE_EQ(timing.median(), 1.5);
}

} // namespace
} // namespace romascope
