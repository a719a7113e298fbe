// SPDX-License-Identifier: MIT
#pragma once

namespace romascope {

extern const char* const kCommit;  ///< of the sources, "-modified" if they were; or "unknown"
extern const char* const kVersion; ///< of the program

} // namespace romascope
