// define chemical | chemicals | parameter | field | division_limit | domain | time_step | stencil
#include "language/picture.hpp"
#include "language/statements.hpp"
#include "language/vocabulary.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

namespace pelage::language {

namespace {

constexpr std::array<std::string_view, 6> chemical_words{"limit", "floor", "conc", "channel", "from", "anisotropic"};

struct ChemicalOptions {
    Bounds bounds;
    bool anisotropic = false;
    const Token* of_polarity = nullptr;  // the word
    PictureOptions picture;
};

double parse_bound(Cursor& cursor, std::string_view what, double none) {
    if (cursor.take("none")) return none;
    return cursor.number(what);
}

// Changes what the options say and leaves the rest as it is.
void parse_options(Cursor& cursor, Words words, ChemicalOptions& chemical) {
    PictureOptions& picture = chemical.picture;
    Options options(words);
    const Token* of_picture = nullptr;
    while (true) {
        const Token& token = cursor.peek();
        const auto option = options.next(cursor);
        if (!option) break;
        const std::string_view word = words[*option];
        if (word == "channel" || word == "from") of_picture = &token;
        if (word == "limit")
            chemical.bounds.limit = parse_bound(cursor, "the limit", infinity);
        else if (word == "floor")
            chemical.bounds.floor = parse_bound(cursor, "the floor", -infinity);
        else if (word == "conc")
            picture.file = &cursor.text("the picture's name");
        else if (word == "channel")
            parse_channel(cursor, picture);
        else if (word == "from")
            parse_scale(cursor, picture);
        else {
            chemical.anisotropic = true;
            chemical.of_polarity = &token;
        }
    }
    if (of_picture != nullptr && picture.file == nullptr) {
        cursor.fail(*of_picture, fmt::format("'{}' belongs to a picture; add 'conc \"PICTURE\"'", of_picture->text));
    }
}

void check_bounds(const Cursor& cursor, const Token& name, const Bounds& bounds) {
    if (bounds.floor <= bounds.limit) return;
    cursor.fail(name, fmt::format("the floor {} of '{}' is above its limit {}", bounds.floor, name.text, bounds.limit));
}

// Inside a phase: new bounds for a chemical that exists.
void parse_phase_bounds(Script& script, Cursor& cursor) {
    const Token& name = cursor.peek();
    Bounds& bounds = script.phase().bounds[script.chemical(cursor)];
    ChemicalOptions options{bounds, false, nullptr, {}};
    parse_options(cursor, Words(chemical_words).first(2), options);
    check_bounds(cursor, name, options.bounds);
    bounds = options.bounds;
}

void parse_chemical(Script& script, Cursor& cursor) {
    if (script.in_phase()) return parse_phase_bounds(script, cursor);
    const Token& name = cursor.value("the chemical's name");
    check_name(script, cursor, name, "chemical");
    auto& chemicals = script.experiment.chemicals;
    if (chemicals.size() == largest_chemical_count) {
        cursor.fail(name, fmt::format("one chemical too many; at most {} are allowed", largest_chemical_count));
    }
    Chemical chemical;
    chemical.name = std::string(name.text);
    ChemicalOptions options;
    parse_options(cursor, chemical_words, options);
    check_bounds(cursor, name, options.bounds);
    chemical.bounds = options.bounds;
    chemical.anisotropic = options.anisotropic;
    if (options.of_polarity != nullptr) script.needs_plane(cursor, *options.of_polarity);
    if (options.picture.file != nullptr) {
        script.needs_plane(cursor, *options.picture.file);
        chemical.initial = load_start_picture(script, cursor, options.picture);
        if (chemical.initial) script.shows_picture(cursor, *options.picture.file);
    }
    script.phase().bounds.push_back(chemical.bounds);
    chemicals.push_back(std::move(chemical));
}

// Numbered ones that are alike: NAME0, NAME1 ...
void parse_chemicals(Script& script, Cursor& cursor) {
    static constexpr std::size_t options_for_all = 2;  // of chemical_words
    const Token& name = cursor.value("the chemicals' name");
    auto& chemicals = script.experiment.chemicals;
    const Token& number = cursor.peek();
    const std::uint64_t count = cursor.integer("the number of chemicals", 1, largest_chemical_count);
    if (count > largest_chemical_count - chemicals.size())
        cursor.fail(number, fmt::format("{} chemicals too many; at most {} are allowed",
                                        count - (largest_chemical_count - chemicals.size()), largest_chemical_count));
    ChemicalOptions options;
    parse_options(cursor, Words(chemical_words).first(options_for_all), options);
    check_bounds(cursor, name, options.bounds);
    for (std::uint64_t i = 0; i < count; ++i) {
        Chemical chemical;
        chemical.name = fmt::format("{}{}", name.text, i);
        check_name(script, cursor, {chemical.name, name.offset, false}, "chemical");
        chemical.bounds = options.bounds;
        script.phase().bounds.push_back(chemical.bounds);
        chemicals.push_back(std::move(chemical));
    }
}

void parse_domain(Script& script, Cursor& cursor) {
    Domain& domain = script.experiment.domain;
    domain = Domain{};
    if (cursor.take("packed")) {
        domain.packed = true;
        if (cursor.done()) return;
        cursor.expect("area");
        domain.area = cursor.number("the area of a cell", positive);
        return;
    }
    domain.width = cursor.number("the domain's width (or the word 'packed')", positive);
    domain.height = cursor.number("the domain's height", positive);
}

// So many numbers, the upper row first.
StencilWeights parse_weights(Cursor& cursor, std::size_t count) {
    StencilWeights weights(count);
    const std::string what = fmt::format("one of {} weights", count == 9 ? "nine" : std::to_string(count));
    for (double& weight : weights) weight = cursor.number(what);
    return weights;
}

StencilWeights parse_own_weights(Cursor& cursor, std::size_t count) {
    const Token& first = cursor.peek();
    StencilWeights weights = parse_weights(cursor, count);
    double sum = 0.0, size = 0.0;
    for (const double weight : weights) {
        sum += weight;
        size += std::fabs(weight);
    }
    if (size == 0.0) cursor.fail(first, "all weights are 0: nothing would diffuse");
    if (std::fabs(sum) > 1e-6 * size)
        cursor.fail(first,
                    fmt::format("the weights add up to {:g}; diffusion makes nothing: the one in the middle must be "
                                "minus the sum of the others, {:g}",
                                sum, weights[count / 2] - sum));
    return weights;
}

constexpr std::array<std::string_view, 8> stencil_words{"moore", "nine-point", "five-point",  "sims",
                                                        "3x3",   "5x5",        "seven-point", "twenty-seven-point"};

void parse_named_stencil(Script& script, Cursor& cursor) {
    static constexpr std::array<std::string_view, 3> sizes{"3x3", "5x5", "7x7"};
    static constexpr std::array<std::size_t, 3> counts{9, 25, 49};
    const Token& name = cursor.next();
    check_name(script, cursor, name, "stencil");
    auto& stencils = script.experiment.stencils;
    if (stencils.size() == largest_stencil_count)
        cursor.fail(name, fmt::format("one stencil too many; at most {} are allowed", largest_stencil_count));
    const std::size_t count = counts[cursor.choose(sizes)];
    stencils.push_back({std::string(name.text), cursor.line(), parse_weights(cursor, count)});
    script.needs_lattice(cursor, name);
    script.needs_plane(cursor, name);
}

void parse_stencil(Script& script, Cursor& cursor, const Token& word) {
    static constexpr std::array stencils{
        Stencil::moore, Stencil::nine_point, Stencil::five_point,  Stencil::sims,
        Stencil::own,   Stencil::own,        Stencil::seven_point, Stencil::twenty_seven_point};
    const std::string_view ahead = cursor.peek_behind().text;
    if (!cursor.done() && (ahead == "3x3" || ahead == "5x5" || ahead == "7x7"))
        return parse_named_stencil(script, cursor);
    const Token& chosen_word = cursor.peek();
    const std::size_t chosen = cursor.choose(stencil_words);
    script.experiment.stencil = stencils[chosen];
    if (script.experiment.stencil == Stencil::own)
        script.experiment.weights = parse_own_weights(cursor, chosen == 5 ? 25 : 9);
    if (of_volumes(script.experiment.stencil)) return script.needs_volume(cursor, chosen_word);
    script.needs_plane(cursor, chosen_word);
    script.needs_matrix(cursor, word);
}

void parse_time_step(Script& script, Cursor& cursor) {
    const Token& token = cursor.peek();
    const double step = cursor.number("the time step", positive);
    if (step < smallest_time_step) {
        cursor.fail(token, fmt::format("'{}' is 0 in float; the time step must be at least {:.3g}", token.text,
                                       smallest_time_step));
    }
    script.phase().time_step = step;
}

}  // namespace

std::vector<std::string_view> words_of_stencils() { return {stencil_words.begin(), stencil_words.end()}; }

void parse_define(Script& script, Cursor& cursor) {
    static constexpr std::array<std::string_view, 8> words{"chemical", "time_step", "division_limit", "domain",
                                                           "stencil",  "parameter", "field",          "chemicals"};
    const Token& word = cursor.peek();
    const std::size_t what = cursor.choose(words);
    const bool in_phases = word.text == "chemical" || word.text == "time_step";
    if (!in_phases) script.outside_phases(cursor, word, fmt::format("define {}", word.text));
    switch (what) {
        case 0:
            return parse_chemical(script, cursor);
        case 1:
            return parse_time_step(script, cursor);
        case 2:
            script.experiment.division_limit = cursor.integer("the division limit", 0, largest_cell_count);
            return;
        case 3:
            return parse_domain(script, cursor);
        case 4:
            return parse_stencil(script, cursor, word);
        case 5:
            return parse_parameter(script, cursor);
        case 6:
            return parse_place_field(script, cursor);
        default:
            return parse_chemicals(script, cursor);
    }
}

}  // namespace pelage::language
