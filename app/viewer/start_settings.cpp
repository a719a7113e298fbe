// SPDX-License-Identifier: MIT
#include "app/viewer/start_settings.h"

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/frame/technique.h"

#include <fmt/format.h>

namespace romascope {
namespace fs = std::filesystem;

fs::path start_settings_file() { return config_directory() / "viewer.toml"; }

bool has_start_settings() {
    std::error_code code;
    return fs::exists(start_settings_file(), code);
}

bool load_start_settings(Settings& settings) {
    if (!has_start_settings())
        return false;
    try {
        settings.load_toml(start_settings_file());
    } catch (const Error& error) {
        throw Error(fmt::format("{} ('romascope view --defaults' starts without it)", error.what()),
                    error.exit_status());
    }
    return true;
}

void save_start_settings(const Settings& settings) {
    Settings kept = settings;
    for (const KnobBase* knob : std::initializer_list<const KnobBase*>{
             &kCamera, &kTime, &kFps, &kAnimation, &kWidth, &kHeight})
        kept.reset(*knob);
    write_file_atomically(start_settings_file(), kept.changes_to_toml());
}

bool forget_start_settings() {
    std::error_code code;
    const bool removed = fs::remove(start_settings_file(), code);
    if (code)
        throw Error(
            fmt::format("cannot remove {}: {}", start_settings_file().string(), code.message()));
    return removed;
}

} // namespace romascope
