// See random_cells.hpp.
#include "verify/random_cells.hpp"

#include "core/prepattern.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage::verify {

namespace {

std::string polarity(Draft& draft) {
    if (draft.dice.chance(20)) return "polarity none";
    const double degrees = draft.dice.real(-180.0, 360.0);
    return "polarity " + draft.deviated(degrees, draft.dice.real(0.0, 180.0));
}

std::string concentration(Draft& draft, ChemicalDraft& chemical) {
    if (draft.limits.extremes && draft.dice.below(100) == 0) {
        const std::string extreme = draft.value(0.0, 5.0);
        const double value = std::stod(extreme);
        if (value >= chemical.floor && value <= chemical.limit) {
            chemical.pinned = true;
            return "conc " + extreme;
        }
    }
    if (draft.dice.chance(8)) {
        const double low = std::max(chemical.floor, chemical.conc - chemical.spread);
        const double high = std::min(chemical.limit, chemical.conc + chemical.spread);
        chemical.pinned = true;
        return "conc " + draw_expression(draft, ExpressionScope::start, low, high);
    }
    const std::string middle = "conc " + draft.dice.number(chemical.conc);
    return draft.dice.chance(90) ? words({middle, "dev", draft.dice.number(chemical.spread)}) : middle;
}

std::string rate(Draft& draft, ChemicalDraft& chemical) {
    Dice& dice = draft.dice;
    const double most = draft.largest_rate();
    double value = most * dice.real(0.02, 0.6);
    if (dice.chance(6)) {
        chemical.rate = std::max(chemical.rate, value);
        return "diff " + draw_expression(draft, ExpressionScope::start, 0.25 * value, value);
    }
    switch (dice.weighted({15, 5, 2})) {
        case 0:
            value = dice.chance(18) ? 0.0 : value;
            break;
        case 1:
            value = most;
            break;
        default:
            value = draft.kind == TissueKind::free_cells ? -0.05 * value : 0.0;  // runs the wrong way, slowly
    }
    const bool uneven = value > 0.0 && dice.chance(30);
    chemical.rate = std::max(chemical.rate, value);
    const double deviation = std::min(value, most - value) * dice.real(0.125, 1.0);
    return "diff " + (uneven ? draft.deviated(value, deviation) : dice.number(value));
}

// The first time with a concentration, for 0 need not lie within the bounds.
void use_chemical(Draft& draft, ChemicalDraft& chemical, bool first) {
    std::vector<std::string> options;
    if (draft.dice.chance(95) || first) options.push_back(concentration(draft, chemical));
    if (draft.dice.chance(88)) options.push_back(rate(draft, chemical));
    draft.line(words({"use chemical", chemical.name, draft.shuffled(options)}));
}

// ---- free cells

std::size_t count(Arrangement arrangement, std::size_t size) {
    Experiment alone;
    CreateGrid grid;
    grid.arrangement = arrangement;
    grid.columns = size;
    alone.prepattern.emplace_back(grid);
    return count_cells(alone);
}

std::string placement(Draft& draft, bool jitter) {
    Dice& dice = draft.dice;
    std::vector<std::string> options;
    if (dice.chance(40)) options.push_back(words({"at", dice.number(-6.0, 6.0), dice.number(-6.0, 6.0)}));
    if (jitter && dice.chance(50)) options.push_back("dev " + dice.number(0.0, 1.5));
    if (dice.chance(12)) options.emplace_back("fixed");
    return draft.shuffled(options);
}

// Each returns how many cells the statement makes, at most about `most`.
std::size_t create_grid(Draft& draft, std::size_t most, bool square) {
    const std::size_t columns = draft.dice.from_to(1, std::min<std::size_t>(most, 14));
    const std::size_t rows = draft.dice.from_to(1, std::min<std::size_t>(most / columns, 14));
    // Jittered, so that a square grid alone is no lattice.
    const std::string jitter = square ? "dev " + draft.dice.number(0.125, 1.0) : "";
    const std::string wrap = square && draft.dice.chance(20) ? "wrap" : "";
    const std::string what = fmt::format("create {} {} {}", square ? "sqr_grid" : "hex_grid", columns, rows);
    draft.line(words({what, jitter, placement(draft, !square), wrap}));
    return columns * rows;
}

std::size_t create_circle(Draft& draft, std::size_t most, bool square) {
    const Arrangement arrangement = square ? Arrangement::sqr_circle : Arrangement::hex_circle;
    std::size_t size = draft.dice.from_to(2, square ? 14 : 12);
    while (size > 1 && count(arrangement, size) > most) --size;
    const std::string what = fmt::format("create {} {}", square ? "sqr_circle" : "hex_circle", size);
    draft.line(words({what, placement(draft, true)}));
    return count(arrangement, size);
}

std::size_t create_single(Draft& draft) {
    // On a coarse raster, so that some cells lie on top of each other.
    const double x = static_cast<double>(draft.dice.from_to(0, 16)) * 0.75 - 6.0;
    const double y = static_cast<double>(draft.dice.from_to(0, 16)) * 0.75 - 6.0;
    draft.line(
        words({"create cell", draft.dice.number(x), draft.dice.number(y), draft.dice.chance(25) ? "fixed" : ""}));
    return 1;
}

std::size_t create_shape(Draft& draft) {
    const RandomShape& shape = draft.limits.shapes[draft.dice.below(draft.limits.shapes.size())];
    draft.line(words({fmt::format("create shape \"{}\"", shape.file), placement(draft, false)}));
    return shape.cells;
}

std::size_t create_some(Draft& draft, std::size_t most) {
    switch (draft.dice.weighted({3, 2, 3, 2, 2, draft.limits.shapes.empty() ? 0u : 3u})) {
        case 0:
            return create_grid(draft, most, false);
        case 1:
            return create_grid(draft, most, true);
        case 2:
            return create_circle(draft, most, false);
        case 3:
            return create_circle(draft, most, true);
        case 4:
            return create_single(draft);
        default:
            return create_shape(draft);
    }
}

}  // namespace

