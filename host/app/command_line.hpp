// The whole command line: its definition, and what is said where it is wrong.
#pragma once

#include "app/obey.hpp"

#include <CLI/App.hpp>

#include <string>
#include <vector>

namespace pelage::app {

// All subcommands and the options of `pelage` itself. A subcommand that is named runs while the command line is parsed
// and sets the exit code.
void define(CLI::App&, int& exit_code);

// Parses, and so runs. What is wrong is told in one sentence, with the nearest word that would be right.
int parse(CLI::App&, int argc, char** argv);

// The text of --help: of the command of that name, or an overview where it is empty. Throws Error as command_named().
std::string help_of(const CLI::App&, const std::string& command);

// The exit code, unless what was to be printed has not arrived: then that is told, and it is bad_input.
int unless_unprinted(int exit_code);

// The subcommands that people are meant to see, in the order of --help.
std::vector<const CLI::App*> commands_of(const CLI::App&);
std::vector<std::string> command_names(const CLI::App&);  // of these

// Of those the one of that name. Throws Error with the nearest name.
const CLI::App& command_named(const CLI::App&, const std::string& name);

}  // namespace pelage::app
