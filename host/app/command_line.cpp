// See command_line.hpp.
#include "app/command_line.hpp"

#include "app/commands.hpp"
#include "app/options_of.hpp"
#include "app/say.hpp"
#include "app/validators.hpp"
#include "core/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <cstdio>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace pelage::app {

namespace {

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
    return word.size() > 1 && word != "--" && word[0] == '-' &&
           std::string("0123456789.").find(word[1]) == std::string::npos;
}

std::string about_words(const CLI::App& command, std::vector<std::string> left) {
    const bool files_only = left.front() == "--";
    if (files_only && left.size() > 1) left.erase(left.begin());
    return fmt::format("`pelage {}` does not know what to do with '{}'{}", command.get_name(), left.front(),
                       files_only ? "; after '--' all words are files" : "");
}

// What CLI11 has to say of one option, in a sentence.
std::string about_option(const CLI::App& command, const CLI::ParseError& error) {
    const std::string text = error.what();  // begins with the option's name
    std::string name = text.substr(0, text.find_first_of(": "));
    if (command.get_option_no_throw(name) == nullptr) name = "--" + name;
    const CLI::Option* option = command.get_option_no_throw(name);
    if (option == nullptr) return text;
    if (error.get_name() == "RequiredError") return fmt::format("`pelage {}` needs a {}", command.get_name(), name);
    if (error.get_name() != "ArgumentMismatch") return text;
    if (option->get_items_expected_max() == 0) return fmt::format("the option '{}' takes no value", name);
    if (option->count() > 1) return fmt::format("the option '{}' is given more than once", name);
    return fmt::format("the option '{}' needs a value, {}", name, option->get_type_name());
}

std::string reason(const CLI::App& app, const CLI::ParseError& error) {
    for (const std::string& word : app.remaining()) {
        if (is_option(word)) return unknown_option(app, app, word);
    }
    const CLI::App& command = named(app);
    const std::vector<std::string> left = command.remaining();
    for (const std::string& word : left) {
        if (word == "--") break;
        if (is_option(word)) return unknown_option(app, command, word);
    }
    const std::string see = &command == &app ? "" : command.get_name() + " ";
    const bool words = !left.empty() && left.back() != "--" && &command != &app;
    return fmt::format("{} (see `pelage {}--help`)", words ? about_words(command, left) : about_option(command, error),
                       see);
}

// "--quiet=5" would be taken for --quiet.
void refuse_values_of_flags(CLI::App& command) {
    for (CLI::Option* option : command.get_options()) {
        if (option->get_items_expected_max() == 0) option->disable_flag_override();
    }
}

// An unset variable in a script is not an option that was left out.
void refuse_empty_values(CLI::App& command) {
    const CLI::Validator something(
        [](std::string& text) {
            return std::string(text.empty() ? "an empty value names nothing; leave the option out instead" : "");
        },
        "", "");
    for (CLI::Option* option : command.get_options()) {
        if (option->get_items_expected_max() > 0) option->check(something);
    }
}

// --help and --version.
int print(const CLI::App& app, const CLI::ParseError& asked) {
    std::ostringstream out, err;
    const int exit_code = app.exit(asked, out, err);
    say("{}", out.str());
    return unless_unprinted(exit_code);
}

}  // namespace

int complain(const std::string& text) {
    say(stderr, "pelage: {}\n", text);
    return bad_input;
}

int unless_unprinted(int exit_code) { return printed() ? exit_code : complain("standard output cannot be written"); }

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
    add_sweep(app, exit_code);
    add_measure(app, exit_code);
    add_learn(app, exit_code);
    add_devices(app, exit_code);
    add_verify(app, exit_code);
    add_bench(app, exit_code);
    add_tune(app, exit_code);
    add_import(app, exit_code);
    add_help(app, exit_code);
    add_completion(app, exit_code);
    refuse_values_of_flags(app);
    for (CLI::App* command : app.get_subcommands({})) {
        refuse_values_of_flags(*command);
        refuse_empty_values(*command);
    }
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
    if (std::string_view(argv[1]) == "--") return complain("a command comes first (see `pelage --help`)");
    if (argv[1][0] != '-') (void)command_named(app, argv[1]);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return print(app, error);
        return complain(reason(app, error));
    }
    return success;
}

int obey(int argc, char** argv) {
    int exit_code = success;
    CLI::App app;
    define(app, exit_code);
    const int parsed = parse(app, argc, argv);
    if (parsed != success) return parsed;
    // A run's results are files, and these are whole.
    return app.got_subcommand("run") ? exit_code : unless_unprinted(exit_code);
}

}  // namespace pelage::app
