// See options.hpp.
#include "bench/options.hpp"

#include "bench/cases.hpp"
#include "core/error.hpp"
#include "language/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace pelage::bench {

namespace {

constexpr std::size_t largest_size = 100'000'000;

bool among(const std::vector<std::string>& words, const std::string& word) {
    return std::ranges::find(words, word) != words.end();
}

void check_words(const char* option, const std::vector<std::string>& given, const std::vector<std::string>& allowed) {
    for (const std::string& word : given) {
        if (among(allowed, word)) continue;
        const std::vector<std::string_view> words(allowed.begin(), allowed.end());
        throw Error(fmt::format("{} '{}' is unknown; there are: {}{}", option, word, fmt::join(allowed, ", "),
                                language::suggestion(word, words)));
    }
}

}  // namespace

const std::vector<std::string>& suites() {
    static const std::vector<std::string> words{"lattice",   "formula", "cells", "neighbours", "growth",
                                                "aggregate", "volume",  "mesh",  "neural",     "all"};
    return words;
}

const std::vector<std::string>& backends() {
    static const std::vector<std::string> words{"reference",        "openmp",       "nanoflann",
                                                "nanoflann-openmp", "opencl-plain", "opencl-step",
                                                "opencl",           "opencl-fast",  "opencl-twin"};
    return words;
}

bool Options::wants(const std::string& backend) const {
    return against.empty() || backend == "opencl" || among(against, backend);
}

void check(const Options& options) {
    check_words("--suite", {options.suite}, suites());
    check_words("--against", options.against, backends());
    std::vector<std::string> names{"all"};
    for (const Case& one : all_cases()) {
        if (!among(names, one.name)) names.push_back(one.name);
    }
    check_words("--cases", options.cases, names);
    for (const std::size_t size : options.sizes) {
        if (size >= 1 && size <= largest_size) continue;
        throw Error(fmt::format("--sizes {} is out of range; 1 to {} is allowed", size, largest_size));
    }
    if (options.runs < 1 || options.runs > 1000) {
        throw Error(fmt::format("--runs {} is out of range; 1 to 1000 is allowed", options.runs));
    }
}

}  // namespace pelage::bench
