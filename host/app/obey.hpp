// The command line from its words to its exit code, for a program that knows no parser.
#pragma once

#include <string>

namespace pelage::app {

// Does what the words ask for; returns the exit code.
int obey(int argc, char** argv);

// "pelage: TEXT" on standard error; returns bad_input.
int complain(const std::string& text);

}  // namespace pelage::app
