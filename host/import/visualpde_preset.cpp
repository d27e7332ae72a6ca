// See visualpde_preset.hpp.
#include "import/visualpde_preset.hpp"

#include "core/error.hpp"
#include "import/lz_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>

namespace pelage::imports {

namespace {

using nlohmann::json;

constexpr std::size_t largest_preset = std::size_t{1} << 22;  // bytes of JSON
constexpr int deepest_preset = 30;

struct NumberedField {
    std::string_view brief;  // with letters of species behind it: "rU"
    std::string_view old;    // "reactionStrU"
    std::string_view now;    // "reactionStr_1"
    std::size_t species;
};

constexpr std::array<NumberedField, 8> numbered_fields{{{"b", "boundaryConditions", "boundaryConditions", 1},
                                                        {"c", "clearValue", "initCond", 1},
                                                        {"cs", "comboStr", "comboStr", 1},
                                                        {"d", "diffusionStr", "diffusionStr", 2},
                                                        {"d", "dirichletStr", "dirichletStr", 1},
                                                        {"n", "neumannStr", "neumannStr", 1},
                                                        {"r", "reactionStr", "reactionStr", 1},
                                                        {"ro", "robinStr", "robinStr", 1}}};

constexpr std::array<std::array<std::string_view, 2>, 29> brief_fields{{{"aVi", "activeViewInd"},
                                                                        {"aV", "algebraicV"},
                                                                        {"aW", "algebraicW"},
                                                                        {"ap", "autoPause"},
                                                                        {"apa", "autoPauseAt"},
                                                                        {"cD", "crossDiffusion"},
                                                                        {"d", "domainIndicatorFun"},
                                                                        {"di", "dimension"},
                                                                        {"ds", "domainScale"},
                                                                        {"dt", "dt"},
                                                                        {"dv", "domainViaIndicatorFun"},
                                                                        {"iS", "initialState"},
                                                                        {"io", "imagePathOne"},
                                                                        {"it", "imagePathTwo"},
                                                                        {"k", "kineticParams"},
                                                                        {"ma", "maxColourValue"},
                                                                        {"mi", "minColourValue"},
                                                                        {"n", "numSpecies"},
                                                                        {"na", "numAlgebraicSpecies"},
                                                                        {"o", "oneDimensional"},
                                                                        {"p", "preset"},
                                                                        {"pa", "parent"},
                                                                        {"rs", "randSeed"},
                                                                        {"sn", "speciesNames"},
                                                                        {"sp", "spatialStep"},
                                                                        {"sq", "squareCanvas"},
                                                                        {"ts", "timesteppingScheme"},
                                                                        {"v", "views"},
                                                                        {"wp", "whatToPlot"}}};

constexpr std::array<std::array<std::string_view, 2>, 22> usual_values{{{"boundaryConditions", "periodic"},
                                                                        {"diffusionStr_1_1", "0.04"},
                                                                        {"diffusionStr_2_2", "0.02"},
                                                                        {"diffusionStr_3_3", "0.02"},
                                                                        {"diffusionStr", "0"},
                                                                        {"dimension", "2"},
                                                                        {"dirichletStr", "0"},
                                                                        {"neumannStr", "0"},
                                                                        {"robinStr", "0"},
                                                                        {"domainScale", "100"},
                                                                        {"dt", "0.1"},
                                                                        {"initCond_1", "1.0"},
                                                                        {"initCond", "0"},
                                                                        {"minX", "0"},
                                                                        {"minY", "0"},
                                                                        {"numSpecies", "2"},
                                                                        {"numAlgebraicSpecies", "0"},
                                                                        {"spatialStep", "0.5"},
                                                                        {"speciesNames", "u v w q"},
                                                                        {"timescale", "1"},
                                                                        {"timesteppingScheme", "Euler"},
                                                                        {"autoPauseAt", "10"}}};

// The model that VisualPDE begins with is Gray-Scott's, with the rates of its best known spots.
constexpr std::array<std::array<std::string_view, 2>, 4> usual_reactions{{{"reactionStr_1", "0.037*(1.0 - u) - u*v^2"},
                                                                          {"reactionStr_2", "u*v^2 - (0.037+0.06)*v"},
                                                                          {"reactionStr_3", "u*v^2 - (0.037+0.06)*v"},
                                                                          {"reactionStr_4", "0"}}};

// "UV" as "_1_2"; empty where these are no letters of species.
std::string numbers_of(std::string_view letters, std::size_t count) {
    static constexpr std::string_view species = "UVWQ";
    if (letters.size() != count) return {};
    std::string text;
    for (const char letter : letters) {
        const std::size_t index = species.find(letter);
        if (index == std::string_view::npos) return {};
        text += fmt::format("_{}", index + 1);
    }
    return text;
}

std::string name_of_today(const std::string& key) {
    for (const NumberedField& one : numbered_fields) {
        for (const std::string_view beginning : {one.brief, one.old}) {
            if (!key.starts_with(beginning)) continue;
            const std::string numbers = numbers_of(std::string_view(key).substr(beginning.size()), one.species);
            if (!numbers.empty()) return std::string(one.now) + numbers;
        }
    }
    for (const auto& [brief, whole] : brief_fields) {
        if (key == brief) return std::string(whole);
    }
    return key;
}

std::string text_of_json(const json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_null()) return {};
    return value.dump();
}

// The compressed part of an address, if the text is one.
std::string_view options_of_address(std::string_view text) {
    for (const std::string_view key : {"?options=", "&options="}) {
        const std::size_t at = text.find(key);
        if (at == std::string_view::npos) continue;
        const std::string_view rest = text.substr(at + key.size());
        return rest.substr(0, rest.find_first_of("&# \t\r\n"));
    }
    return {};
}

std::string with_percents_resolved(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        unsigned code = 0;
        if (text[i] == '%' && i + 2 < text.size() &&
            std::sscanf(std::string(text.substr(i + 1, 2)).c_str(), "%2x", &code) == 1) {
            result += static_cast<char>(code);
            i += 2;
        } else {
            result += text[i];
        }
    }
    return result;
}

