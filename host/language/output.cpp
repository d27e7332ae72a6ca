// colormap, output, texture, zoom: what is drawn.
#include "language/expression.hpp"
#include "language/statements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace pelage::language {

namespace {

constexpr std::array<std::string_view, 7> maps{"heat", "gradient", "striped", "inferno", "viridis", "magma", "gray"};

// COLOUR at F, COLOUR at F ...
void parse_stops(Cursor part, std::vector<ColourStop>& stops) {
    do {
        const Token& colour = part.value("the colour");
        const Colour rgb = parse_colour(part, colour);
        part.expect("at");
        const Token& place = part.peek();
        const double at = part.number("the colour's place", fraction);
        if (!stops.empty() && at < stops.back().at) {
            part.fail(place, fmt::format("'{}' lies before the colour at {}; colours go from 0 to 1", place.text,
                                         stops.back().at));
        }
        stops.push_back({at, rgb});
        if (part.done()) return;
        if (!part.take(","))
            part.fail(part.peek(),
                      fmt::format("{} follows a colour without a comma between", Cursor::shown(part.peek())));
    } while (true);
}

void parse_slot(Script& script, Cursor& cursor) {
    static constexpr std::array<std::string_view, 2> words{"color", "rgb"};
    const std::size_t slot = cursor.integer("the slot", 0, script.slots.size() - 1);
    cursor.expect("use");
    if (cursor.choose(words) == 0) {
        script.slots[slot] = parse_colour(cursor, cursor.text("the colour"));
        return;
    }
    Colour rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
        static constexpr std::array<std::string_view, 3> parts{"red", "green", "blue"};
        rgb[i] = static_cast<std::uint8_t>(cursor.integer(parts[i], 0, 255));
    }
    script.slots[slot] = rgb;
}

}  // namespace

ColormapChoice parse_colormap_choice(Cursor& cursor, bool stops) {
    ColormapChoice choice;
    if (!stops || !cursor.peek().quoted) {
        const Token& token = cursor.peek();
        if (std::find(maps.begin(), maps.end(), token.text) == maps.end()) {
            cursor.unknown(token, maps, stops ? ", or \"COLOUR at 0..1, ...\"" : "");
        }
        choice.name = std::string(maps[cursor.choose(maps)]);
        return choice;
    }
    choice.name = "stops";
    const Token& first = cursor.peek();
    while (cursor.peek().quoted) parse_stops(cursor.inside(cursor.text("the colours")), choice.stops);
    if (choice.stops.size() < 2)
        cursor.fail(first, "one colour makes no map; give at least two, as in \"black at 0, white at 1\"");
    return choice;
}

void parse_colormap(Script& script, Cursor& cursor) {
    static constexpr std::array<std::string_view, 2> words{"select", "slot"};
    if (cursor.choose(words) == 0)
        script.selected = parse_colormap_choice(cursor, false);
    else
        parse_slot(script, cursor);
}

