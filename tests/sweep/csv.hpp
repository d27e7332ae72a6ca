// Tables of sweeps.
#pragma once

#include <catch2/catch.hpp>

#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace test {

// Without the last column of a sweep.csv, the seconds.
inline std::string without_times(const std::string& csv) {
    std::istringstream lines(csv);
    std::string all;
    for (std::string line; std::getline(lines, line);) all += line.substr(0, line.rfind(',')) + "\n";
    return all;
}

// A row: its fields by the names of their columns.
using Row = std::map<std::string, std::string>;

inline std::vector<Row> rows_of(const std::string& csv) {
    std::istringstream lines(csv);
    std::vector<Row> rows;
    std::vector<std::string> names;
    for (std::string line; std::getline(lines, line);) {
        std::vector<std::string> fields;
        std::istringstream parts(line + ",");
        for (std::string part; std::getline(parts, part, ',');) fields.push_back(part);
        if (names.empty()) {
            names = fields;
            continue;
        }
        REQUIRE(fields.size() == names.size());
        for (std::size_t i = 0; i < fields.size(); ++i) {
            if (i == 0) rows.emplace_back();
            rows.back()[names[i]] = fields[i];
        }
    }
    return rows;
}

}  // namespace test
