// SPDX-License-Identifier: MIT
#include "app/build_facts.h"
#include "app/commands.h"
#include "app/usage.h"
#include "renderer/base/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>
#include <span>
#include <vector>

namespace romascope {
namespace {

int report_failure(const std::string& text, int status) {
    // Not by fmt::print, which throws where nobody reads.
    std::fputs(fmt::format("romascope: {}\n", text).c_str(), stderr);
    return status;
}

/// What a user typed may hold line breaks; what answers it is one line.
std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

int run(int argc, char** argv) {
    CLI::App app("Which fast visibility method is good enough for a scene, and what does it cost?",
                 "romascope");
    app.set_version_flag("--version", fmt::format("romascope {} ({})", kVersion, kCommit));
    app.require_subcommand(0, 1);
    int status = 0;
    std::vector<Command> commands;
    for (const auto& add :
         {add_view_command, add_render_command, add_compare_command, add_sheet_command,
          add_bench_command, add_split_command, add_info_command}) {
        const Command command = commands.emplace_back(add(app));
        app.get_subcommands({}).back()->callback([&status, command] { status = command(); });
    }
    check_option_values(app,
                        std::span<const char* const>(argv, static_cast<size_t>(argc)).subspan(1));
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0)
            return app.exit(error); // --help, --version
        throw Error(usage_error(app, error), kBadInput);
    }
    if (app.get_subcommands().empty())
        return commands.front()(); // the default scene in a window
    return status;
}

} // namespace
} // namespace romascope

int main(int argc, char** argv) {
    using namespace romascope;
    try {
        const int status = run(argc, argv);
        // A full disk must not pass for success.
        if (std::fflush(stdout) != 0)
            throw Error(fmt::format("cannot write the output: {}", std::strerror(errno)));
        return status;
    } catch (const Error& error) {
        const bool bad_input = error.exit_status() == kBadInput;
        return report_failure(bad_input ? one_line(error.what()) : error.what(),
                              error.exit_status());
    } catch (const std::bad_alloc&) {
        return report_failure("out of memory: choose a smaller picture or scene", 1);
    } catch (const std::exception& error) {
        return report_failure(error.what(), 1);
    }
}
