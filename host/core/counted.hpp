// Numbers as people read them: 242,000; 1 cell, 2 cells.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace pelage {

std::string grouped(std::uint64_t number);  // 242,000

// "cell" for 1, else "cells"; many: the word for several where it is not the other with an s.
std::string noun(std::uint64_t number, std::string_view one, std::string_view many = {});

// "1 cell", "242,000 cells".
std::string counted(std::uint64_t number, std::string_view one, std::string_view many = {});

}  // namespace pelage
