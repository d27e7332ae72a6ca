// The one exception type of the library: its text says what was wrong, where, and what is allowed.
#pragma once

#include <stdexcept>
#include <string>

namespace pelage {

class Error : public std::runtime_error {
public:
    explicit Error(const std::string& text) : std::runtime_error(text) {}
};

}  // namespace pelage
