// `pelage help [COMMAND]`: the text of --help; with --man the page of the manual, as it is installed.
#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "app/manual.hpp"
#include "app/say.hpp"

#include <fmt/format.h>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <memory>
#include <string>

namespace pelage::app {

void add_help(CLI::App& app, int& exit_code) {
    struct Wanted {
        std::string command;
        bool manual = false;
    };
    const auto wanted = std::make_shared<Wanted>();
    CLI::App* command = app.add_subcommand("help", "Tell all options of a command");
    command->add_option("COMMAND", wanted->command, "Which one; without it an overview")->type_name("");
    command->add_flag("--man", wanted->manual, "Print the page for man(1) instead");
    command->callback([wanted, &app, &exit_code] {
        exit_code = success;
        if (wanted->manual) return say("{}", manual(app));
        say("{}", help_of(app, wanted->command));
    });
}

}  // namespace pelage::app
