// define field NAME (EXPRESSION) | define field NAME "PICTURE" [channel NAME] [from LOW to HIGH] [fit WORD]
// define field NAME blobs INT sigma FLOAT
#include "language/expression.hpp"
#include "language/picture.hpp"
#include "language/statements.hpp"

#include <fmt/format.h>

#include <array>

namespace pelage::language {

namespace {

Fit parse_fit(Cursor& cursor) {
    static constexpr std::array<std::string_view, 3> words{"stretch", "tile", "centre"};
    static constexpr std::array fits{Fit::stretch, Fit::tile, Fit::centre};
    return fits[cursor.choose(words)];
}

PictureField parse_picture(Script& script, Cursor& cursor) {
    static constexpr std::array<std::string_view, 3> words{"channel", "from", "fit"};
    PictureOptions picture;
    picture.file = &cursor.text("the picture's name");
    PictureField field;
    Options options(words);
    while (const auto option = options.next(cursor)) {
        if (*option == 0) parse_channel(cursor, picture);
        if (*option == 1) parse_scale(cursor, picture);
        if (*option == 2) field.fit = parse_fit(cursor);
    }
    field.picture = load_picture(script, cursor, picture, true);
    field.beside = picture.low;
    script.needs_lattice(cursor, *picture.file);
    script.needs_plane(cursor, *picture.file);
    return field;
}

BlobField parse_blobs(Script& script, Cursor& cursor) {
    constexpr Range of_sigma{0.0, 10'000.0, true};
    const Token& word = cursor.next();
    BlobField blobs;
    blobs.count = cursor.integer("the number of blobs", 0, largest_blob_count);
    cursor.expect("sigma");
    blobs.sigma = cursor.number("sigma, in cells or in units of the mesh", of_sigma);
    script.needs_places(cursor, word);
    return blobs;
}

}  // namespace

void parse_place_field(Script& script, Cursor& cursor) {
    const Token& name = cursor.value("the field's name");
    check_name(script, cursor, name, "field");
    auto& fields = script.experiment.fields;
    if (fields.size() == largest_field_count)
        cursor.fail(name, fmt::format("one field too many; at most {} are allowed", largest_field_count));
    PlaceField field{std::string(name.text), cursor.line(), ComputedField{}};
    if (cursor.peek().quoted) {
        field.source = parse_picture(script, cursor);
    } else if (cursor.peek().text == "blobs") {
        field.source = parse_blobs(script, cursor);
    } else {
        field.source = ComputedField{parse_expression(script, cursor, Scope::field, "the field")};
    }
    fields.push_back(std::move(field));
}

}  // namespace pelage::language
