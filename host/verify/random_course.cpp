// The second half of a random experiment: rules, phases, the end of the run, and what is drawn of it.
#include "verify/random_draft.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace pelage::verify {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// New bounds about what the chemical may hold now.
void change_bounds(Draft& draft, ChemicalDraft& chemical) {
    if (chemical.pinned) return;
    Dice& dice = draft.dice;
    std::vector<std::string> options;
    if (dice.chance(60)) {
        const bool none = dice.chance(25);
        chemical.limit =
            none ? infinity : std::max(chemical.floor, chemical.conc + chemical.spread * dice.real(0.0, 3.0));
        options.push_back("limit " + (none ? "none" : dice.number(chemical.limit)));
    }
    if (dice.chance(40)) {
        const bool none = dice.chance(25);
        chemical.floor =
            none ? -infinity : std::min(chemical.limit, chemical.conc - chemical.spread * dice.real(0.0, 2.0));
        options.push_back("floor " + (none ? "none" : dice.number(chemical.floor)));
    }
    draft.line(words({"define chemical", chemical.name, draft.shuffled(options)}));
}

void draw_phase(Draft& draft, std::size_t place) {
    Dice& dice = draft.dice;
    draft.line(fmt::format("phase \"{} {}\" {}", dice.pick({"spots", "growth of", "// no remark,", "\xc3\xa9tape"}),
                           place, draft.span));
    const bool slower = dice.chance(35);
    if (slower) {
        draft.time_step *= dice.pick({0.25, 0.5, 0.75, 1.0});  // what held before holds at a smaller step
        draft.line("define time_step " + dice.number(draft.time_step));
    }
    if (draft.kind == TissueKind::charges) return;
    if (dice.chance(40)) change_bounds(draft, draft.any_chemical());
    if (dice.chance(40)) {
        ChemicalDraft& chemical = draft.any_chemical();
        chemical.rate = dice.chance(20) ? 0.0 : draft.largest_rate() * dice.real(0.02, 0.5);
        draft.line(fmt::format("use chemical {} diff {}", chemical.name, dice.number(chemical.rate)));
    }
}

void draw_snapshots(Draft& draft) {
    Dice& dice = draft.dice;
    const auto end = static_cast<std::size_t>(draft.iterations);
    const std::string exit = dice.chance(25) ? " then exit" : "";
    if (dice.chance(50)) {
        std::string text = "snap at";
        const std::size_t count = dice.from_to(1, 4);
        for (std::size_t i = 0; i < count; ++i) text += fmt::format(" {}", dice.from_to(1, end));
        return draft.line(text + exit);
    }
    const std::size_t repeat = dice.from_to(1, 4);
    const std::size_t first = dice.below(end / 2 + 1);
    const std::size_t step = dice.from_to(1, std::max<std::size_t>(1, end / 2 / repeat));
    draft.line(fmt::format("snap from {} repeat {} step {}{}", first, repeat, step, exit));
}

std::string colormap_word(Draft& draft) {
    return draft.dice.pick({"heat", "gradient", "striped", "inferno", "viridis", "magma", "gray"});
}

std::string colour(Draft& draft) {
    return draft.dice.pick({"white", "Black", "rebeccapurple", "ffcc00", "1A2b3c", "saddlebrown"});
}

std::string colour_stops(Draft& draft) {
    Dice& dice = draft.dice;
    std::string text = "\"";
    const std::size_t count = dice.from_to(2, 4);
    for (std::size_t i = 0; i < count; ++i) {
        const double at = static_cast<double>(i) / static_cast<double>(count - 1);
        text += i == 0 ? "" : dice.pick({", ", ",", "\" \""});
        text += fmt::format("{} at {}", colour(draft), at);
    }
    return text + "\"";
}

std::string range_word(Draft& draft) {
    Dice& dice = draft.dice;
    if (dice.chance(25)) return "range each";
    return words({"range", dice.number(-1.0, 1.0), dice.number(1.5, 9.0)});
}

void draw_map(Draft& draft, const ChemicalDraft& chemical) {
    Dice& dice = draft.dice;
    if (dice.chance(50)) return draft.line(words({"output", chemical.name, "normal", dice.number(-3.0, 3.0)}));
    std::vector<std::string> options{"height"};
    if (dice.chance(40)) options.push_back(range_word(draft));
    draft.line(words({"output", chemical.name, draft.shuffled(options)}));
}

