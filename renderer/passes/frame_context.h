// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/shader_source.h"
#include "renderer/gl/timer.h"
#include "renderer/scene/gpu_scene.h"
#include "renderer/settings/settings.h"

#include <cstdint>
#include <string>
#include <vector>

namespace romascope {

/// What every pass of a frame may know.
struct FrameContext {
    const Settings& settings;
    const ShaderLibrary& shaders;
    const GpuScene& scene;
    PassTimer& timer;
    uint32_t seed = 0;
    uint32_t frame = 0; ///< counts from 0
};

/// Bytes that a structure holds on the GPU.
struct StructureBytes {
    std::string name;
    size_t bytes = 0;
};

/// Something that was counted on the GPU during a frame.
struct NamedCount {
    std::string name;
    uint64_t count = 0;
    uint64_t of = 0; ///< what it is a part of, where it is told as a share too; else 0

    /// In per cent.
    double share() const { return 100.0 * static_cast<double>(count) / static_cast<double>(of); }
};

} // namespace romascope
