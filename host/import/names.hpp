// Names that the experiment language takes, for those of other programs.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace pelage::imports {

class NewNames {
public:
    // The same name for the same original: the original itself where the language takes it.
    std::string of(std::string_view original);
    bool known(std::string_view original) const;
    // Those that are another name here.
    const std::map<std::string, std::string, std::less<>>& all() const { return names_; }

private:
    std::map<std::string, std::string, std::less<>> names_;
    std::set<std::string, std::less<>> taken_;
};

// Whether the text holds the name as a word of its own.
bool has_word(std::string_view text, std::string_view name);

}  // namespace pelage::imports
