// See checks.hpp.
#include "core/checks.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pelage {

void Checks::fail(const std::string& what) const {
    const std::string where = line_ == 0 ? experiment_.source : experiment_.where(line_);
    throw Error(where + ": " + what);
}

void Checks::check_number(double value, const char* what) const {
    if (!std::isfinite(value)) fail(fmt::format("{} must be a number; found {}", what, value));
}

void Checks::check_deviation(double deviation) const {
    if (!(deviation >= 0.0) || !std::isfinite(deviation))
        fail(fmt::format("a deviation is a number not below 0; found {}", deviation));
}

void Checks::check_chemical(std::size_t chemical, const char* where) const {
    if (chemical >= experiment_.chemicals.size()) {
        fail(fmt::format("{} names chemical number {}; {} are defined", where, chemical, experiment_.chemicals.size()));
    }
}

void Checks::check_size(std::size_t columns, std::size_t rows) const {
    if (columns > largest_cell_count || rows > largest_cell_count / std::max<std::size_t>(columns, 1)) {
        fail(
            fmt::format("{} x {} cells are more than the {} that can be addressed", columns, rows, largest_cell_count));
    }
}

const Expression& Checks::checked_expression(std::size_t index, const char* where) const {
    if (index >= experiment_.expressions.size()) fail(fmt::format("{} reads an expression that is not defined", where));
    check_expression(experiment_.expressions[index]);
    return experiment_.expressions[index];
}

}  // namespace pelage
