// The same colours as Colours gives, many times faster: for films, which draw millions of values a second.
#pragma once

#include "io/colour.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace pelage {

// A range is cut into so many pieces that most are of one colour, which is looked up; in the others, and next to where
// a colour ends, it is computed. The table holds for any range.
class QuickColours {
public:
    using Word = std::uint32_t;  // a colour in a form of the caller's; the highest bit is not used

    QuickColours(const Output&, std::function<Word(const Rgb&)> form);

    // The colour of each of `count` values, that of Colours(output, range).
    void draw(const Colours& colours, const float* values, std::size_t count, Word* to) const;

private:
    void look_up(const Colours&, const float* values, std::span<const std::int32_t> places, Word* to) const;
    void compute_mixed(const Colours&, const float* values, std::size_t count, Word* to) const;

    static constexpr std::size_t pieces = std::size_t{1} << 15;
    static constexpr std::size_t nan_place = pieces + 2;
    static constexpr Word mixed = Word{1} << 31;  // the piece has several colours

    std::function<Word(const Rgb&)> form_;
    std::vector<Word> table_;  // what lies below the range, the pieces, what lies above, NaN
    std::vector<Word> slots_;  // of a slotted map, whose background often lies where its last slot begins
};

// Minimum to maximum of the finite values.
ValueRange range_of(std::span<const float> values);

}  // namespace pelage
