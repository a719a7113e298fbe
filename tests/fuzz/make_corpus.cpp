// SPDX-License-Identifier: MIT
// make_corpus FOLDER: writes the files that fuzzing starts from, all of them valid.
#include "tests/fuzz/seeds.h"

#include <cstdio>
#include <exception>

int main(int count, char** words) {
    if (count != 2) {
        std::fputs("usage: make_corpus FOLDER\n", stderr);
        return 2;
    }
    try {
        const std::filesystem::path folder = words[1];
        std::filesystem::create_directories(folder);
        romascope::fuzz::write_mesh_seeds(folder);
        romascope::fuzz::write_surface_seeds(folder);
        romascope::fuzz::write_motion_seeds(folder);
        romascope::fuzz::write_compressed_seeds(folder);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "make_corpus: %s\n", error.what());
        return 1;
    }
    return 0;
}
