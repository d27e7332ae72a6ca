// Texts compressed by LZString for addresses: dictionary coding after Lempel, Ziv and Welch with growing codes, six
// bits a character.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace pelage::imports {

// In UTF-8. Empty where the text is none of that kind, or becomes longer than `most` characters.
std::optional<std::string> from_lz_text(std::string_view compressed, std::size_t most);

}  // namespace pelage::imports
