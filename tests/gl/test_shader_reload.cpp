// SPDX-License-Identifier: MIT
// Programs follow the files of a shader folder; what is broken goes on as it was.
#include "renderer/base/embedded_text.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "tests/gl/gl_test.h"

#include <fmt/format.h>

#include <filesystem>
#include <unistd.h>

namespace romascope {
namespace {

namespace fs = std::filesystem;

class ShaderReloadTest : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        folder_ = fs::temp_directory_path() / fmt::format("romascope-reload-{}", getpid());
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        library_ = ShaderLibrary(folder_);
    }
    void TearDown() override {
        fs::remove_all(folder_);
        log_.emplace(); // some drivers speak of what does not compile
        GlTest::TearDown();
    }

    /// A second later than what was written before, as clocks of files may be coarse.
    void write(const std::string& file, const std::string& text) {
        fs::create_directories((folder_ / file).parent_path());
        write_file_atomically(folder_ / file, text);
        touch(file);
    }
    void touch(const std::string& file) {
        fs::last_write_time(folder_ / file, now_ += std::chrono::seconds(1));
    }
    void write_answer(const std::string& expression) {
        write("main.glsl", fmt::format("#include \"value.glsl\"\n"
                                       "layout(local_size_x = 1) in;\n"
                                       "layout(std430, binding = 0) buffer Out {{ uint x; }};\n"
                                       "void main() {{ x = {}; }}\n",
                                       expression));
    }

    GLuint program() { return slot_.get(library_, variant_).id(); }
    GLuint answer() {
        const Program& made = slot_.get(library_, variant_);
        const Buffer out("answer", 4);
        made.use();
        out.bind(GL_SHADER_STORAGE_BUFFER, 0);
        made.dispatch_covering({1, 1, 1});
        return out.download<GLuint>()[0];
    }
    std::string only_fault() {
        const std::vector<std::string> faults = library_.take_faults();
        EXPECT_EQ(faults.size(), 1u);
        return faults.empty() ? std::string() : faults.front();
    }

    const ShaderVariant variant_{"answer", {{GL_COMPUTE_SHADER, "main.glsl"}}, {}, {}};
    fs::path folder_;
    fs::file_time_type now_ = fs::file_time_type::clock::now();
    ShaderLibrary library_;
    ProgramSlot slot_;
};

TEST_F(ShaderReloadTest, AChangeIsFollowedAfterTheNextLookOnly) {
    write("value.glsl", "uint value() { return 1u; }\n");
    write_answer("value()");
    EXPECT_EQ(answer(), 1u);
    EXPECT_FALSE(library_.refresh());
    write_answer("value() + 1u");
    EXPECT_EQ(answer(), 1u);
    EXPECT_TRUE(library_.refresh());
    EXPECT_EQ(answer(), 2u);
    EXPECT_FALSE(library_.refresh());
    EXPECT_TRUE(library_.take_faults().empty());
}

TEST_F(ShaderReloadTest, AnIncludedFileIsFollowed) {
    write("value.glsl", "uint value() { return 1u; }\n");
    write_answer("value()");
    EXPECT_EQ(answer(), 1u);
    write("value.glsl", "uint value() { return 7u; }\n");
    EXPECT_TRUE(library_.refresh());
    EXPECT_EQ(answer(), 7u);
}

TEST_F(ShaderReloadTest, AFileThatIsIncludedOnlyNowIsFollowed) {
    write("value.glsl", "uint value() { return 1u; }\n");
    write_answer("value()");
    EXPECT_EQ(answer(), 1u);
    write("deeper.glsl", "uint deeper() { return 3u; }\n");
    write("value.glsl", "#include \"deeper.glsl\"\nuint value() { return deeper(); }\n");
    EXPECT_TRUE(library_.refresh());
    EXPECT_EQ(answer(), 3u);
    write("deeper.glsl", "uint deeper() { return 4u; }\n");
    EXPECT_TRUE(library_.refresh());
    EXPECT_EQ(answer(), 4u);
}

TEST_F(ShaderReloadTest, TheSameTextIsNotCompiledAgain) {
    write("value.glsl", "uint value() { return 1u; }\n");
    write_answer("value()");
    const GLuint before = program();
    touch("value.glsl");
    EXPECT_TRUE(library_.refresh());
    EXPECT_EQ(program(), before);
    write_answer("value() + 1u");
    EXPECT_TRUE(library_.refresh());
    EXPECT_NE(program(), before) << "the text is another";
}

TEST_F(ShaderReloadTest, AFileThatNoProgramReadsIsNoChange) {
    write("value.glsl", "uint value() { return 1u; }\n");
    write_answer("value()");
    EXPECT_EQ(answer(), 1u);
    write("notes.txt", "x");
    EXPECT_FALSE(library_.refresh());
}

