// See visualpde_edges.hpp.
#include "import/visualpde_edges.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage::imports {

namespace {

constexpr std::array<std::string_view, 4> names_of_sides{"Left", "Right", "Bottom", "Top"};

std::string_view without_ends(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return lower;
}

TermRef cells_of_side(std::size_t side) {
    const auto last = [](const char* count) { return minus(name_term(count), number_term(1.0)); };
    switch (side) {
        case 0:
            return call_term("==", {name_term("COLUMN"), number_term(0.0)});
        case 1:
            return call_term("==", {name_term("COLUMN"), last("COLUMNS")});
        case 2:
            return call_term("==", {name_term("ROW"), number_term(0.0)});
        default:
            return call_term("==", {name_term("ROW"), last("ROWS")});
    }
}

PdeSide side_of(const std::string& kind, const std::string& value, const std::string& key, const PdePreset& preset,
                PdeMeaning& meaning, std::size_t species, Problems& problems) {
    const std::string lower = lower_case(kind);
    if (lower == "periodic") return {};
    if (lower == "dirichlet") return {PdeSide::Kind::fixed, meaning.read(value, key)};
    if (lower == "neumann" || lower == "robin") return {PdeSide::Kind::flux, meaning.read(value, key)};
    // The cell beyond the edge has that value.
    if (lower == "ghost")
        return {PdeSide::Kind::flux, over(minus(meaning.read(value, key), meaning.species(species - 1)), meaning.dx())};
    problems.refuse(fmt::format("{}: a boundary condition '{}' is not carried over", preset.at(key), kind));
    return {};
}

// "Left: Dirichlet = 0; Right: Neumann = 1; ..."
PdeEdges mixed_edges(const PdePreset& preset, PdeMeaning& meaning, const std::string& key, std::size_t species,
                     Problems& problems) {
    PdeEdges edges;
    std::array<bool, 4> said{};
    const std::string all = preset.field(key);
    for (std::string_view rest = all; !rest.empty();) {
        const std::size_t end = rest.find(';');
        const std::string_view one = without_ends(rest.substr(0, end));
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        if (one.empty()) continue;
        const std::size_t colon = one.find(':'), equals = one.find('=');
        const auto side = std::ranges::find(names_of_sides, without_ends(one.substr(0, colon)));
        if (side == names_of_sides.end() || colon == std::string_view::npos) {
            problems.refuse(fmt::format("{}: '{}' is no boundary condition", preset.at(key), one.substr(0, 60)));
            continue;
        }
        const std::size_t index = static_cast<std::size_t>(side - names_of_sides.begin());
        const std::string kind(
            without_ends(one.substr(colon + 1, equals == std::string_view::npos ? equals : equals - colon - 1)));
        const std::string value(equals == std::string_view::npos ? "0" : one.substr(equals + 1));
        if (said[index])
            problems.note(fmt::format("{}: a second condition for '{}' is left out", preset.at(key), *side));
        if (!said[index]) edges[index] = side_of(kind, value, key, preset, meaning, species, problems);
        said[index] = true;
    }
    return edges;
}

std::size_t count_of_sides(bool one_dimensional) { return one_dimensional ? 2 : 4; }

}  // namespace

PdeEdges read_edges(const PdePreset& preset, PdeMeaning& meaning, std::size_t species, Problems& problems) {
    const std::string kind = preset.field("boundaryConditions", species);
    if (lower_case(kind) == "combo" || lower_case(kind) == "mixed")
        return mixed_edges(preset, meaning, fmt::format("comboStr_{}", species), species, problems);
    const std::string key = fmt::format("{}Str_{}", lower_case(kind), species);
    PdeEdges edges;
    edges.fill(side_of(kind, preset.field(key), key, preset, meaning, species, problems));
    return edges;
}

TermRef cells_along(const PdeEdges& edges, bool one_dimensional, PdeSide::Kind kind) {
    TermRef all;
    for (std::size_t i = 0; i < count_of_sides(one_dimensional); ++i) {
        if (edges[i].kind == kind) all = all ? call_term("or", {all, cells_of_side(i)}) : cells_of_side(i);
    }
    return all;
}

std::string edge_of_lattice(const std::vector<PdeEdges>& all, const std::vector<bool>& counts,
                            const std::vector<std::string>& species, bool one_dimensional, const PdePreset& preset,
                            Problems& problems) {
    const std::size_t sides = count_of_sides(one_dimensional);
    const auto any = [&](const PdeEdges& edges, PdeSide::Kind kind) {
        return std::any_of(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(sides),
                           [&](const PdeSide& one) { return one.kind == kind; });
    };
    const bool none_counts = std::ranges::find(counts, true) == counts.end();
    bool wrap = false;
    for (std::size_t i = 0; i < all.size(); ++i)
        wrap = wrap || ((counts[i] || none_counts) && any(all[i], PdeSide::Kind::periodic));
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (wrap && counts[i] && any(all[i], PdeSide::Kind::flux))
            problems.note(
                fmt::format("{}: '{}' is periodic here where it has a condition on its slope: the edge is one for all "
                            "species and sides",
                            preset.name(), species[i]));
    }
    return wrap ? "wrap" : "no-flux";
}

TermRef inflow(const PdeEdges& edges, bool one_dimensional, const TermRef& rate, const TermRef& dx) {
    TermRef sum = number_term(0.0);
    for (std::size_t i = 0; i < count_of_sides(one_dimensional); ++i) {
        if (edges[i].kind != PdeSide::Kind::flux || is_number(edges[i].value, 0.0)) continue;
        sum = plus(sum, choice(cells_of_side(i), over(times(rate, edges[i].value), dx), number_term(0.0)));
    }
    return sum;
}

}  // namespace pelage::imports
