// See options_of.hpp.
#include "app/options_of.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace pelage::app {

namespace {

// "float|double": both; "INDEX|NAME": capitals stand for values, so none.
std::vector<std::string> words_of(const std::string& value) {
    if (value.find('|') == std::string::npos) return {};
    std::vector<std::string> words;
    std::istringstream text(value);
    for (std::string word; std::getline(text, word, '|');) {
        if (std::ranges::none_of(word, [](unsigned char c) { return std::isupper(c) != 0; })) words.push_back(word);
    }
    return words;
}

OptionText text_of(const CLI::Option& option) {
    OptionText one;
    for (const std::string& name : option.get_snames()) one.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) one.names.push_back("--" + name);
    if (one.names.empty()) {
        one.value = option.get_name(true);
    } else if (option.get_items_expected_max() != 0) {
        one.value = option.get_type_name();
    }
    one.text = option.get_description();
    one.words = words_of(one.value);
    return one;
}

}  // namespace

std::vector<OptionText> options_of(const CLI::App& command) {
    std::vector<OptionText> all;
    for (const CLI::Option* option : command.get_options()) {
        if (!option->get_group().empty()) all.push_back(text_of(*option));
    }
    std::stable_partition(all.begin(), all.end(), [](const OptionText& one) { return !one.names.empty(); });
    return all;
}

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const OptionText& option : options_of(command)) {
        names.insert(names.end(), option.names.begin(), option.names.end());
    }
    return names;
}

}  // namespace pelage::app
