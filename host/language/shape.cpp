// See shape.hpp.
#include "language/shape.hpp"

#include "core/error.hpp"
#include "io/file_bytes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace pelage::language {

namespace {

bool letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

}  // namespace

std::string read_shape_text(const std::filesystem::path& path) {
    std::error_code error;
    const std::string name = path.string();
    if (!std::filesystem::is_regular_file(path, error)) throw Error(fmt::format("shape '{}' is not a file", name));
    if (std::filesystem::file_size(path, error) > largest_shape) {
        throw Error(fmt::format("shape '{}' is longer than the {} bytes allowed", name, largest_shape));
    }
    return read_file(path);
}

std::vector<std::string> shape_lines(const std::string& text, const std::filesystem::path& path) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        if (line.ends_with('\r')) line.pop_back();
        lines.push_back(line);
    }
    if (count_letters(lines) == 0)
        throw Error(fmt::format("shape '{}' has no letter; each letter is a cell", path.string()));
    return lines;
}

std::vector<std::string> read_shape(const std::filesystem::path& path) {
    return shape_lines(read_shape_text(path), path);
}

std::size_t count_letters(const std::vector<std::string>& lines) {
    std::size_t cells = 0;
    for (const std::string& line : lines) {
        cells += static_cast<std::size_t>(std::count_if(line.begin(), line.end(), letter));
    }
    return cells;
}

}  // namespace pelage::language
