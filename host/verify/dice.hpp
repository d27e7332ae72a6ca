// Choices for random experiments: a stream of Philox words, so that a seed means the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace pelage::verify {

class Dice {
public:
    explicit Dice(std::uint64_t seed) : seed_(seed) {}

    std::uint32_t word();
    std::size_t below(std::size_t count);  // 0 .. count - 1; count > 0
    std::size_t from_to(std::size_t low, std::size_t high) { return low + below(high - low + 1); }  // both included
    bool chance(unsigned percent) { return below(100) < percent; }
    double real(double low, double high);  // low + k * (high - low) / 1024

    template <class T>
    T pick(std::initializer_list<T> choices) {
        return choices.begin()[below(choices.size())];
    }
    // The place of a choice, drawn in proportion to its weight.
    std::size_t weighted(std::initializer_list<unsigned> weights);

    std::string number(double);  // written in one of several ways that read back to the same bits
    std::string number(double low, double high) { return number(real(low, high)); }

private:
    std::uint64_t seed_;
    std::uint64_t drawn_ = 0;
};

}  // namespace pelage::verify
