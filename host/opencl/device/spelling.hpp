// Names as drivers and users write them, made comparable.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>

namespace pelage {

inline std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

// Without blanks and zero bytes at either end.
inline std::string trimmed(const std::string& text) {
    const std::string blanks(" \t\n\0", 4);
    const auto first = text.find_first_not_of(blanks);
    const auto last = text.find_last_not_of(blanks);
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

}  // namespace pelage
