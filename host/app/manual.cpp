// See manual.hpp.
#include "app/manual.hpp"

#include "app/command_line.hpp"
#include "app/options_of.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <string_view>
#include <vector>

namespace pelage::app {

namespace {

// Backslashes and hyphens have a meaning of their own there, and so has a point or quote that begins a line.
std::string escaped(std::string_view text) {
    std::string result = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
    for (const char c : text) {
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else
            result += c;
    }
    return result;
}

std::string bold(std::string_view text) { return fmt::format("\\fB{}\\fR", escaped(text)); }
std::string italic(std::string_view text) { return fmt::format("\\fI{}\\fR", escaped(text)); }

std::string entry(const OptionText& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.names) names.push_back(bold(name));
    if (!option.value.empty() && names.empty()) names.push_back(italic(option.value));
    const std::string value =
        option.names.empty() || option.value.empty() ? "" : fmt::format(" {}", italic(option.value));
    return fmt::format(".TP\n{}{}\n{}\n", fmt::join(names, ", "), value, escaped(option.text));
}

std::string synopsis(const CLI::App& command) {
    std::string words = bold("pelage " + command.get_name()) + " [options]";
    for (const OptionText& option : options_of(command)) {
        if (option.names.empty()) words.append(" ").append(italic(option.value));
    }
    return words;
}

std::string section(const CLI::App& command) {
    std::string text = fmt::format(".SS {}\n{}.\n", synopsis(command), escaped(command.get_description()));
    for (const OptionText& option : options_of(command)) text += entry(option);
    return text;
}

constexpr std::string_view after_commands =
    ".SH EXIT STATUS\n"
    "0 success; 1 a run met NaN or infinity, a check failed; 2 bad input; 130 stopped by Ctrl\\-C.\n"
    ".SH ENVIRONMENT\n"
    ".TP\n\\fBPELAGE_DEVICE\\fR\nThe OpenCL device where \\fB\\-\\-device\\fR names none.\n"
    ".TP\n\\fBPELAGE_CACHE\\fR\nThe folder for compiled device programs and what was tuned.\n"
    ".SH FILES\n"
    ".TP\n\\fI~/.cache/pelage\\fR\nThat folder where nothing else is said; below \\fB$XDG_CACHE_HOME\\fR where that is "
    "set.\n";

}  // namespace

std::string manual(const CLI::App& app) {
    std::string text = fmt::format(".TH PELAGE 1 \"\" \"pelage {}\" \"User Commands\"\n", PELAGE_VERSION);
    text += ".SH NAME\npelage \\- grows animal skin patterns by reaction and diffusion\n.SH SYNOPSIS\n";
    for (const CLI::App* command : commands_of(app)) text += synopsis(*command) + "\n.br\n";
    text += fmt::format(".SH DESCRIPTION\n{}\n.SH OPTIONS\n", escaped(app.get_description()));
    for (const OptionText& option : options_of(app)) text += entry(option);
    text += ".SH COMMANDS\n";
    for (const CLI::App* command : commands_of(app)) text += section(*command);
    return text.append(after_commands);
}

}  // namespace pelage::app
