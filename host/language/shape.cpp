// See shape.hpp.
#include "language/shape.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace pelage::language {

namespace {

bool letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

}  // namespace

std::vector<std::string> read_shape(const std::filesystem::path& path) {
    std::error_code error;
    const std::string name = path.string();
    if (!std::filesystem::is_regular_file(path, error)) throw Error(fmt::format("shape '{}' is not a file", name));
    if (std::filesystem::file_size(path, error) > largest_shape) {
        throw Error(fmt::format("shape '{}' is longer than the {} bytes allowed", name, largest_shape));
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) throw Error(fmt::format("shape '{}' cannot be opened", name));
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) {
        if (line.ends_with('\r')) line.pop_back();
        lines.push_back(line);
    }
    if (file.bad()) throw Error(fmt::format("shape '{}' cannot be read", name));
    if (count_letters(lines) == 0) throw Error(fmt::format("shape '{}' has no letter; each letter is a cell", name));
    return lines;
}

std::size_t count_letters(const std::vector<std::string>& lines) {
    std::size_t cells = 0;
    for (const std::string& line : lines) {
        cells += static_cast<std::size_t>(std::count_if(line.begin(), line.end(), letter));
    }
    return cells;
}

}  // namespace pelage::language
