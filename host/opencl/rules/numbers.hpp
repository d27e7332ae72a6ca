// Numbers that a program reads from a buffer of parameters instead of having them in its text, so that programs depend
// on the structure of rules alone: a changed number compiles nothing anew.
#pragma once

#include "core/precision.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace pelage {

// Tables are read four numbers at a time. The first of the numbers of rules has a place in the buffer that is a
// multiple of this: the next one from `end` on, where what stands before them ends.
inline constexpr std::size_t number_alignment = 4;
inline constexpr std::size_t numbers_begin(std::size_t end) {
    return (end + number_alignment - 1) / number_alignment * number_alignment;
}

using KernelNumber = std::variant<double, std::uint32_t>;  // a real number, or a whole one of 32 bits

// The numbers of rules, in the order in which they are asked for: it must not depend on which rules act.
class Numbers {
public:
    // Names for the program's text, declared by declarations() unless `declare` is false when they are asked for.
    std::string real(double);         // of type real: "k3"
    std::string word(std::uint32_t);  // of type uint: "u4"
    // Of type `global const scalar*`: "w8", the first of these. Its place is a multiple of number_alignment.
    std::string table(const std::vector<double>&);
    void declare(bool wanted) { declare_ = wanted; }

    // `first`: place of the first of them in the buffer; see numbers_begin().
    std::string declarations(std::size_t first) const;
    std::size_t declared() const { return names_.size(); }

    const std::vector<KernelNumber>& values() const { return values_; }

private:
    struct Name {
        char kind;  // 'k', 'u' or 'w'
        std::size_t place;
    };
    std::string named(char kind, KernelNumber);

    std::vector<KernelNumber> values_;
    std::vector<Name> names_;
    bool declare_ = true;
};

// How the buffer holds them: 4 bytes each in single precision, 8 in double. Real numbers are rounded to the precision.
std::vector<std::uint32_t> parameter_words(const std::vector<KernelNumber>&, Precision);

}  // namespace pelage