namespace {

constexpr std::array<std::string_view, 9> output_words{"range", "colormap", "height",      "normal", "as",
                                                       "slice", "maximum",  "transparent", "from"};

// slice x|y|z AT | maximum | transparent, the first word having been read.
Projection parse_projection(Cursor& cursor, std::string_view kind) {
    static constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
    if (kind == "maximum") return {Projection::Kind::maximum};
    if (kind == "transparent") return {Projection::Kind::transparent};
    Projection slice;
    slice.axis = static_cast<Axis>(cursor.choose(axes));
    slice.at = cursor.integer("the place of the slice", 0, largest_cell_count);
    return slice;
}

// X Y Z: the direction in which the viewer stands.
std::array<double, 3> parse_view(Cursor& cursor) {
    const Token& first = cursor.peek();
    std::array<double, 3> view{};
    view[0] = cursor.number("the viewer's x");
    view[1] = cursor.number("the viewer's y");
    view[2] = cursor.number("the viewer's z");
    const double length = std::hypot(view[0], view[1], view[2]);
    if (!(length > 0.0) || !std::isfinite(length))
        cursor.fail(first, "a viewer at (0, 0, 0) sees nothing; the three numbers are a direction from the middle");
    return view;
}

// A name for the picture's file.
std::string parse_file_word(Cursor& cursor) {
    const Token& token = cursor.value("the picture's name");
    const bool sound = token.text.size() <= 64 && std::ranges::all_of(token.text, [](char c) {
                           return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
                       });
    if (!sound)
        cursor.fail(token, fmt::format("'{}' cannot name a picture; names are up to 64 letters, digits, _ or -",
                                       shortened(token.text)));
    return std::string(token.text);
}

void parse_range(Cursor& cursor, Output& output) {
    if (cursor.take("each")) {
        output.own_range = true;
        return;
    }
    const double low = cursor.number("the lowest value (or the word 'each')");
    const Token& token = cursor.peek();
    const double high = cursor.number("the highest value");
    if (high <= low) cursor.fail(token, fmt::format("'{}' is not above the lowest value {}", token.text, low));
    output.range = {low, high};
}

// An option that the kind of picture has no use for.
void check_option(const Cursor& cursor, const Token& option, const Output& output) {
    const bool normal = output.drawing == Drawing::normal;
    if (option.text == "slice" || option.text == "maximum" || option.text == "from") return;
    if (option.text == "transparent" && (output.rgb() || output.drawing != Drawing::colours))
        cursor.fail(option, "a transparent picture shows one value through a colormap");
    if (output.rgb() && option.text != "as" && option.text != "transparent")
        cursor.fail(option,
                    fmt::format("a picture of red, green and blue has no {}; its expressions do all", option.text));
    if (option.text == "colormap" && output.drawing != Drawing::colours)
        cursor.fail(option, fmt::format("a {} map has no colormap", normal ? "normal" : "height"));
    if (option.text == "range" && normal) cursor.fail(option, "a normal map has no range; its slopes have a strength");
}

Expression parse_drawn(Script& script, Cursor& cursor, std::string_view what) {
    return parse_expression(script, cursor, Scope::picture, what);
}

// What is drawn: NAME | (EXPRESSION) | rgb (RED) (GREEN) (BLUE)
void parse_subject(Script& script, Cursor& cursor, Output& output) {
    if (is_expression(cursor.peek())) {
        output.expressions.push_back(parse_drawn(script, cursor, "what is drawn"));
        return;
    }
    Cursor ahead = cursor;  // a chemical may be named rgb
    if (!ahead.take("rgb") || !is_expression(ahead.peek())) {
        if (cursor.peek().text == "rgb" && !script.find_chemical("rgb"))
            cursor.fail(cursor.peek(), "rgb takes three expressions in parentheses: output rgb (RED) (GREEN) (BLUE)");
        output.chemical = script.chemical(cursor);
        return;
    }
    cursor.next();
    for (const std::string_view channel : {"red", "green", "blue"})
        output.expressions.push_back(parse_drawn(script, cursor, channel));
}

PendingOutput parse_output_options(Script& script, Cursor& cursor) {
    PendingOutput pending;
    Output& output = pending.output;
    parse_subject(script, cursor, output);
    std::vector<const Token*> given;
    Options options(output_words);
    while (true) {
        const Token& token = cursor.peek();
        const auto option = options.next(cursor);
        if (!option) break;
        const bool kind = *option == 2 || *option == 3;
        if (kind && output.drawing != Drawing::colours)
            cursor.fail(token, "a picture is a height map or a normal map; write another 'output' for the other");
        given.push_back(&token);
        if (*option == 0) parse_range(cursor, output);
        if (*option == 1) pending.colormap = parse_colormap_choice(cursor, true);
        if (*option == 2) output.drawing = Drawing::height;
        if (*option == 3) {
            output.drawing = Drawing::normal;
            output.strength = cursor.number("the height of one unit, in cells");
        }
        if (*option == 4) output.name = parse_file_word(cursor);
        if (*option < 5) continue;
        if (*option == 8) {
            script.needs_mesh(cursor, token);
            output.view = parse_view(cursor);
            continue;
        }
        if (output.projection)
            cursor.fail(token, "a picture shows a volume in one way; write another 'output' for the other");
        script.needs_volume(cursor, token);
        output.projection = parse_projection(cursor, token.text);
    }
    for (const Token* token : given) check_option(cursor, *token, output);
    return pending;
}

// Each picture's name is that of its chemical and kind; the first one of colours has none.
void check_new(const Script& script, const Cursor& cursor, const Token& name, const Output& output) {
    bool first = output.drawing == Drawing::colours;
    const std::string word = output_name(script.experiment, output);
    for (const PendingOutput& earlier : script.outputs) {
        if (earlier.output.drawing != output.drawing) continue;
        if (!first && output_name(script.experiment, earlier.output) == word) {
            const std::array<std::string_view, 3> kinds{"", ".height", ".normal"};
            cursor.fail(name,
                        fmt::format("the picture final.{}{}.png is already described; 'as NAME' gives it another name",
                                    word, kinds[static_cast<std::size_t>(output.drawing)]));
        }
        first = false;
    }
}

}  // namespace

void parse_output(Script& script, Cursor& cursor) {
    const Token& name = cursor.peek();
    PendingOutput pending = parse_output_options(script, cursor);
    check_new(script, cursor, name, pending.output);
    if (pending.output.drawing != Drawing::colours) script.draws_map(cursor, name);
    script.outputs.push_back(std::move(pending));
}

void parse_texture(Script& script, Cursor& cursor) {
    constexpr std::uint64_t most = 16384;
    script.needs_plane(cursor, cursor.peek());
    cursor.expect("size");
    const std::size_t width = cursor.integer("the texture's width", 1, most);
    script.experiment.texture = {width, cursor.integer("the texture's height", 1, most)};
}

void parse_zoom(Script& script, Cursor& cursor) {
    cursor.expect("level");
    script.experiment.zoom = cursor.number("the zoom level", positive);
}

}  // namespace pelage::language
