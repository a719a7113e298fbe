// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

namespace romascope {

/// Refuses before the work what could not be written after it, or would destroy what is read:
/// folders, places without the right to write, one file for two outputs, an output over an input.
/// Empty paths are outputs that were not asked for. Throws Error (kBadInput).
void check_output_files(const std::vector<std::filesystem::path>& outputs,
                        const std::vector<std::filesystem::path>& inputs);

} // namespace romascope
