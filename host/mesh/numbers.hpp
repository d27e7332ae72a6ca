// Words and numbers in files of meshes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pelage {

// The first line, which leaves `text`; it ends with \n, \r\n or \r.
std::string_view cut_line(std::string_view& text);

// The next word between blanks, which leaves `line`; empty: there is none.
std::string_view next_word(std::string_view& line);

// The whole word as a number, rounded correctly; empty: it is none, or none that double holds. "inf" and "nan" are
// numbers here.
std::optional<double> to_double(std::string_view);
std::optional<std::int64_t> to_integer(std::string_view);

// For messages: in quotes, cut to a sensible length, bytes that are no text as '?'.
std::string shown(std::string_view);

}  // namespace pelage
