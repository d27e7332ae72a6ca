// One malformed experiment and the message it must give.
#pragma once

#include <string>

namespace test {

// Preludes of three good lines, so that the faulty one is line 4.
inline const std::string grid = "define chemical U\ndefine chemical V\ncreate sqr_grid 10 10\n";
inline const std::string matrix = "define chemical U\ndefine chemical V\ncreate matrix 20 10\n";

struct ErrorCase {
    std::string prelude;
    std::string text;
    std::string message;
};

// The message of parsing `text` as t.pex in a folder that is not there; "(none)" when it parses.
std::string message_of(const std::string& text);

void check_error(const ErrorCase&);

}  // namespace test
