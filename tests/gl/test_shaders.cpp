// SPDX-License-Identifier: MIT
// Every shader variant is accepted by the driver and by the reference compiler, and no shader file
// is left out.
#include "renderer/base/embedded_text.h"
#include "renderer/base/files.h"
#include "renderer/frame/variants.h"
#include "tests/gl/gl_test.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <set>

namespace romascope {
namespace {

namespace fs = std::filesystem;

using ShadersTest = GlTest;

const char* extension_of(GLenum stage) {
    return stage == GL_COMPUTE_SHADER ? "comp" : stage == GL_VERTEX_SHADER ? "vert" : "frag";
}

TEST_F(ShadersTest, TheDriverTakesEveryVariant) {
    for (const ShaderVariant& variant : all_shader_variants()) {
        SCOPED_TRACE(variant.name);
        EXPECT_NO_THROW(Program(shaders_, variant));
    }
}

TEST(ShaderSources, TheReferenceCompilerTakesEveryVariant) {
    if (std::system("glslangValidator --version > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "glslangValidator is not installed (Debian: glslang-tools)";
    const ShaderLibrary library;
    const fs::path folder = fs::temp_directory_path() / fmt::format("romascope-{}", getpid());
    fs::create_directories(folder);
    size_t count = 0;
    for (const ShaderVariant& variant : all_shader_variants()) {
        for (const ShaderStage& stage : variant.stages) {
            const fs::path file = folder / fmt::format("{}.{}", count++, extension_of(stage.type));
            write_file_atomically(file, library.expand(variant, stage).text);
        }
    }
    EXPECT_GT(count, 10u);
    // Each file on its own: several on one command line would be linked together.
    size_t refused = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string one = fmt::format("glslangValidator {} > {}/log 2>&1",
                                            entry.path().string(), folder.string());
        if (std::system(one.c_str()) != 0) {
            ++refused;
            ADD_FAILURE() << read_text_file(folder / "log");
        }
    }
    EXPECT_EQ(refused, 0u);
    fs::remove_all(folder);
}

TEST(ShaderSources, EveryFileIsUsedByAVariant) {
    const ShaderLibrary library;
    std::set<std::string> used;
    for (const ShaderVariant& variant : all_shader_variants())
        for (const ShaderStage& stage : variant.stages)
            for (const std::string& file : library.expand(variant, stage).files)
                used.insert(file);
    for (const auto& [file, text] : embedded_shaders())
        EXPECT_TRUE(used.contains(std::string(file))) << file;
}

TEST(ShaderSources, LinesAfterAGroupThatIsLeftOutKeepTheirNumbers) {
    ShaderLibrary library;
    library.add("part.glsl", "int part;\n");
    library.add("whole.glsl",
                "#if CHOICE\n#include \"part.glsl\"\n  #else\nint other;\n#endif\nint late;\n");
    const std::string text =
        library.expand({"whole", {{GL_COMPUTE_SHADER, "whole.glsl"}}, {{"CHOICE", "0"}}, {}})
            .at(0)
            .text;
    // A compiler that leaves the include out sees no #line in it.
    EXPECT_NE(text.find("#else\n#line 4\nint other;\n#endif\n#line 6\nint late;\n"),
              std::string::npos)
        << text;
}

TEST(ShaderSources, LogsNameFilesWhateverTheDriver) {
    const std::vector<std::string> files = {"a.glsl", "b.glsl"};
    EXPECT_EQ(name_files_in_log("0:10012(3): error: x", files), "b.glsl:12: error: x");  // Mesa
    EXPECT_EQ(name_files_in_log("0(7) : error C0000", files), "a.glsl:7 : error C0000"); // NVIDIA
    EXPECT_EQ(name_files_in_log("ERROR: 0:10005: 'y'", files), "ERROR: b.glsl:5: 'y'");  // glslang
    EXPECT_EQ(name_files_in_log("0:50005: z", files), "0:50005: z");
}

} // namespace
} // namespace romascope