void draw_seed(Draft& draft) {
    draft.line(fmt::format("use seed {}", draft.dice.pick<std::int64_t>({1, 2, 42, -1, 20170516, 4294967295, 4294967296,
                                                                         -9223372036854775807, 9223372036854775807})));
}

void draw_uses(Draft& draft) {
    for (ChemicalDraft& chemical : draft.chemicals) use_chemical(draft, chemical, true);
    if (draft.plane() && draft.dice.chance(50)) draft.line("use " + polarity(draft));
}

void create_cells(Draft& draft) {
    const std::size_t stretches = draft.dice.from_to(1, 4);
    for (std::size_t i = 0; i < stretches && draft.cells < draft.limits.cells; ++i) {
        if (i > 0 && draft.dice.chance(50)) {
            use_chemical(draft, draft.any_chemical(), false);
            if (draft.dice.chance(40)) draft.line("use " + polarity(draft));
            if (draft.dice.chance(15)) draw_seed(draft);
        }
        draft.cells += create_some(draft, draft.limits.cells - draft.cells);
    }
}

void set_cells(Draft& draft) {
    Dice& dice = draft.dice;
    const std::size_t times = dice.from_to(1, 3);
    for (std::size_t i = 0; i < times; ++i) {
        const std::size_t first = dice.below(draft.cells);
        const bool several = dice.chance(60);
        std::string text = fmt::format("set cell {}", first);
        if (several) text = fmt::format("set cells {} to {}", first, dice.from_to(first, draft.cells - 1));
        if (dice.chance(20)) text = "set cells where " + draw_expression(draft, ExpressionScope::start, -1.0, 1.0);
        std::vector<std::string> options;
        if (!draft.plane() || dice.chance(70)) {
            ChemicalDraft& chemical = draft.any_chemical();
            std::vector<std::string> values;
            if (dice.chance(60)) values.push_back(concentration(draft, chemical));
            if (dice.chance(40) || values.empty()) values.push_back(rate(draft, chemical));
            options.push_back(words({"chemical", chemical.name, draft.shuffled(values)}));
        }
        if (draft.plane() && dice.chance(35)) options.push_back(polarity(draft));
        if ((draft.plane() && dice.chance(15)) || options.empty()) options.emplace_back("fixed");
        draft.line(words({text, draft.shuffled(options)}));
    }
}

}  // namespace pelage::verify
