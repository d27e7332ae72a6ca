// See functions.hpp.
#include "opencl/rules/functions.hpp"

#include "core/functions.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage {

namespace {

const FunctionFacts& facts_of(const std::string& name) {
    for (const auto* table : {&part_table(), &function_table()}) {
        const auto found = std::ranges::find(*table, name, &FunctionFacts::name);
        if (found != table->end()) return *found;
    }
    return function_table().front();  // cannot be: the build looks for every file that is needed
}

void add_file(const FunctionFacts& facts, std::set<std::string>& met, std::vector<std::string>& files) {
    if (!met.insert(facts.name).second) return;
    for (const std::string& other : facts.needs) add_file(facts_of(other), met, files);
    files.push_back(fmt::format("functions/{}.cl", facts.name));
}

}  // namespace

std::vector<std::string> function_files(const std::set<std::size_t>& used, const std::vector<std::string>& parts) {
    std::set<std::string> met;
    std::vector<std::string> files;
    for (const std::size_t index : used) add_file(function_table().at(index), met, files);
    for (const std::string& part : parts) add_file(facts_of(part), met, files);
    return files;
}

}  // namespace pelage
