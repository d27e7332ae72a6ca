// See design.hpp.
#include "sweep/design.hpp"

#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/philox.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <numeric>
#include <optional>
#include <set>

namespace pelage::sweep {

bool Point::operator==(const Point& other) const {
    const auto same = [](const Setting& a, const Setting& b) { return a.name == b.name && a.value == b.value; };
    return replicate == other.replicate && std::ranges::equal(settings, other.settings, same);
}

namespace {

std::vector<std::string> parts_of(const std::string& text, char mark) {
    std::vector<std::string> parts{""};
    for (const char c : text) {
        if (c == mark)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    for (std::string& part : parts) {
        const std::size_t first = std::min(part.find_first_not_of(" \t\r"), part.size());
        part = part.substr(first, part.find_last_not_of(" \t\r") + 1 - first);
    }
    return parts;
}

// The fields of a line of a table; one that begins with a quote goes to the next, and two quotes in it are one. Throws
// Error where one is not closed.
std::vector<std::string> fields_of(const std::string& line, const std::string& where) {
    std::vector<std::string> fields;
    std::string bare;  // with commas in quotes replaced, so that parts_of() sees the others alone
    std::vector<std::string> quoted;
    constexpr char stand_in = '\x01';
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool begins = line[i] == '"' && bare.find_last_not_of(" \t") + 1 == bare.rfind(',') + 1;
        if (!begins) {
            bare += line[i];
            continue;
        }
        std::string text;
        for (++i;; ++i) {
            if (i >= line.size()) throw Error(fmt::format("{}: a quote is not closed", where));
            if (line[i] == '"' && (i + 1 == line.size() || line[i + 1] != '"')) break;
            i += line[i] == '"' ? 1 : 0;
            text += line[i];
        }
        quoted.push_back(text);
        bare += stand_in;
    }
    std::size_t next = 0;
    for (const std::string& part : parts_of(bare, ',')) {
        const bool whole = part.size() == 1 && part[0] == stand_in && next < quoted.size();
        fields.push_back(whole ? quoted[next] : part);
        next += static_cast<std::size_t>(std::ranges::count(part, stand_in));
    }
    return fields;
}

std::optional<double> number(const std::string& text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

[[noreturn]] void refuse(const std::string& word, const std::string& why) {
    constexpr std::size_t most = 60;
    throw Error(fmt::format("--vary '{}{}': {}", word.substr(0, most), word.size() > most ? "..." : "", why));
}

struct Word {
    std::string name;
    std::string values;
};

Word split(const std::string& word) {
    const std::size_t sign = word.find('=');
    if (sign == std::string::npos || sign == 0 || sign + 1 == word.size())
        refuse(word, "values are given as in NAME=0.01:0.08:15, NAME=log:0.1:10:5 or NAME=4,5,6");
    return {word.substr(0, sign), word.substr(sign + 1)};
}

struct Ends {
    double low = 0.0, high = 0.0;
    bool logarithmic = false;
};

// LOW:HIGH, the first two of the parts behind an optional "log".
Ends ends_of(const std::string& word, std::vector<std::string>& parts, std::size_t wanted, const char* form) {
    Ends ends;
    ends.logarithmic = parts.front() == "log";
    if (ends.logarithmic) parts.erase(parts.begin());
    const auto low = number(parts.front());
    const auto high = number(parts.size() > 1 ? parts[1] : "");
    if (parts.size() != wanted || !low || !high) refuse(word, fmt::format("a range is written {}", form));
    ends.low = low.value_or(0.0);
    ends.high = high.value_or(0.0);
    if (ends.low > ends.high) refuse(word, fmt::format("{} is above {}", parts[0], parts[1]));
    if (ends.logarithmic && ends.low <= 0.0) refuse(word, "a logarithmic range begins above 0");
    return ends;
}

double between(double low, double high, bool logarithmic, double share) {
    if (share >= 1.0) return high;
    return logarithmic ? low * std::pow(high / low, share) : low + share * (high - low);
}

// Twelve digits: what one would have written.
std::string written(double value) { return fmt::format("{:.12g}", value); }

}  // namespace

Axis parse_axis(const std::string& word) {
    const auto [name, text] = split(word);
    Axis axis{name, {}};
    std::vector<std::string> parts = parts_of(text, ':');
    if (parts.size() == 1) {
        axis.values = parts_of(text, ',');
        for (const std::string& value : axis.values) {
            if (!number(value)) refuse(word, fmt::format("'{}' is not a number", value));
        }
        return axis;
    }
    const Ends ends = ends_of(word, parts, 3, "NAME=LOW:HIGH:COUNT or NAME=log:LOW:HIGH:COUNT");
    const auto count = number(parts[2]);
    if (!count || *count < 1 || *count != std::floor(*count) || *count > static_cast<double>(largest_tile_count))
        refuse(word, fmt::format("'{}' is no count; it is a whole number from 1 to {}", parts[2], largest_tile_count));
    const auto steps = static_cast<std::size_t>(*count);
    for (std::size_t i = 0; i < steps; ++i) {
        const double share = steps == 1 ? 0.0 : static_cast<double>(i) / static_cast<double>(steps - 1);
        axis.values.push_back(written(between(ends.low, ends.high, ends.logarithmic, share)));
    }
    return axis;
}

Range parse_range(const std::string& word) {
    const auto [name, text] = split(word);
    std::vector<std::string> parts = parts_of(text, ':');
    const Ends ends = ends_of(word, parts, 2, "NAME=LOW:HIGH or NAME=log:LOW:HIGH where samples are drawn");
    return {name, ends.low, ends.high, ends.logarithmic};
}

std::vector<Point> grid(const std::vector<Axis>& axes, std::size_t replicates) {
    std::set<std::string> names;
    std::size_t count = replicates;
    for (const Axis& axis : axes) {
        if (!names.insert(axis.name).second) throw Error(fmt::format("--vary {} is given twice", axis.name));
        if (count > largest_tile_count / axis.values.size())
            throw Error(fmt::format("the sweep has more than {} tiles", largest_tile_count));
        count *= axis.values.size();
    }
    std::vector<Point> points;
    for (std::size_t place = 0; place < count; ++place) {
        Point point;
        std::size_t left = place;
        for (const Axis& axis : axes) {
            point.settings.push_back({axis.name, axis.values[left % axis.values.size()]});
            left /= axis.values.size();
        }
        point.replicate = left;
        points.push_back(std::move(point));
    }
    return points;
}

std::vector<Point> samples(const std::vector<Range>& ranges, std::size_t count, bool latin, std::uint64_t seed) {
    std::vector<Point> points(count);
    for (std::size_t axis = 0; axis < ranges.size(); ++axis) {
        const auto draw = [&](std::size_t n, std::size_t which) {
            const auto words = counted_words(n, axis, 0, purpose::parameter, static_cast<std::int64_t>(seed));
            return unit_uniform<double>(words[which]);
        };
        std::vector<std::size_t> part(count);
        std::iota(part.begin(), part.end(), std::size_t{0});
        for (std::size_t n = count; latin && n > 1; --n)  // Fisher and Yates
            std::swap(part[n - 1], part[static_cast<std::size_t>(draw(n - 1, 1) * static_cast<double>(n))]);
        for (std::size_t n = 0; n < count; ++n) {
            const double within = draw(n, 0);
            const double share = latin ? (static_cast<double>(part[n]) + within) / static_cast<double>(count) : within;
            const Range& range = ranges[axis];
            points[n].settings.push_back(
                {range.name, fmt::format("{:.6g}", between(range.low, range.high, range.logarithmic, share))});
        }
    }
    return points;
}

std::vector<Point> read_points(const std::filesystem::path& path) {
    if (std::filesystem::is_directory(path))
        throw Error(fmt::format("{}: is a folder; a table of parameters is a text file", path.string()));
    std::ifstream file(path);
    if (!file) throw Error(fmt::format("{}: cannot be opened; it must be a table of parameters", path.string()));
    std::vector<std::string> names;
    std::vector<Point> points;
    std::size_t number_of_line = 0;
    for (std::string line; std::getline(file, line);) {
        if (++number_of_line == 1 && line.starts_with("\xef\xbb\xbf")) line.erase(0, 3);  // byte order mark of UTF-8
        const std::string where = fmt::format("{}:{}", path.string(), number_of_line);
        const std::vector<std::string> parts = fields_of(line, where);
        if (parts.size() == 1 && parts.front().empty()) continue;
        if (names.empty()) {
            names = parts;
            if (std::set<std::string>(names.begin(), names.end()).size() != names.size())
                throw Error(fmt::format("{}: a name stands there twice", where));
            continue;
        }
        if (parts.size() != names.size())
            throw Error(
                fmt::format("{}: {}; the first line names {}", where, counted(parts.size(), "field"), names.size()));
        Point point;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (!number(parts[i])) throw Error(fmt::format("{}: '{}' is not a number", where, parts[i]));
            point.settings.push_back({names[i], parts[i]});
        }
        points.push_back(std::move(point));
        if (points.size() > largest_tile_count)
            throw Error(fmt::format("{}: more than {} points", where, largest_tile_count));
    }
    if (points.empty()) throw Error(fmt::format("{}: holds no point below its line of names", path.string()));
    return points;
}

}  // namespace pelage::sweep
