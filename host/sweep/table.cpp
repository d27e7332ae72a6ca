// See table.hpp.
#include "sweep/table.hpp"

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/file_bytes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <memory>
#include <utility>

namespace pelage::sweep {

namespace {

std::vector<std::string> names_of_numbers() {
    std::vector<std::string> names;
    for (const auto& [name, value] : stats::listed({})) names.push_back(name);
    return names;
}

std::size_t fields(const std::string& line) { return static_cast<std::size_t>(std::ranges::count(line, ',')) + 1; }

}  // namespace

Table::Table(std::filesystem::path path, std::vector<std::string> names)
    : path_(std::move(path)), names_(std::move(names)) {}

std::string Table::heading() const {
    std::vector<std::string> all{"tile"};
    all.insert(all.end(), names_.begin(), names_.end());
    for (const char* name : {"replicate", "seed", "iterations", "verdict", "settled", "of"}) all.emplace_back(name);
    const std::vector<std::string> numbers = names_of_numbers();
    all.insert(all.end(), numbers.begin(), numbers.end());
    return fmt::format("{},hash,seconds", fmt::join(all, ","));
}

std::string Table::beginning(std::size_t tile, const Point& point) const {
    std::string text = fmt::format("{}", tile);
    for (const Setting& one : point.settings) text += "," + one.value;
    return text + fmt::format(",{},", point.replicate);
}

void Table::take_up(const std::vector<Point>& points) {
    std::ifstream file(path_);
    std::string line;
    if (!std::getline(file, line) || line != heading()) return;
    while (std::getline(file, line)) {
        const std::size_t tile = static_cast<std::size_t>(std::strtoull(line.c_str(), nullptr, 10));
        const bool whole = fields(line) == fields(heading()) && !file.eof();
        if (whole && tile < points.size() && line.starts_with(beginning(tile, points[tile]))) rows_[tile] = line;
    }
}

std::string Table::verdict(std::size_t tile) const {
    const std::string& row = rows_.at(tile);
    std::size_t at = 0;
    for (std::size_t field = 0; field < names_.size() + 4; ++field) at = row.find(',', at) + 1;
    return row.substr(at, row.find(',', at) - at);
}

std::string Table::row(std::size_t tile, const Point& point, std::int64_t seed, const TileResult& result,
                       double seconds) const {
    std::string row =
        beginning(tile, point) + fmt::format("{},{},{},", seed, result.iterations, name_of(result.verdict));
    if (result.settled) row += std::to_string(*result.settled);
    row += "," + result.of;
    for (const auto& [name, value] : stats::listed(result.statistics.value_or(stats::Statistics{})))
        row += result.statistics ? fmt::format(",{:.6g}", value) : ",";
    return row + fmt::format(",{},{:.3f}", result.hash, seconds);
}

void Table::add(std::size_t tile, std::string row) {
    const bool anew = rows_.empty();
    rows_[tile] = row;
    if (anew) return sort();
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path_.c_str(), "ab"), &std::fclose);
    row += '\n';
    if (!file || std::fwrite(row.data(), 1, row.size(), file.get()) != row.size() || std::fflush(file.get()) != 0)
        throw Error(fmt::format("cannot write '{}': {}", path_.string(), system_reason(errno)));
}

void Table::sort() const {
    AtomicFile file(path_);
    file.write(heading() + "\n");
    for (const auto& [tile, row] : rows_) file.write(row + "\n");
    file.commit();
}

}  // namespace pelage::sweep
