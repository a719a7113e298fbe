// SPDX-License-Identifier: MIT
// The program's commands. Each adds its options to the command line and returns what runs it; what
// it throws becomes one line on stderr and the exit status.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace romascope {

using Command = std::function<int()>; ///< returns the exit status

Command add_view_command(CLI::App& app);
Command add_render_command(CLI::App& app);
Command add_compare_command(CLI::App& app);
Command add_sheet_command(CLI::App& app);
Command add_bench_command(CLI::App& app);
Command add_split_command(CLI::App& app);
Command add_info_command(CLI::App& app);

} // namespace romascope
