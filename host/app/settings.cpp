// See settings.hpp.
#include "app/settings.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

namespace pelage::app {

void add_settings(CLI::App& command, std::vector<std::string>& words) {
    command
        .add_option(
            "--set", words,
            "Value of a parameter that the experiment defines; may be given for several, the last one of a name "
            "counts")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
}

std::vector<Setting> settings_of(const std::vector<std::string>& words) {
    std::vector<Setting> settings;
    for (const std::string& word : words) {
        const std::size_t sign = word.find('=');
        if (sign == std::string::npos || sign == 0 || sign + 1 == word.size()) {
            throw Error(fmt::format("--set '{}': a parameter is set as NAME=VALUE, as in --set feed=0.037", word));
        }
        settings.push_back({word.substr(0, sign), word.substr(sign + 1)});
    }
    return settings;
}

}  // namespace pelage::app
