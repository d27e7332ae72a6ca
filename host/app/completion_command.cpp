// `pelage completion SHELL`: prints the script with which the shell completes `pelage` command lines.
#include "app/commands.hpp"
#include "app/completion.hpp"
#include "app/say.hpp"
#include "app/validators.hpp"

#include <fmt/format.h>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <memory>
#include <string>

namespace pelage::app {

void add_completion(CLI::App& app, int& exit_code) {
    const auto shell = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand("completion", "Print a shell's completion of this command line");
    command->add_option("SHELL", *shell, "bash or zsh")->required()->type_name("")->check(one_of({"bash", "zsh"}));
    command->callback([shell, &app, &exit_code] {
        say("{}", *shell == "bash" ? bash_completion(app) : zsh_completion(app));
        exit_code = success;
    });
}

}  // namespace pelage::app
