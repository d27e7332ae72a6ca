// See expression.hpp.
#include "core/expression.hpp"

#include "core/error.hpp"
#include "core/functions.hpp"

#include <fmt/format.h>

#include <cmath>

namespace pelage {

bool gives_truth(Operation operation) {
    return operation == Operation::compare || operation == Operation::conjunction ||
           operation == Operation::disjunction || operation == Operation::negation;
}

bool compares_exactly(const Expression& expression, const ExpressionNode& node) {
    const auto operand = [&](std::size_t place) -> const Operand* {
        const ExpressionNode& argument = expression.nodes[node.arguments[place]];
        return argument.operation == Operation::operand ? &argument.operand : nullptr;
    };
    const Operand* const left = operand(0);
    const Operand* const right = operand(1);
    return left != nullptr && right != nullptr && compared_exactly(*left, *right);
}

namespace {

// `call` takes as many as its function.
std::size_t arguments_of(const ExpressionNode& node) {
    switch (node.operation) {
        case Operation::operand:
            return 0;
        case Operation::negate:
        case Operation::negation:
            return 1;
        case Operation::choice:
            return 3;
        case Operation::call:
            return function_table().at(node.function).parameters.size();
        default:
            return 2;
    }
}

void check_node(const ExpressionNode& node, std::size_t place) {
    if (node.operation == Operation::call && node.function >= function_table().size())
        throw Error("an expression calls a function that does not exist");
    if (node.arguments.size() != arguments_of(node))
        throw Error(fmt::format("an expression's node takes {} arguments; found {}", arguments_of(node),
                                node.arguments.size()));
    for (const std::size_t argument : node.arguments) {
        if (argument >= place) throw Error("an expression's nodes are out of order");
    }
    if (node.operation != Operation::operand) return;
    if (node.operand.quantity == Quantity::expression) throw Error("an expression contains another one");
    if (!std::isfinite(node.operand.value)) throw Error("an expression holds a number that is not finite");
}

}  // namespace

void check_expression(const Expression& expression) {
    const std::size_t count = expression.nodes.size();
    if (count == 0 || count > largest_node_count)
        throw Error(fmt::format("an expression has {} parts; from 1 to {} are allowed", count, largest_node_count));
    for (std::size_t place = 0; place < count; ++place) check_node(expression.nodes[place], place);
}

}  // namespace pelage
