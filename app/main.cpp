// SPDX-License-Identifier: MIT
#include "app/build_facts.h"
#include "app/commands.h"
#include "renderer/base/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <new>
#include <vector>

namespace {

int report_failure(const char* text, int status) {
    fmt::print(stderr, "romascope: {}\n", text);
    return status;
}

} // namespace

int main(int argc, char** argv) {
    using namespace romascope;
    CLI::App app("Which fast visibility method is good enough for a scene, and what does it cost?",
                 "romascope");
    app.set_version_flag("--version", fmt::format("romascope {} ({})", kVersion, kCommit));
    app.require_subcommand(1);
    app.failure_message([](const CLI::App* from, const CLI::Error& error) {
        std::string text = error.what();
        std::replace(text.begin(), text.end(), '\n', ' ');
        return fmt::format("romascope: {} (see 'romascope{} --help')\n", text,
                           from->get_subcommands().empty()
                               ? ""
                               : " " + from->get_subcommands().front()->get_name());
    });
    int status = 0;
    for (const auto& add : {add_render_command, add_compare_command, add_info_command}) {
        Command run = add(app);
        app.get_subcommands({}).back()->callback([&status, run] { status = run(); });
    }
    try {
        app.parse(argc, argv);
        return status;
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : kBadInput;
    } catch (const Error& error) {
        return report_failure(error.what(), error.exit_status());
    } catch (const std::bad_alloc&) {
        return report_failure("out of memory: choose a smaller picture or scene", 1);
    } catch (const std::exception& error) {
        return report_failure(error.what(), 1);
    }
}
