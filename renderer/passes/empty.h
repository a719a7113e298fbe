// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/program.h"
#include "renderer/gl/timer.h"

namespace romascope {

/// A pass that does nothing: what a dispatch and the barrier after it cost by themselves.
class EmptyPass {
public:
    void run(const ShaderLibrary& shaders, PassTimer& timer);
    static ShaderVariant variant();

private:
    ProgramSlot program_;
};

} // namespace romascope
