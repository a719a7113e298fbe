// SPDX-License-Identifier: MIT
#include "app/viewer/render_command.h"

#include "app/scene_files.h"
#include "renderer/frame/technique.h"

#include <fmt/format.h>

#include <algorithm>

namespace romascope {
namespace fs = std::filesystem;
namespace {

std::string quoted(const std::string& word) {
    const auto is_plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view("_-+=./,:@%").find(c) != std::string_view::npos;
    };
    if (!word.empty() && std::ranges::all_of(word, is_plain))
        return word;
    std::string out = "'";
    for (const char c : word)
        if (c == '\'')
            out += "'\\''";
        else
            out += c;
    return out + "'";
}

std::string scene_word(const fs::path& file) {
    std::error_code code;
    for (const BuiltInScene& scene : built_in_scenes())
        if (fs::equivalent(scene.file, file, code))
            return scene.name;
    const fs::path absolute = fs::absolute(file, code);
    return code ? file.string() : absolute.string();
}

} // namespace

std::string render_command(const fs::path& scene_file, const Settings& settings, uint32_t frames,
                           const fs::path& shaders) {
    std::string line = fmt::format("romascope render {} -o romascope.png --size {}x{} --frames {}",
                                   quoted(scene_word(scene_file)), settings.get(kWidth),
                                   settings.get(kHeight), std::max(frames, 1u));
    if (const std::string camera = settings.get(kCamera); !camera.empty())
        line += fmt::format(" --camera={}", quoted(camera));
    const KnobBase* const elsewhere[] = {&kWidth, &kHeight, &kFrames, &kCamera,
                                         &kFps}; // the time is where the course of it has got to
    for (const KnobBase* knob : settings.table().all())
        if (!settings.is_default(*knob) &&
            std::ranges::find(elsewhere, knob) == std::end(elsewhere))
            line += fmt::format(" --set {}", quoted(fmt::format("{}={}", knob->key(),
                                                                to_text(settings.value(*knob)))));
    if (!shaders.empty()) {
        std::error_code code;
        const fs::path absolute = fs::absolute(shaders, code);
        line += fmt::format(" --shaders {}", quoted((code ? shaders : absolute).string()));
    }
    return line;
}

} // namespace romascope
