// See command_line.hpp.
#include "app/command_line.hpp"

#include "app/commands.hpp"
#include "app/say.hpp"
#include "core/error.hpp"
#include "language/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace pelage::app {

namespace {

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_group().empty()) continue;
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    }
    return names;
}

std::string meant(const std::string& found, const std::vector<std::string>& words) {
    const std::vector<std::string_view> views(words.begin(), words.end());
    return language::suggestion(found, views);
}

// The first of the command that has the option; null: none.
const CLI::App* owner_of(const CLI::App& app, const std::string& option) {
    for (const CLI::App* command : commands_of(app)) {
        if (command->get_option_no_throw(option) != nullptr) return command;
    }
    return nullptr;
}

std::string unknown_option(const CLI::App& app, const CLI::App& command, const std::string& word) {
    const std::string option = word.substr(0, word.find('='));
    if (&command != &app) {
        return fmt::format("`pelage {0}` has no option '{1}'{2} (see `pelage {0} --help`)", command.get_name(), option,
                           meant(option, option_names(command)));
    }
    if (const CLI::App* owner = owner_of(app, option)) {
        return fmt::format("the option '{}' comes after its command, as in `pelage {} {}`", option, owner->get_name(),
                           option);
    }
    return fmt::format("`pelage` has no option '{}'{} (see `pelage --help`)", option, meant(option, option_names(app)));
}

// The command that was named; `pelage` itself when none was.
const CLI::App& named(const CLI::App& app) {
    const std::vector<const CLI::App*> parsed = app.get_subcommands([](const CLI::App* one) { return one->parsed(); });
    return parsed.empty() ? app : *parsed.front();
}

bool is_option(const std::string& word) {
    return word.size() > 1 && word[0] == '-' && std::string("0123456789.").find(word[1]) == std::string::npos;
}

std::string reason(const CLI::App& app, const CLI::ParseError& error) {
    for (const std::string& word : app.remaining()) {
        if (is_option(word)) return unknown_option(app, app, word);
    }
    const CLI::App& command = named(app);
    const std::vector<std::string> left = command.remaining();
    for (const std::string& word : left) {
        if (is_option(word)) return unknown_option(app, command, word);
    }
    const std::string see = &command == &app ? "" : command.get_name() + " ";
    if (!left.empty() && &command != &app) {
        return fmt::format("`pelage {0}` does not know what to do with '{1}' (see `pelage {0} --help`)",
                           command.get_name(), left.front());
    }
    return fmt::format("{} (see `pelage {}--help`)", error.what(), see);
}

}  // namespace

int complain(const std::string& text) {
    say(stderr, "pelage: {}\n", text);
    return bad_input;
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

std::vector<std::string> command_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : commands_of(app)) names.push_back(command->get_name());
    return names;
}

const CLI::App& command_named(const CLI::App& app, const std::string& name) {
    for (const CLI::App* command : commands_of(app)) {
        if (command->get_name() == name) return *command;
    }
    const std::vector<std::string> names = command_names(app);
    throw Error(
        fmt::format("there is no command '{}'; there are: {}{}", name, fmt::join(names, ", "), meant(name, names)));
}

std::string help_of(const CLI::App& app, const std::string& command) {
    if (!command.empty()) return command_named(app, command).help(app.get_name());
    // help() would tell of the command that is running.
    return app.get_formatter()->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal);
}

void define(CLI::App& app, int& exit_code) {
    app.description(
        "Grows animal skin patterns by reaction and diffusion, on any OpenCL device or on a plain reference.");
    app.set_version_flag("--version", "pelage " PELAGE_VERSION, "Print the version and stop");
    app.get_formatter()->column_width(34);
    app.footer(
        "First steps:\n"
        "  pelage run experiments/leopard.pex      grow a leopard's coat; the pictures go to out/leopard\n"
        "  pelage check my.pex                     say what is wrong with an experiment\n"
        "  pelage help run                         all options of one command\n\n"
        "Exit codes: 0 success; 1 a run met NaN or infinity, a check failed; 2 bad input; 130 stopped by Ctrl-C.");
    add_run(app, exit_code);
    add_check(app, exit_code);
    add_devices(app, exit_code);
    add_verify(app, exit_code);
    add_bench(app, exit_code);
    add_tune(app, exit_code);
    add_help(app, exit_code);
    add_completion(app, exit_code);
}

int parse(CLI::App& app, int argc, char** argv) {
    app.name(argv[0]);  // as the user called it: printed commands repeat it
    if (argc < 2) {
        say(stderr, "{}", help_of(app, ""));
        return bad_input;
    }
    // CLI11 takes the name of a command for that command wherever it stands.
    if (argc == 3 && std::string_view(argv[1]) == "help" && argv[2][0] != '-') {
        say("{}", help_of(app, argv[2]));
        return success;
    }
    if (argv[1][0] != '-') (void)command_named(app, argv[1]);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
        return complain(reason(app, error));
    }
    return success;
}

}  // namespace pelage::app
