// See problems.hpp.
#include "import/problems.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace pelage::imports {

namespace {

constexpr std::size_t most_sentences = 30;

void add_new(std::vector<std::string>& list, std::string sentence) {
    if (list.size() < most_sentences && std::ranges::find(list, sentence) == list.end())
        list.push_back(std::move(sentence));
}

}  // namespace

void Problems::refuse(std::string sentence) { add_new(refusals_, std::move(sentence)); }
void Problems::note(std::string sentence) { add_new(notes_, std::move(sentence)); }

void Problems::check() const {
    if (!refusals_.empty()) throw Error(fmt::format("{}", fmt::join(refusals_, "\npelage: ")));
}

}  // namespace pelage::imports
