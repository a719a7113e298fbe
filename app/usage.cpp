// SPDX-License-Identifier: MIT
#include "app/usage.h"

#include "renderer/base/did_you_mean.h"
#include "renderer/base/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

namespace romascope {
namespace {

std::string with_help(const CLI::App& command, std::string text) {
    if (!command.get_parent())
        return text += " (see 'romascope --help')";
    return text += fmt::format(" (see 'romascope {} --help')", command.get_name());
}

/// The command that is chosen, or the program itself.
const CLI::App& chosen_command(const CLI::App& app) {
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    return chosen.empty() ? app : *chosen.front();
}

/// "--name", "--name=value" or "-n"; null for all else.
const CLI::Option* option_of(const CLI::App& command, const std::string& word) {
    const std::string name = word.substr(0, word.starts_with("--") ? word.find('=') : word.npos);
    for (const CLI::Option* option : command.get_options())
        if (name.starts_with('-') && option->check_name(name))
            return option;
    return nullptr;
}

/// Goes along the words of one command.
class Reader {
public:
    Reader(const CLI::App& command, std::vector<std::string> words)
        : command_(command), words_(std::move(words)) {}

    void check() {
        while (at_ < words_.size() && words_[at_] != "--") {
            const CLI::Option* option = option_of(command_, words_[at_]);
            if (option)
                check(*option);
            else
                ++at_; // a scene, or what the parser says it does not know
        }
    }

private:
    void check(const CLI::Option& option) {
        const std::string name = option.get_name();
        const size_t equals = words_[at_].find('=');
        const bool with_value = equals != std::string::npos;
        const std::string value = with_value ? words_[at_].substr(equals + 1) : "";
        ++at_;
        const bool is_flag = option.get_items_expected_max() == 0;
        const size_t needed = is_flag ? 0 : static_cast<size_t>(option.get_type_size());
        if (is_flag && with_value)
            refuse(fmt::format("{} takes no value: leave out '={}'", name, value));
        std::vector<std::string> given;
        if (with_value)
            given.push_back(value);
        while (given.size() < needed && at_ < words_.size() && words_[at_] != "--" &&
               !option_of(command_, words_[at_]))
            given.push_back(words_[at_++]);
        if (given.size() < needed || (with_value && value.empty()))
            refuse(missing(option, with_value, given));
        const bool counts_once =
            !is_flag && option.get_items_expected_max() <= option.get_type_size();
        if (++times_[&option] > 1 && counts_once)
            refuse(fmt::format("{} is there twice: give it once", name));
    }

    std::string missing(const CLI::Option& option, bool with_value,
                        const std::vector<std::string>& given) const {
        std::string text = fmt::format("{} needs {}", option.get_name(), option.get_type_name());
        if (with_value && given.front().empty())
            return text += ": nothing stands after its '='";
        text += fmt::format(": {} stands ",
                            given.empty() ? "nothing" : fmt::format("only '{}'", given.front()));
        return text += at_ < words_.size() ? fmt::format("before '{}'", words_[at_]) : "after it";
    }

    [[noreturn]] void refuse(const std::string& text) const {
        throw Error(with_help(command_, text), kBadInput);
    }

    const CLI::App& command_;
    std::vector<std::string> words_;
    size_t at_ = 0;
    std::map<const CLI::Option*, int> times_;
};

/// For a word of the command line that means nothing: the command or option it may stand for.
std::string unknown_word(const CLI::App& app, const std::string& word) {
    const CLI::App& command = chosen_command(app);
    std::vector<std::string> names;
    if (&command == &app && !word.starts_with('-')) {
        for (const CLI::App* known : app.get_subcommands({}))
            names.push_back(known->get_name());
        return fmt::format("unknown command '{}'{} (there are {})", word, did_you_mean(word, names),
                           fmt::join(names, ", "));
    }
    if (!word.starts_with('-'))
        return fmt::format("'{}' is one argument too many", word);
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    const std::string typed = word.substr(0, word.find('='));
    if (!typed.starts_with("--"))
        return fmt::format("unknown option '{}'", typed);
    return fmt::format("unknown option '{}'{}", typed, did_you_mean(typed, names));
}

/// "FRAME SECONDS, a whole number and a number": of options whose values the parser reads, which
/// are numbers all.
std::string numbers_taken(const CLI::Option& option) {
    std::string kinds;
    std::istringstream names(option.get_type_name());
    for (std::string name; names >> name;) {
        kinds += kinds.empty() ? ", " : " and ";
        kinds += name == "N" || name == "FRAME" ? "a whole number" : "a number";
    }
    return option.get_type_name() + kinds;
}

/// For values that are not what their option takes.
std::string unreadable_value(const CLI::App& command, const CLI::ParseError& error) {
    // The parser takes options one after the other and stops at the first that it cannot read.
    const CLI::Option* last = nullptr;
    for (const CLI::Option* option : command.get_options())
        if (option->count() > 0 && option->get_callback_run())
            last = option;
    if (!last)
        return error.what();
    return fmt::format("{} cannot be '{}': it takes {}", last->get_name(),
                       fmt::join(last->results(), " "), numbers_taken(*last));
}

std::string missing_option(const CLI::App& command, const CLI::ParseError& error) {
    for (const CLI::Option* option : command.get_options())
        if (option->get_required() && option->count() == 0)
            return fmt::format("{} is missing: {}", option->get_name(), option->get_description());
    return error.what();
}

} // namespace

void check_option_values(const CLI::App& app, std::span<const char* const> words) {
    const CLI::App* command = &app;
    if (!words.empty())
        for (const CLI::App* known : app.get_subcommands({}))
            if (known->get_name() == words.front())
                command = known;
    Reader(*command, {words.begin() + (command == &app ? 0 : 1), words.end()}).check();
}

std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
    const CLI::App& command = chosen_command(app);
    const std::vector<std::string> unknown = app.remaining(true);
    if (dynamic_cast<const CLI::ExtrasError*>(&error) && !unknown.empty())
        return with_help(command, unknown_word(app, unknown.front()));
    if (dynamic_cast<const CLI::ConversionError*>(&error))
        return with_help(command, unreadable_value(command, error));
    if (dynamic_cast<const CLI::RequiredError*>(&error))
        return with_help(command, missing_option(command, error));
    return with_help(command, error.what());
}

} // namespace romascope