// VisualPDE's own files hold objects of JavaScript: their keys need no quotes, and a comma may follow the last field.
std::string with_quoted_keys(const std::string& text) {
    std::string result;
    const auto in_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    char before = '\0';  // the last sign that is no blank
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        std::size_t end = i + 1;
        if (c == '"') {
            while (end < text.size() && text[end] != '"') end += text[end] == '\\' ? 2 : 1;
            end = std::min(end + 1, text.size());
            result.append(text, i, end - i);
        } else if (in_name(c) && (before == '{' || before == ',')) {
            while (end < text.size() && in_name(text[end])) ++end;
            const std::size_t after = text.find_first_not_of(" \t\r\n", end);
            const bool key = after != std::string::npos && text[after] == ':';
            result += key ? '"' + text.substr(i, end - i) + '"' : text.substr(i, end - i);
        } else {
            const std::size_t after = c == ',' ? text.find_first_not_of(" \t\r\n", end) : std::string::npos;
            const bool last = after != std::string::npos && (text[after] == '}' || text[after] == ']');
            if (!last) result += c;
        }
        if (c != ' ' && c != '\t' && c != '\r' && c != '\n') before = c == '"' || in_name(c) ? 'a' : c;
        i = end;
    }
    return result;
}

// Of an address, or of compressed text alone; JSON stays as it is, also that which VisualPDE's "Copy code" gives.
std::string json_text(const std::string& text, const std::string& name) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string::npos) throw Error(fmt::format("{}: is empty", name));
    const std::size_t brace = text.find('{');
    if (text[first] == '{') return text;
    if (text.compare(first, 8, "presets[") == 0 && brace != std::string::npos)
        return with_quoted_keys(text.substr(brace, text.rfind('}') - brace + 1));
    std::string_view compressed = options_of_address(text);
    if (compressed.empty()) {
        if (text.find("://") != std::string::npos)
            throw Error(fmt::format("{}: is an address without 'options=', so it holds no preset", name));
        compressed = std::string_view(text).substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
    }
    const auto found = from_lz_text(with_percents_resolved(compressed), largest_preset);
    if (!found || found->empty() || (*found)[0] != '{')
        throw Error(
            fmt::format("{}: is neither XML, nor JSON, nor the compressed text of an address of VisualPDE", name));
    return *found;
}

json parsed(const std::string& text, const std::string& name) {
    if (text.size() > largest_preset)
        throw Error(fmt::format("{}: is longer than the {} bytes allowed of a preset", name, largest_preset));
    try {
        return json::parse(
            text,
            [&](int depth, json::parse_event_t, json&) {
                if (depth > deepest_preset)
                    throw Error(
                        fmt::format("{}: is nested too deeply; at most {} levels are allowed", name, deepest_preset));
                return true;
            },
            true, true);
    } catch (const json::parse_error& error) {
        std::string_view why = error.what();
        why.remove_prefix(std::min(why.find("] ") + 2, why.size()));
        throw Error(fmt::format("{}: is no JSON: {}", name, why));
    }
}

}  // namespace

PdePreset::PdePreset(std::string text, std::string name) : name_(std::move(name)) {
    const json all = parsed(json_text(text, name_), name_);
    if (!all.is_object()) throw Error(fmt::format("{}: is no object of JSON with the fields of a preset", name_));
    for (const auto& [key, value] : all.items()) put(name_of_today(key), text_of_json(value));
    // What is drawn may be said in a view.
    const json views = all.value(all.contains("views") ? "views" : "v", json());
    const std::size_t active = static_cast<std::size_t>(std::max(0, std::atoi(field("activeViewInd").c_str())));
    if (!views.is_array() || active >= views.size() || !views[active].is_object()) return;
    for (const auto& [key, value] : views[active].items()) {
        const std::string now = name_of_today(key);
        if (now == "whatToPlot" || now == "minColourValue" || now == "maxColourValue") put(now, text_of_json(value));
    }
}

void PdePreset::put(const std::string& key, std::string value) { fields_[key] = std::move(value); }

std::string PdePreset::field(std::string_view key) const {
    if (const auto found = fields_.find(key); found != fields_.end()) return found->second;
    for (const auto& [usual, value] : usual_reactions) {
        if (key == usual) return std::string(value);
    }
    for (std::string_view shorter = key; !shorter.empty();) {
        for (const auto& [usual, value] : usual_values) {
            if (shorter == usual) return std::string(value);
        }
        const std::size_t end = shorter.rfind('_');
        if (end == std::string_view::npos) break;
        shorter = shorter.substr(0, end);
    }
    return {};
}

std::string PdePreset::field(std::string_view key, std::size_t i) const { return field(fmt::format("{}_{}", key, i)); }

std::string PdePreset::field(std::string_view key, std::size_t i, std::size_t j) const {
    return field(fmt::format("{}_{}_{}", key, i, j));
}

bool PdePreset::truth(std::string_view key) const {
    const std::string value = field(key);
    return value == "true" || value == "1";
}

std::string PdePreset::at(std::string_view key) const { return fmt::format("{}: {}", name_, key); }

}  // namespace pelage::imports
