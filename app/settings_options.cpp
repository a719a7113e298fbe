// SPDX-License-Identifier: MIT
#include "app/settings_options.h"

#include "renderer/base/error.h"
#include "renderer/frame/technique.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace romascope {
namespace {

void set_size(Settings& settings, const std::string& text) {
    const size_t x = text.find('x');
    const auto is_malformed = [](const std::string& number) {
        return number.find_first_not_of("-0123456789") != std::string::npos || number.empty();
    };
    if (x == std::string::npos || is_malformed(text.substr(0, x)) ||
        is_malformed(text.substr(x + 1)))
        throw Error(fmt::format("--size '{}' is not of the form WIDTHxHEIGHT, like 1280x720", text),
                    kBadInput);
    settings.set_text(kWidth.key(), text.substr(0, x));
    settings.set_text(kHeight.key(), text.substr(x + 1));
}

} // namespace

void SettingsOptions::add_to(CLI::App& command, const std::string& size_help,
                             const std::string& frames_help, Moments moments) {
    command
        .add_option("--technique", technique,
                    "methods and values by name, see 'romascope info --techniques'")
        ->type_name("NAME");
    // One value each time: another word after it is the scene.
    command.add_option("--config", configs, "TOML file of settings; may be repeated")
        ->type_name("FILE")
        ->allow_extra_args(false);
    command
        .add_option("--set", assignments,
                    "a setting, see 'romascope info --knobs'; may be repeated")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command
        .add_option("--camera", camera,
                    "a camera of the scene, or eye/target/vertical fov like 1,2,3/0,0,0/60")
        ->type_name("CAMERA");
    command.add_option("--size", size, size_help)->type_name("WxH");
    command.add_option("--frames", frames, frames_help)->type_name("N");
    command.add_option("--seed", seed, "of every random choice")->type_name("N");
    command.add_option("--time", time, "seconds into the animation, in the first frame")
        ->type_name("SECONDS");
    CLI::Option* course =
        command
            .add_option("--fps", fps,
                        "let time go on, so many frames a second; else it stands still")
            ->type_name("N");
    if (moments == Moments::one)
        course->group(""); // it is known, so that it is refused in a word, but not in the help
    command
        .add_option("--animation", animation,
                    "an animation of the scene by name or number, or none; else the first")
        ->type_name("NAME");
}

Settings SettingsOptions::apply_to(Settings settings) const {
    if (!technique.empty())
        apply_technique(settings, technique);
    for (const std::filesystem::path& config : configs)
        settings.load_toml(config);
    if (!camera.empty())
        settings.set(kCamera, camera);
    if (!size.empty())
        set_size(settings, size);
    for (const auto& [knob, text] :
         {std::pair<const KnobBase&, const std::string&>{kFrames, frames},
          {kSeed, seed},
          {kTime, time},
          {kFps, fps},
          {kAnimation, animation}})
        if (!text.empty())
            settings.set_text(knob.key(), text);
    for (const std::string& assignment : assignments)
        settings.set_assignment(assignment);
    return settings;
}

bool SettingsOptions::decide(const KnobBase& knob, const std::vector<std::string>& values) const {
    std::vector<KnobValue> after;
    for (const std::string& value : values) {
        Settings before(all_knobs());
        before.set_text(knob.key(), value);
        after.push_back(apply_to(before).value(knob));
    }
    return std::ranges::adjacent_find(after, std::ranges::not_equal_to()) == after.end();
}

void check_one_moment(const Settings& settings) {
    if (settings.get(kFps) != 0.0)
        throw Error("--fps: all rays are of one moment; choose it with --time", kBadInput);
}

} // namespace romascope
