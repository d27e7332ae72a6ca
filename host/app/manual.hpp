// The manual page, in the macros of man(7), from the definition of the command line.
#pragma once

#include <CLI/App.hpp>

#include <string>

namespace pelage::app {

std::string manual(const CLI::App&);

}  // namespace pelage::app
