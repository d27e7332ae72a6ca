// See numbers.hpp.
#include "opencl/rules/numbers.hpp"

#include "core/subnormal.hpp"

#include <fmt/format.h>

#include <bit>
#include <stdexcept>

namespace pelage {

std::string Numbers::real(double value) { return named('k', value); }
std::string Numbers::word(std::uint32_t value) { return named('u', value); }

std::string Numbers::table(const std::vector<double>& values) {
    while (values_.size() % number_alignment != 0) values_.emplace_back(0.0);
    const std::size_t place = values_.size();
    values_.insert(values_.end(), values.begin(), values.end());
    if (declare_) names_.push_back({'w', place});
    return fmt::format("w{}", place);
}

std::string Numbers::named(char kind, KernelNumber value) {
    const std::size_t place = values_.size();
    values_.push_back(value);
    if (declare_) names_.push_back({kind, place});
    return fmt::format("{}{}", kind, place);
}

std::string Numbers::declarations(std::size_t first) const {
    if (first != numbers_begin(first)) throw std::logic_error("the numbers of rules do not begin where tables may");
    std::string text;
    for (const Name& name : names_) {
        const char* const form = name.kind == 'k'   ? "const real k{} = R(parameters[{}]);\n"
                                 : name.kind == 'u' ? "const uint u{} = PARAMETER_WORD({});\n"
                                                    : "global const scalar* const w{} = parameters + {};\n";
        text += fmt::format(fmt::runtime(form), name.place, first + name.place);
    }
    return text;
}

std::vector<std::uint32_t> parameter_words(const std::vector<KernelNumber>& values, Precision precision) {
    std::vector<std::uint32_t> words;
    const auto add = [&](std::uint64_t bits) {
        words.push_back(static_cast<std::uint32_t>(bits));
        if (precision == Precision::double_) words.push_back(static_cast<std::uint32_t>(bits >> 32));
    };
    for (const KernelNumber& value : values) {
        if (const auto* word = std::get_if<std::uint32_t>(&value)) {
            add(*word);
        } else if (precision == Precision::double_) {
            add(std::bit_cast<std::uint64_t>(std::get<double>(value)));
        } else {
            add(std::bit_cast<std::uint32_t>(in_precision<float>(std::get<double>(value))));
        }
    }
    return words;
}

}  // namespace pelage
