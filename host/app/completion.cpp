// See completion.hpp.
#include "app/completion.hpp"

#include "app/command_line.hpp"
#include "app/options_of.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <string_view>
#include <vector>

namespace pelage::app {

namespace {

// What the first word after a command may be, where that is no file.
std::vector<std::string> first_words(const CLI::App& app, const CLI::App& command) {
    if (command.get_name() == "help") return command_names(app);
    if (command.get_name() == "completion") return {"bash", "zsh"};
    return {};
}

// ---- bash

// What may follow each option that takes a value: words, a file (which bash finds by itself), or nothing it could know.
std::string bash_values(const CLI::App& command) {
    std::string cases;
    for (const OptionText& option : options_of(command)) {
        if (option.names.empty() || option.value.empty()) continue;
        std::vector<std::string> patterns;
        for (const std::string& name : option.names)
            patterns.push_back(fmt::format("\"{} {}\"", command.get_name(), name));
        const std::string action =
            option.takes_file() ? "return"
            : option.words.empty()
                ? "compopt +o default; return"
                : fmt::format("COMPREPLY=($(compgen -W '{}' -- \"$word\")); return", fmt::join(option.words, " "));
        cases += fmt::format("        {}) {} ;;\n", fmt::join(patterns, "|"), action);
    }
    return cases;
}

// ---- zsh

std::string in_quotes(std::string_view text) {
    std::string result = "'";
    for (const char c : text) {
        if (c == '\'') {
            result += "'\\''";
        } else {
            if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
            result += c;
        }
    }
    return result + "'";
}

std::string zsh_action(const OptionText& option) {
    if (!option.words.empty()) return fmt::format(":{}:({})", "value", fmt::join(option.words, " "));
    return fmt::format(":{}:{}",
                       option.value == "DIR" ? "folder"
                       : option.takes_file() ? "file"
                                             : "value",
                       option.value == "DIR" ? "_files -/"
                       : option.takes_file() ? "_files"
                                             : " ");
}

std::string zsh_arguments(const CLI::App& app, const CLI::App& command) {
    std::string lines;
    for (const OptionText& option : options_of(command)) {
        for (const std::string& name : option.names) {
            lines += fmt::format(" \\\n                '{}['{}']{}'", name, in_quotes(option.text),
                                 option.value.empty() ? "" : zsh_action(option));
        }
        if (option.names.empty() && option.value == "FILE") lines += " \\\n                '*:file:_files'";
    }
    const std::vector<std::string> words = first_words(app, command);
    if (!words.empty()) lines += fmt::format(" \\\n                '1:word:({})'", fmt::join(words, " "));
    return lines;
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
    std::string values, options, words;
    for (const CLI::App* command : commands_of(app)) {
        values += bash_values(*command);
        const auto one = [&](const std::vector<std::string>& list) {
            return fmt::format("            {}) COMPREPLY=($(compgen -W '{}' -- \"$word\")) ;;\n", command->get_name(),
                               fmt::join(list, " "));
        };
        options += one(option_names(*command));
        if (const auto list = first_words(app, *command); !list.empty()) words += one(list);
    }
    return fmt::format(R"(# bash completion of pelage; made by `pelage completion bash`.
_pelage() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} command=${{COMP_WORDS[1]}}
    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then
        COMPREPLY=($(compgen -W '{} {}' -- "$word"))
        return
    fi
    case "$command $before" in
{}    esac
    case $word in
        -*) case $command in
{}        esac ;;
        *) case $command in
{}        esac ;;
    esac
}}
complete -o default -F _pelage pelage
)",
                       fmt::join(command_names(app), " "), fmt::join(option_names(app), " "), values, options, words);
}

std::string zsh_completion(const CLI::App& app) {
    std::string names, cases;
    for (const CLI::App* command : commands_of(app)) {
        names += fmt::format("                {}\n",
                             in_quotes(command->get_name()) + "':'" + in_quotes(command->get_description()));
        cases += fmt::format("            {})\n                _arguments{} ;;\n", command->get_name(),
                             zsh_arguments(app, *command));
    }
    return fmt::format(R"(#compdef pelage
# zsh completion of pelage; made by `pelage completion zsh`.
_pelage() {{
    local context state state_descr line
    typeset -A opt_args
    _arguments -C '--help[Tell all options]' '--version[Print the version]' '1:command:->command' '*::word:->word'
    case $state in
        command)
            local -a commands=(
{}            )
            _describe command commands ;;
        word) case $words[1] in
{}        esac ;;
    esac
}}
_pelage "$@"
)",
                       names, cases);
}

}  // namespace pelage::app
