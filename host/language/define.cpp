// define chemical | parameter | division_limit | domain | time_step | stencil
#include "io/field.hpp"
#include "io/file_bytes.hpp"
#include "io/sha256.hpp"
#include "language/statements.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>

namespace pelage::language {

namespace {

constexpr std::array<std::string_view, 6> chemical_words{"limit", "floor", "conc", "channel", "from", "anisotropic"};

struct PictureOptions {
    const Token* file = nullptr;
    std::string channel;
    double low = 0.0;
    double high = 1.0;
};

struct ChemicalOptions {
    Bounds bounds;
    bool anisotropic = false;
    PictureOptions picture;
};

double parse_bound(Cursor& cursor, std::string_view what, double none) {
    if (cursor.take("none")) return none;
    return cursor.number(what);
}

void parse_scale(Cursor& cursor, PictureOptions& picture) {
    picture.low = cursor.number("the lowest value");
    cursor.expect("to");
    picture.high = cursor.number("the highest value");
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
            picture.channel = (cursor.peek().quoted ? cursor.next() : cursor.value("the channel")).text;
        else if (word == "from")
            parse_scale(cursor, picture);
        else
            chemical.anisotropic = true;
    }
    if (of_picture != nullptr && picture.file == nullptr) {
        cursor.fail(*of_picture, fmt::format("'{}' belongs to a picture; add 'conc \"PICTURE\"'", of_picture->text));
    }
}

void check_bounds(const Cursor& cursor, const Token& name, const Bounds& bounds) {
    if (bounds.floor <= bounds.limit) return;
    cursor.fail(name, fmt::format("the floor {} of '{}' is above its limit {}", bounds.floor, name.text, bounds.limit));
}

std::shared_ptr<const Field> scaled(Field field, double low, double high) {
    if (low != 0.0 || high != 1.0) {
        for (double& value : field.values) value = low + value * (high - low);
    }
    return std::make_shared<const Field>(std::move(field));
}

void load_picture(Script& script, const Cursor& cursor, const PictureOptions& picture, Chemical& chemical) {
    const std::string name(picture.file->text);
    if (script.pictures() == StartPictures::left_out) {
        script.experiment.inputs.push_back({name, {}});
        return;
    }
    try {
        const std::string path = script.resolve(name).string();
        const std::string bytes = read_file(path);
        chemical.initial = scaled(parse_field(bytes, picture.channel, path), picture.low, picture.high);
        script.experiment.inputs.push_back({name, sha256(bytes)});
    } catch (const Error& error) {
        cursor.fail(*picture.file, error.what());
    }
    script.shows_picture(cursor, *picture.file);
}

// Inside a phase: new bounds for a chemical that exists.
void parse_phase_bounds(Script& script, Cursor& cursor) {
    const Token& name = cursor.peek();
    Bounds& bounds = script.phase().bounds[script.chemical(cursor)];
    ChemicalOptions options{bounds, false, {}};
    parse_options(cursor, Words(chemical_words).first(2), options);
    check_bounds(cursor, name, options.bounds);
    bounds = options.bounds;
}

void parse_chemical(Script& script, Cursor& cursor) {
    if (script.in_phase()) return parse_phase_bounds(script, cursor);
    const Token& name = cursor.value("the chemical's name");
    check_name(cursor, name, "chemical");
    if (script.find_chemical(name.text)) cursor.fail(name, fmt::format("chemical '{}' is defined already", name.text));
    if (script.find_mapping(name.text))
        cursor.fail(name, fmt::format("'{}' is a mapping; choose another name", name.text));
    if (cursor.parameter(name) != nullptr)
        cursor.fail(name, fmt::format("'{}' is a parameter; choose another name", name.text));
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
    if (options.picture.file != nullptr) load_picture(script, cursor, options.picture, chemical);
    script.phase().bounds.push_back(chemical.bounds);
    chemicals.push_back(std::move(chemical));
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

void parse_stencil(Script& script, Cursor& cursor, const Token& word) {
    static constexpr std::array<std::string_view, 4> words{"moore", "nine-point", "five-point", "sims"};
    static constexpr std::array stencils{Stencil::moore, Stencil::nine_point, Stencil::five_point, Stencil::sims};
    script.experiment.stencil = stencils[cursor.choose(words)];
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

void parse_define(Script& script, Cursor& cursor) {
    static constexpr std::array<std::string_view, 6> words{"chemical", "time_step", "division_limit",
                                                           "domain",   "stencil",   "parameter"};
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
        default:
            return parse_parameter(script, cursor);
    }
}

}  // namespace pelage::language
