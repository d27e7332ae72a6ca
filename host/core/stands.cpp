// See stands.hpp.
#include "core/stands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace pelage {

namespace {

// Empty where there are fewer lines.
std::optional<std::string_view> line_of(std::string_view text, std::size_t line) {
    for (; line > 1; --line) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) return std::nullopt;
        text.remove_prefix(end + 1);
    }
    return text.substr(0, text.find('\n'));
}

}  // namespace

std::string where_stands(const Experiment& experiment, std::size_t line, std::string_view part) {
    const std::string place = experiment.where(line);
    const auto text = line_of(experiment.text, line);
    const std::size_t at = text && line > 0 ? text->find(part) : std::string_view::npos;
    if (at == std::string_view::npos) return place;
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xc0u) == 0x80u; };
    const auto before = text->substr(0, at);
    const auto hidden = std::ranges::count_if(before, continues);
    return fmt::format("{}:{}", place, before.size() - static_cast<std::size_t>(hidden) + 1);
}

}  // namespace pelage
