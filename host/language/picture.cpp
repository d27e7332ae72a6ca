// See picture.hpp.
#include "language/picture.hpp"

#include "core/error.hpp"
#include "core/finite.hpp"
#include "io/field.hpp"
#include "io/file_bytes.hpp"
#include "io/sha256.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <utility>

namespace pelage::language {

namespace {

std::shared_ptr<const Field> scaled(Field field, double low, double high) {
    if (low != 0.0 || high != 1.0) {
        for (double& value : field.values) value = low + value * (high - low);
    }
    return std::make_shared<const Field>(std::move(field));
}

// As numbers written in the experiment must.
void check_floats(const Field& field, const std::string& path) {
    for (std::size_t i = 0; i < field.values.size(); ++i) {
        if (is_finite(static_cast<float>(field.values[i]))) continue;
        throw Error(fmt::format("'{}' gives {} at row {}, column {}, which is beyond what a float can hold", path,
                                field.values[i], i / field.columns, i % field.columns));
    }
}

}  // namespace

void parse_channel(Cursor& cursor, PictureOptions& picture) {
    picture.channel = (cursor.peek().quoted ? cursor.next() : cursor.value("the channel")).text;
}

void parse_scale(Cursor& cursor, PictureOptions& picture) {
    picture.low = cursor.number("the lowest value");
    cursor.expect("to");
    picture.high = cursor.number("the highest value");
}

std::shared_ptr<const Field> load_picture(Script& script, const Cursor& cursor, const PictureOptions& picture,
                                          bool throughout) {
    const std::string name(picture.file->text);
    try {
        const std::string path = script.resolve(name).string();
        const std::string bytes = read_file(path);
        auto values = scaled(parse_field(bytes, picture.channel, path), picture.low, picture.high);
        check_floats(*values, path);
        script.experiment.inputs.push_back({name, sha256(bytes), throughout});
        return values;
    } catch (const Error& error) {
        cursor.fail(*picture.file, error.what());
    }
}

std::shared_ptr<const Field> load_start_picture(Script& script, const Cursor& cursor, const PictureOptions& picture) {
    if (script.pictures() == StartPictures::read) return load_picture(script, cursor, picture, false);
    script.experiment.inputs.push_back({std::string(picture.file->text), {}});
    return nullptr;
}

}  // namespace pelage::language
