// Scripts with which a shell completes the command line, from its definition.
#pragma once

#include <CLI/App.hpp>

#include <string>

namespace pelage::app {

std::string bash_completion(const CLI::App&);
std::string zsh_completion(const CLI::App&);

}  // namespace pelage::app
