// SPDX-License-Identifier: MIT
// Pictures that tell an estimator at which pixels to trace.
#pragma once
#include "shaders/common/cross.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

const uint kTraceBit = 1u << 31; ///< in the first component

#ifdef __cplusplus
} // namespace romascope::gpu
#endif
