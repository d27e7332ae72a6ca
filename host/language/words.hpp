// Lists of words as they stand in messages, and the word somebody may have meant.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace pelage::language {

using Words = std::span<const std::string_view>;

// "a, b, c"; "none" when empty.
std::string listed(Words);

// The word nearest to `found` by insertions, deletions, replacements and swaps of neighbours, differences of case
// counting a quarter; empty when none is near.
std::string_view nearest(std::string_view found, Words);

// "; did you mean 'WORD'?" or nothing.
std::string suggestion(std::string_view found, Words);

// Printable and short enough for a message.
std::string shortened(std::string_view found);

}  // namespace pelage::language
