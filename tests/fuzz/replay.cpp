// SPDX-License-Identifier: MIT
// fuzz_replay [--drawn] FILE_OR_FOLDER...: runs the fuzzing target once on each file, without
// libFuzzer. --drawn: files that are refused count as failures.
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/scene/gltf/import.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_in(const fs::path& place) {
    if (!fs::is_directory(place))
        return {place};
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(place))
        if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

bool drawn(const fs::path& file) {
    try {
        romascope::load_gltf(file);
        return true;
    } catch (const romascope::Error& error) {
        std::fprintf(stderr, "refused: %s\n", error.what());
        return false;
    }
}

} // namespace

int main(int count, char** words) {
    bool all_drawn = false;
    size_t tried = 0, failed = 0;
    for (int i = 1; i < count; ++i) {
        if (std::strcmp(words[i], "--drawn") == 0) {
            all_drawn = true;
            continue;
        }
        for (const fs::path& file : files_in(words[i])) {
            std::printf("%s\n", file.c_str());
            std::fflush(stdout); // stands last before a crash
            const std::string content = romascope::read_text_file(file);
            LLVMFuzzerTestOneInput(reinterpret_cast<const uint8_t*>(content.data()),
                                   content.size());
            failed += all_drawn && !drawn(file);
            ++tried;
        }
    }
    std::printf("%zu files tried, %zu failed\n", tried, failed);
    return tried == 0 || failed > 0 ? 1 : 0;
}