// How a volume becomes a picture.
std::string projection(Draft& draft) {
    const std::size_t counts[] = {draft.columns, draft.rows, draft.layers};
    const std::size_t axis = draft.dice.below(3);
    const std::string slice = fmt::format("slice {} {}", "xyz"[axis], draft.dice.below(counts[axis]));
    return draft.dice.pick({slice, slice, std::string("maximum"), std::string("transparent")});
}

void draw_output(Draft& draft, const ChemicalDraft& chemical) {
    Dice& dice = draft.dice;
    std::vector<std::string> options;
    if (dice.chance(40)) options.push_back(range_word(draft));
    if (draft.kind == TissueKind::volume && dice.chance(75)) options.push_back(projection(draft));
    if (draft.kind == TissueKind::mesh && dice.chance(50))
        options.push_back(words({"from", dice.number(-2.0, 2.0), dice.number(-2.0, 2.0), dice.number(0.5, 2.0)}));
    if (dice.chance(70))
        options.push_back("colormap " + (dice.chance(60) ? colormap_word(draft) : colour_stops(draft)));
    draft.line(words({"output", chemical.name, draft.shuffled(options)}));
}

// An expression through a colormap, or three of them: red, green and blue.
void draw_formula(Draft& draft) {
    Dice& dice = draft.dice;
    const auto expression = [&] { return draw_expression(draft, ExpressionScope::rule, -0.5, 1.5); };
    if (dice.chance(50)) {
        const std::string red = expression();
        const std::string green = expression();
        return draft.line(words({"output", "rgb", red, green, expression(), "as", "colours"}));
    }
    std::vector<std::string> options{"as mixture"};
    if (dice.chance(40)) options.push_back(range_word(draft));
    const std::string drawn = expression();
    draft.line(words({"output", drawn, draft.shuffled(options)}));
}

void draw_slot(Draft& draft) {
    Dice& dice = draft.dice;
    const std::size_t slot = dice.below(100);
    if (dice.chance(50)) return draft.line(fmt::format("colormap slot {} use color \"{}\"", slot, colour(draft)));
    const std::size_t red = dice.below(256);
    const std::size_t green = dice.below(256);
    draft.line(fmt::format("colormap slot {} use rgb {} {} {}", slot, red, green, dice.below(256)));
}

}  // namespace

void draw_course(Draft& draft) {
    Dice& dice = draft.dice;
    const std::uint64_t most = std::max<std::uint64_t>(draft.limits.iterations, 4);
    const std::size_t phases = draft.limits.phases && dice.chance(35) ? dice.from_to(1, 3) : 0;
    const std::size_t rules = std::max<std::size_t>(draft.limits.rules, 1);
    draft.iterations = draft.span = dice.from_to(most / 3 + 1, most);
    const std::size_t least = phases == 0 || draft.kind == TissueKind::charges ? 1 : 0;
    const std::size_t before = dice.from_to(least, phases == 0 ? rules : std::max(least, rules / 2));
    for (std::size_t i = 0; i < before; ++i) draw_rule(draft);
    std::uint64_t left = draft.iterations;
    for (std::size_t phase = 0; phase < phases; ++phase) {
        draft.span = phase + 1 == phases ? left : dice.from_to(1, left - (phases - phase - 1));
        left -= draft.span;
        draw_phase(draft, phase + 1);
        const std::size_t count = dice.below((rules - before) / phases + 1);
        for (std::size_t i = 0; i < count; ++i) draw_rule(draft);
    }
    if (phases == 0 || dice.chance(30)) draft.line(fmt::format("stop at {}", draft.iterations));
    if (dice.chance(25)) draw_snapshots(draft);
}

void draw_pictures(Draft& draft) {
    Dice& dice = draft.dice;
    if (dice.chance(15)) draft.line("colormap select " + colormap_word(draft));
    if (dice.chance(15)) draw_slot(draft);
    const std::size_t outputs = dice.below(draft.chemicals.size() + 1);
    for (std::size_t i = 0; i < outputs; ++i) draw_output(draft, draft.chemicals[i]);
    if (dice.chance(20)) draw_formula(draft);
    if (draft.lattice() && dice.chance(20)) draw_map(draft, draft.any_chemical());
    if (draft.plane() && dice.chance(10)) {
        const std::size_t width = dice.from_to(1, 64);
        draft.line(fmt::format("texture size {} {}", width, dice.from_to(1, 64)));
    }
    if (dice.chance(10)) draft.line("zoom level " + dice.number(0.25, 4.0));
}

}  // namespace pelage::verify
