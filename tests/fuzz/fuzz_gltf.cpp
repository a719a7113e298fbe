// SPDX-License-Identifier: MIT
// Any bytes are a scene that keeps its promises, or are refused in one line within the memory that
// was given: anything else ends the program. Run by libFuzzer, and by replay.cpp on single files.
#include "renderer/base/error.h"
#include "renderer/scene/gltf/import.h"
#include "tests/fuzz/drawn_inputs.h"
#include "tests/fuzz/heap_peak.h"
#include "tests/fuzz/scene_check.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

namespace {

using namespace romascope;

/// Small, so that what would need more is refused quickly and often.
constexpr size_t kMemory = size_t{32} << 20;
/// What is not counted: JSON, twice, in trees whose nodes take up to hundreds of bytes each.
constexpr size_t kUncounted = size_t{2} << 20;
constexpr size_t kUncountedPerByte = 512;

/// How many inputs came through; said at the end.
struct Tally {
    size_t drawn = 0, moving = 0, refused = 0;
    ~Tally() {
        std::fprintf(stderr, "drawn: %zu\nmoving: %zu\nrefused: %zu\n", drawn, moving, refused);
    }
} tally;

[[noreturn]] void fail(const std::string& what) {
    std::fprintf(stderr, "fuzz_gltf: %s\n", what.c_str());
    std::abort();
}

/// In a folder that does not exist: nothing beside the input can be read.
const std::filesystem::path kPath = "/nonexistent/romascope-fuzz/input.gltf";

/// Scenes alike in what they are made of, whatever the numbers are.
uint64_t kind_of(const Scene& scene) {
    const Motion& motion = scene.motion;
    uint64_t kind = 0;
    for (const size_t part :
         {scene.materials.size(), scene.textures.size(), scene.lights.size(), scene.cameras.size(),
          scene.colors.size(), scene.notices.size(), motion.nodes.size(), motion.parts.size(),
          motion.skins.size(), motion.animations.size(), motion.weights.size(),
          motion.influences.size(), motion.lights.size()})
        kind = kind * 5 + std::min<size_t>(part, 4);
    for (const Animation& animation : motion.animations)
        for (const MotionChannel& channel : animation.channels)
            kind = kind * 31 + 4 * static_cast<uint64_t>(channel.path) +
                   static_cast<uint64_t>(channel.interpolation);
    return kind;
}

void check_refusal(const Error& error) {
    const std::string_view line = error.what();
    if (error.exit_status() != kBadInput)
        fail("refused as if the program were at fault: " + std::string(line));
    if (!line.starts_with(kPath.string() + ": ") || line.size() < kPath.string().size() + 6)
        fail("a refusal that does not name file and reason: " + std::string(line));
    for (const char c : line)
        if (static_cast<unsigned char>(c) < 32)
            fail("a refusal of more than one line: " + std::string(line));
}

void check_memory(const fuzz::HeapPeak& heap, size_t size) {
    if (heap.bytes() > kMemory + kUncounted + kUncountedPerByte * size)
        fail("took " + std::to_string(heap.bytes()) + " bytes of " + std::to_string(kMemory));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    const std::string_view input(reinterpret_cast<const char*>(data), size);
    const fuzz::HeapPeak heap;
    try {
        const Scene scene = import_gltf(std::string(input), kPath, kMemory);
        check_memory(heap, size);
        if (const std::string promise = fuzz::broken_promise(scene); !promise.empty())
            fail("a scene breaks a promise: " + promise);
        ++tally.drawn;
        tally.moving += !scene.motion.parts.empty();
        fuzz::drawn_inputs().add(kind_of(scene), input);
    } catch (const Error& error) {
        check_memory(heap, size);
        check_refusal(error);
        ++tally.refused;
    }
    return 0;
}
