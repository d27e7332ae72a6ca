// See candidate.hpp.
#include "tune/candidate.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace pelage::tune {

namespace {

constexpr std::array<std::pair<Fusion, const char*>, 5> kernels{{{Fusion::automatic, "defaults"},
                                                                 {Fusion::always, "streamed"},
                                                                 {Fusion::shared, "shared"},
                                                                 {Fusion::tiled, "tiled"},
                                                                 {Fusion::never, "plain"}}};

Fusion kernel_named(const std::string& name) {
    for (const auto& [fusion, word] : kernels) {
        if (name == word) return fusion;
    }
    throw Error("there is no kernel '" + name + "' to tune");
}

}  // namespace

std::string kernel_name(Fusion fusion) {
    for (const auto& [kernel, word] : kernels) {
        if (fusion == kernel) return word;
    }
    return "unknown";
}

std::string Candidate::text() const {
    std::string words = kernel_name(fusion);
    const auto add = [&](const char* before, std::size_t value, const char* after) {
        if (value != 0) words += fmt::format(", {}{}{}", before, value, after);
    };
    add("width ", width, "");
    add("depth ", cut.depth, "");
    if (fusion == Fusion::tiled) {
        if (cut.columns != 0 || cut.rows != 0) words += fmt::format(", tiles of {} x {}", cut.columns, cut.rows);
    } else {
        add("", cut.columns, " columns");
        add("blocks of ", cut.rows, " rows");
    }
    add("groups of ", cut.group, "");
    return words;
}

OpenclOptions applied(const Candidate& candidate, OpenclOptions options) {
    options.fusion = candidate.fusion;
    options.width = candidate.width;
    options.cut = candidate.cut;
    if (candidate.fusion == Fusion::never && candidate.cut.group != 0) options.work_group = candidate.cut.group;
    return options;
}

Candidate plain_kernel() { return {Fusion::never, 1, {}}; }

nlohmann::ordered_json to_json(const Candidate& candidate) {
    return {{"kernel", kernel_name(candidate.fusion)}, {"width", candidate.width},   {"depth", candidate.cut.depth},
            {"columns", candidate.cut.columns},        {"rows", candidate.cut.rows}, {"group", candidate.cut.group}};
}

Candidate candidate_from_json(const nlohmann::ordered_json& json) {
    try {
        Candidate candidate;
        candidate.fusion = kernel_named(json.at("kernel").get<std::string>());
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
