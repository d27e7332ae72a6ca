// Which program this is, for what is remembered from one run to another.
#pragma once

#include <string>

namespace pelage::app {

// Of the program's own file, in hexadecimal: another build is another program.
std::string own_checksum();

}  // namespace pelage::app
