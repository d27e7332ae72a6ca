// colormap, output, texture, zoom: what is drawn.
#include "language/statements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

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

void parse_output(Script& script, Cursor& cursor) {
    static constexpr std::array<std::string_view, 2> words{"range", "colormap"};
    const Token& name = cursor.peek();
    PendingOutput pending;
    pending.output.chemical = script.chemical(cursor);
    for (std::size_t i = 1; i < script.outputs.size(); ++i) {
        if (script.outputs[i].output.chemical != pending.output.chemical) continue;
        cursor.fail(name, fmt::format("the picture final.{}.png is already described", name.text));
    }
    Options options(words);
    while (const auto option = options.next(cursor)) {
        if (*option == 1) {
            pending.colormap = parse_colormap_choice(cursor, true);
            continue;
        }
        const double low = cursor.number("the lowest value");
        const Token& token = cursor.peek();
        const double high = cursor.number("the highest value");
        if (high <= low) cursor.fail(token, fmt::format("'{}' is not above the lowest value {}", token.text, low));
        pending.output.range = {low, high};
    }
    script.outputs.push_back(std::move(pending));
}

void parse_texture(Script& script, Cursor& cursor) {
    constexpr std::uint64_t most = 16384;
    cursor.expect("size");
    const std::size_t width = cursor.integer("the texture's width", 1, most);
    script.experiment.texture = {width, cursor.integer("the texture's height", 1, most)};
}

void parse_zoom(Script& script, Cursor& cursor) {
    cursor.expect("level");
    script.experiment.zoom = cursor.number("the zoom level", positive);
}

}  // namespace pelage::language
