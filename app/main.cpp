// SPDX-License-Identifier: MIT
#include "app/build_facts.h"
#include "app/commands.h"
#include "renderer/base/error.h"
#include "renderer/base/nearest_name.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>
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

/// For a word of the command line that means nothing: the command or option it may stand for.
std::string unknown_word(const CLI::App& app, const std::string& word) {
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    std::vector<std::string> names;
    if (chosen.empty() && !word.starts_with('-')) {
        for (const CLI::App* command : app.get_subcommands({}))
            names.push_back(command->get_name());
        return fmt::format("unknown command '{}': did you mean '{}'? (there are {})", word,
                           nearest_name(word, names), fmt::join(names, ", "));
    }
    if (!word.starts_with('-'))
        return fmt::format("'{}' is one argument too many", word);
    for (const CLI::Option* option : (chosen.empty() ? &app : chosen.front())->get_options())
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    const std::string typed = word.substr(0, word.find('='));
    if (!typed.starts_with("--"))
        return fmt::format("unknown option '{}'", typed);
    return fmt::format("unknown option '{}': did you mean '{}'?", typed,
                       nearest_name(typed, names));
}

std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
    const std::vector<std::string> unknown = app.remaining(true);
    const bool extra = dynamic_cast<const CLI::ExtrasError*>(&error) && !unknown.empty();
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    return fmt::format("{} (see 'romascope{} --help')",
                       extra ? unknown_word(app, unknown.front()) : error.what(),
                       chosen.empty() ? "" : " " + chosen.front()->get_name());
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
