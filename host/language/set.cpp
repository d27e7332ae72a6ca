// set cell ID ... | set cells ID to ID ... | set cells where (EXPRESSION) ...
#include "language/statements.hpp"

#include <fmt/format.h>

#include <array>

namespace pelage::language {

namespace {

std::size_t parse_cell(const Script& script, Cursor& cursor, std::string_view what) {
    if (script.cells() == 0) cursor.fail(cursor.peek(), "no cells are created before this line");
    return cursor.integer(what, 0, script.cells() - 1);
}

// Of the cells created until now those where an expression is true.
SetCells parse_where(Script& script, Cursor& cursor) {
    if (script.cells() == 0) cursor.fail(cursor.peek(), "no cells are created before this line");
    const Token& token = cursor.peek();
    Expression expression = parse_expression(script, cursor, Scope::start, "what holds for the cells");
    SetCells cells;
    cells.where = keep_expression(script, cursor, token, std::move(expression));
    return cells;
}

// NAME conc VALUE [dev VALUE] [diff VALUE [dev VALUE]], one or both
void set_chemical(Script& script, Cursor& cursor, SetCells cells) {
    static constexpr std::array<std::string_view, 2> words{"conc", "diff"};
    const std::size_t chemical = script.chemical(cursor);
    Options options(words);
    while (const auto option = options.next_if(cursor)) {
        const Token& value = cursor.peek();
        if (*option == 0)
            cells.what = SetConcentration{chemical, parse_start_value(script, cursor, "the concentration")};
        else
            cells.what = SetRate{chemical, parse_start_value(script, cursor, "the diffusion rate")};
        script.start(cells, cursor.place(value));
    }
    if (!options.given(0) && !options.given(1)) cursor.unknown(cursor.peek(), words);
}

}  // namespace

void parse_set(Script& script, Cursor& cursor) {
    static constexpr std::array<std::string_view, 2> ranges{"cell", "cells"};
    static constexpr std::array<std::string_view, 3> words{"chemical", "polarity", "fixed"};
    const Token& range = cursor.peek();
    const bool several = cursor.choose(ranges) == 1;
    script.outside_phases(cursor, range, fmt::format("set {}", range.text));
    SetCells cells;
    const bool where = several && cursor.take("where");
    if (where) {
        cells = parse_where(script, cursor);
    } else {
        cells.first = parse_cell(script, cursor, several ? "the first cell, or the word 'where'," : "the cell");
        cells.last = cells.first;
    }
    if (several && !where) {
        cursor.expect("to");
        const Token& last = cursor.peek();
        cells.last = parse_cell(script, cursor, "the last cell");
        if (cells.last < cells.first)
            cursor.fail(last, fmt::format("the last cell {} comes before the first, {}", cells.last, cells.first));
    }
    if (cursor.done()) cursor.unknown(cursor.peek(), words);
    Options options(words);
    while (true) {
        const Token& word = cursor.peek();
        const auto option = options.next(cursor);
        if (!option) break;
        if (*option == 1) script.needs_plane(cursor, word);
        if (*option == 0) {
            do set_chemical(script, cursor, cells);
            while (cursor.take("chemical"));
            continue;
        }
        if (*option == 1)
            cells.what = SetPolarity{parse_degrees(cursor)};
        else
            cells.what = SetFixed{};
        script.start(cells, cursor.place(range));
    }
}

}  // namespace pelage::language
