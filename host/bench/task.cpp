// See task.hpp.
#include "bench/task.hpp"

#include "core/finite.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage::bench {

namespace {

std::string shown(const Array& array, std::size_t i) {
    if (!array.numbers) return std::to_string(array.words[i]);
    return fmt::format("{:.9g} ({:08x})", std::bit_cast<float>(array.words[i]), array.words[i]);
}

std::string difference(const Array& expected, const Array& found) {
    if (expected.words.size() != found.words.size()) {
        return fmt::format("{} has {} entries instead of {}", expected.name, found.words.size(), expected.words.size());
    }
    std::size_t count = 0;
    std::size_t first = 0;
    for (std::size_t i = expected.words.size(); i-- > 0;) {
        if (expected.words[i] == found.words[i]) continue;
        ++count;
        first = i;
    }
    if (count == 0) return {};
    return fmt::format("{} differs in {} of {} places, first at {}: {} instead of {}", expected.name, count,
                       expected.words.size(), first, shown(found, first), shown(expected, first));
}

// A result that is as it was, flat or not finite proves nothing.
std::string mistrust(const Outcome& initial, const Outcome& found) {
    bool moved = initial.empty();
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (i < initial.size() && initial[i].words != found[i].words) moved = true;
        if (!found[i].numbers) continue;
        for (const std::uint32_t word : found[i].words) {
            if (!is_finite(std::bit_cast<float>(word))) return found[i].name + " holds numbers that are not finite";
        }
    }
    return moved ? "" : "nothing changed: the comparison proves nothing";
}

}  // namespace

std::string disagreement(const Outcome& initial, const Outcome& expected, const Outcome& found) {
    if (expected.size() != found.size()) return fmt::format("{} arrays instead of {}", found.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const std::string text = difference(expected[i], found[i]);
        if (!text.empty()) return text;
    }
    return mistrust(initial, found);
}

}  // namespace pelage::bench
