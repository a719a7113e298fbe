// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/program.h"
#include "renderer/passes/frame_context.h"
#include "renderer/scene/pose.h"

namespace romascope {

/// Moves the scene's vertices on the GPU, in single precision, all in one dispatch; what
/// `apply_pose` does on the CPU. The same pose gives the same bytes.
class Deform {
public:
    /// Uploads what stands at rest, if anything moves. Throws Error if the driver cannot hold it.
    explicit Deform(const Motion& motion);

    /// Rewrites positions and normals of what moves, and the bounds of `scene`. `motion`: the one
    /// given before, with at least one part. Throws as MovingBounds::at does, with nothing changed.
    void run(const ShaderLibrary& shaders, PassTimer& timer, GpuScene& scene, const Motion& motion,
             const Pose& pose);

    StructureBytes bytes() const;

    static ShaderVariant variant();

private:
    ProgramSlot program_;
    MovingBounds bounds_;
    Buffer parts_, rest_, influences_, deltas_, palette_, weights_;
};

} // namespace romascope
