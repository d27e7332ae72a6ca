// define parameter NAME VALUE [from LOW to HIGH] ["MEANING"], and what is set from outside.
#include "language/statements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace pelage::language {

namespace {

// Words that stand where a number may stand, too.
constexpr std::array<std::string_view, 4> beside_numbers{"none", "each", "packed", "then"};

void check_new(const Script& script, const Cursor& cursor, const Token& name) {
    check_name(script, cursor, name, "parameter");
    if (std::ranges::find(beside_numbers, name.text) != beside_numbers.end())
        cursor.fail(name, fmt::format("'{}' cannot name a parameter; it is a word beside numbers", name.text));
    if (script.experiment.parameters.size() == largest_parameter_count)
        cursor.fail(name, fmt::format("one parameter too many; at most {} are allowed", largest_parameter_count));
}

std::string range_of(const Parameter& parameter) {
    return fmt::format("from {:g} to {:g}", parameter.low, parameter.high);
}

bool allowed(const Parameter& parameter, double value) { return parameter.low <= value && value <= parameter.high; }

void parse_range(Cursor& cursor, Parameter& parameter, const Token& value) {
    const Token& first = cursor.peek();
    parameter.low = cursor.number("the lowest value");
    cursor.expect("to");
    parameter.high = cursor.number("the highest value");
    if (parameter.low > parameter.high)
        cursor.fail(first,
                    fmt::format("the lowest value {:g} is above the highest, {:g}", parameter.low, parameter.high));
    if (!allowed(parameter, parameter.usual))
        cursor.fail(value, fmt::format("{} is not {}", Cursor::shown(value), range_of(parameter)));
}

double value_of(const Parameter& parameter, const Setting& setting) {
    const std::optional<double> value = to_number(setting.value);
    if (!value)
        throw Error(fmt::format("--set {}={}: the value must be a number", setting.name, shortened(setting.value)));
    if (!allowed(parameter, *value)) {
        throw Error(fmt::format("--set {}={}: parameter '{}' must be a number {}", setting.name,
                                shortened(setting.value), setting.name, range_of(parameter)));
    }
    return *value;
}

}  // namespace

void parse_parameter(Script& script, Cursor& cursor) {
    Parameter parameter;
    const Token& name = cursor.value("the parameter's name");
    check_new(script, cursor, name);
    const Token& value = cursor.peek();
    parameter.name = std::string(name.text);
    parameter.line = cursor.line();
    parameter.usual = cursor.number("the parameter");
    if (cursor.take("from")) parse_range(cursor, parameter, value);
    if (!cursor.done()) parameter.meaning = std::string(cursor.text("what the parameter means").text);
    parameter.value = parameter.usual;
    if (const Setting* setting = script.setting(parameter.name)) {
        parameter.value = value_of(parameter, *setting);
        script.replaces(value, setting->value);
    }
    script.experiment.parameters.push_back(std::move(parameter));
}

}  // namespace pelage::language
