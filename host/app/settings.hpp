// `--set NAME=VALUE` of several commands: values for an experiment's parameters.
#pragma once

#include "core/parameter.hpp"

#include <CLI/App.hpp>

#include <string>
#include <vector>

namespace pelage::app {

void add_settings(CLI::App& command, std::vector<std::string>& words);

// Throws Error where a word is not NAME=VALUE.
std::vector<Setting> settings_of(const std::vector<std::string>& words);

}  // namespace pelage::app
