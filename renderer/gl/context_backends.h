// SPDX-License-Identifier: MIT
// What the three makers of contexts share. Only for the files context*.cpp.
#pragma once

#include "renderer/gl/context.h"

#include <utility>

namespace romascope {

/// Versions to ask for, best first. The last one is too old; it is asked for only so that the
/// refusal can name what the driver lacks.
inline constexpr std::pair<int, int> kGlVersions[] = {{4, 6}, {4, 5}, {3, 2}};

struct EglDevice {
    std::string label;     ///< e.g. "/dev/dri/card0" or "software"
    bool software = false; ///< it says of itself that it renders on the CPU
};

/// Loads EGL if it is there. Throws Error if not.
std::vector<EglDevice> list_egl_devices();

/// `device`: index into list_egl_devices(), or nothing for the surfaceless platform.
std::unique_ptr<Context> create_egl_context(std::optional<int> device, bool debug);
std::unique_ptr<Context> create_osmesa_context(bool debug);
std::unique_ptr<Context> create_window_context(bool debug);

} // namespace romascope