TEST_F(ShaderReloadTest, WhatBreaksGoesOnAndIsNamedOnceUntilMended) {
    write("value.glsl", "uint value() { return 1u; }\n");
    write_answer("value()");
    const GLuint before = program();
    write("value.glsl", "\n\nuint value() { return nonsense; }\n");
    EXPECT_TRUE(library_.refresh());
    EXPECT_EQ(program(), before);
    const std::string fault = only_fault();
    EXPECT_NE(fault.find("value.glsl:3"), std::string::npos) << fault;
    EXPECT_NE(fault.find("'answer'"), std::string::npos) << fault;
    EXPECT_EQ(answer(), 1u);
    EXPECT_TRUE(library_.take_faults().empty()) << "not tried again until a file changes";
    touch("main.glsl");
    EXPECT_TRUE(library_.refresh());
    EXPECT_EQ(program(), before);
    EXPECT_NE(only_fault().find("value.glsl:3"), std::string::npos) << "still at fault";

    write("value.glsl", "uint value() { return 5u; }\n");
    EXPECT_TRUE(library_.refresh());
    EXPECT_EQ(answer(), 5u);
    EXPECT_TRUE(library_.take_faults().empty());
}

TEST_F(ShaderReloadTest, HalfAFileIsAFault) {
    write("value.glsl", "uint value() { return 1u; }\n");
    write_answer("value()");
    const GLuint before = program();
    const std::string whole = read_text_file(folder_ / "main.glsl");
    for (size_t length = 0; length + 3 < whole.size(); length += 11) {
        write("main.glsl", whole.substr(0, length));
        EXPECT_TRUE(library_.refresh());
        EXPECT_EQ(program(), before) << length;
        EXPECT_NE(only_fault().find("main.glsl"), std::string::npos) << length;
    }
    write("main.glsl", whole);
    EXPECT_TRUE(library_.refresh());
    EXPECT_EQ(program(), before) << "it is what was compiled";
    EXPECT_TRUE(library_.take_faults().empty());
}

TEST_F(ShaderReloadTest, AMissingFileOrFolderIsAFault) {
    write("value.glsl", "uint value() { return 1u; }\n");
    write_answer("value()");
    const GLuint before = program();
    fs::remove(folder_ / "value.glsl");
    EXPECT_TRUE(library_.refresh());
    EXPECT_EQ(program(), before);
    EXPECT_NE(only_fault().find("main.glsl:1: cannot include value.glsl"), std::string::npos);
    EXPECT_FALSE(library_.refresh());

    fs::create_directory(folder_ / "value.glsl"); // something, but no file
    library_.refresh();
    EXPECT_EQ(program(), before);
    fs::remove_all(folder_);
    EXPECT_TRUE(library_.refresh());
    library_.take_faults();
    EXPECT_EQ(program(), before);
    EXPECT_NE(only_fault().find("main.glsl"), std::string::npos);

    write("value.glsl", "uint value() { return 6u; }\n");
    write_answer("value()");
    EXPECT_TRUE(library_.refresh());
    EXPECT_EQ(answer(), 6u);
}

TEST_F(ShaderReloadTest, WhatNeverCompiledIsRefusedUntilMended) {
    write_answer("value()"); // value.glsl is missing
    for (int i = 0; i < 2; ++i)
        EXPECT_THROW(program(), Error);
    write("value.glsl", "uint value() { return nonsense; }\n");
    EXPECT_THROW(program(), Error) << "as before the look";
    EXPECT_TRUE(library_.refresh()) << "a file that was missed is there";
    try {
        program();
        ADD_FAILURE() << "it compiled";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("value.glsl:1"), std::string::npos);
    }
    write("value.glsl", "uint value() { return 9u; }\n");
    EXPECT_TRUE(library_.refresh());
    EXPECT_EQ(answer(), 9u);
}

TEST_F(ShaderReloadTest, ThePipelineShowsWhatTheFilesSay) {
    for (const auto& [file, text] : embedded_shaders())
        write(std::string(file), std::string(text));
    const Scene scene = scene_of_triangles(rectangle({0, 0, 0}, {0, 1, 0}, 1.0f));
    Pipeline pipeline(scene, library_);
    Settings settings(all_knobs());
    settings.set(kWidth, 16);
    settings.set(kHeight, 16);
    settings.set(kView, PictureKind::base_color);
    const auto middle = [&] {
        pipeline.render(settings, scene.cameras.front());
        return pipeline.picture().at(8, 8, 1);
    };
    EXPECT_FLOAT_EQ(middle(), 1.0f);
    EXPECT_FALSE(pipeline.reload_shaders());
    EXPECT_FLOAT_EQ(middle(), 1.0f);
    EXPECT_EQ(pipeline.frame_count(), 2u);

    const std::string file = "passes/compose.comp.glsl";
    const std::string good = read_text_file(folder_ / file);
    const std::string last = "imageStore(picture, pixel, vec4(color, 1.0));";
    std::string half = good;
    half.replace(half.find(last), last.size(), "imageStore(picture, pixel, vec4(color * 0.5, 1));");
    write(file, half);
    EXPECT_TRUE(pipeline.reload_shaders());
    EXPECT_FLOAT_EQ(middle(), 0.5f);
    EXPECT_EQ(pipeline.frame_count(), 1u) << "the mean started anew";
    EXPECT_TRUE(pipeline.take_shader_faults().empty());

    write(file, half + "nonsense\n");
    EXPECT_TRUE(pipeline.reload_shaders());
    EXPECT_FLOAT_EQ(middle(), 0.5f);
    const std::vector<std::string> faults = pipeline.take_shader_faults();
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_NE(faults[0].find(file), std::string::npos) << faults[0];

    write(file, good);
    EXPECT_TRUE(pipeline.reload_shaders());
    EXPECT_FLOAT_EQ(middle(), 1.0f);
}

} // namespace
} // namespace romascope
