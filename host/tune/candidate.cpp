// See candidate.hpp.
#include "tune/candidate.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace pelage::tune {

namespace {

Path path_named(const std::string& name) {
    const auto found = std::ranges::find(path_words, name);
    if (found == path_words.end()) throw Error("there is no kernel '" + name + "' to tune");
    return static_cast<Path>(found - path_words.begin());
}

}  // namespace

std::string Candidate::text() const {
    if (*this == Candidate{}) return "defaults";
    std::string words = word(path);
    const auto add = [&](const char* before, std::size_t value, const char* after) {
        if (value != 0) words += fmt::format(", {}{}{}", before, value, after);
    };
    add("width ", width, "");
    add("depth ", cut.depth, "");
    if (path == Path::tiled) {
        if (cut.columns != 0 || cut.rows != 0) words += fmt::format(", tiles of {} x {}", cut.columns, cut.rows);
    } else {
        add("", cut.columns, " columns");
        add("blocks of ", cut.rows, " rows");
    }
    add("groups of ", cut.group, "");
    return words;
}

OpenclOptions applied(const Candidate& candidate, OpenclOptions options) {
    options.path = candidate.path;
    options.width = candidate.width;
    options.cut = candidate.cut;
    if (candidate.path == Path::step && candidate.cut.group != 0) options.work_group = candidate.cut.group;
    return options;
}

Candidate single_step() { return {Path::step, 1, {}}; }

nlohmann::ordered_json to_json(const Candidate& candidate) {
    return {{"kernel", word(candidate.path)},   {"width", candidate.width},   {"depth", candidate.cut.depth},
            {"columns", candidate.cut.columns}, {"rows", candidate.cut.rows}, {"group", candidate.cut.group}};
}

Candidate candidate_from_json(const nlohmann::ordered_json& json) {
    try {
        Candidate candidate;
        candidate.path = path_named(json.at("kernel").get<std::string>());
        candidate.width = json.at("width").get<std::size_t>();
        candidate.cut.depth = json.at("depth").get<std::size_t>();
        candidate.cut.columns = json.at("columns").get<std::size_t>();
        candidate.cut.rows = json.at("rows").get<std::size_t>();
        candidate.cut.group = json.at("group").get<std::size_t>();
        const std::array<std::size_t, 6> widths{0, 1, 2, 4, 8, 16};
        if (std::ranges::find(widths, candidate.width) == widths.end()) {
            throw Error(fmt::format("a candidate's width is {}; it may be 0, 1, 2, 4, 8 or 16", candidate.width));
        }
        return candidate;
    } catch (const nlohmann::json::exception& error) {
        throw Error(fmt::format("this is no candidate: {}", error.what()));
    }
}

}  // namespace pelage::tune
