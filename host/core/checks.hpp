// What the parts of validate() share: the error with its place, and checks of single values.
#pragma once

#include "core/experiment.hpp"

#include <cstddef>
#include <string>

namespace pelage {

class Checks {
public:
    explicit Checks(const Experiment& experiment) : experiment_(experiment) {}

protected:
    [[noreturn]] void fail(const std::string& what) const;  // throws Error, with the line where one is known

    void check_number(double value, const char* what) const;  // finite
    void check_deviation(double) const;
    void check_chemical(std::size_t chemical, const char* where) const;
    void check_size(std::size_t columns, std::size_t rows) const;
    // The expression at that place of the experiment, when there is one and its nodes are a tree.
    const Expression& checked_expression(std::size_t index, const char* where) const;

    const Experiment& experiment_;
    std::size_t line_ = 0;  // of the rule that is being checked
};

// The prepattern and the domain; the phases must have been checked.
void validate_start(const Experiment&);

}  // namespace pelage
