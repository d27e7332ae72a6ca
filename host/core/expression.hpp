// A formula over what rules read: a tree, kept as a list in which every node comes after those that it takes.
//
// Values are numbers in the precision of the run; each operation is rounded on its own, in the order written. A truth
// counts as 1 or 0 where a number is wanted, a number as true where it is not 0.
#pragma once

#include "core/operand.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace pelage {

inline constexpr std::size_t largest_node_count = 1000;       // of one expression
inline constexpr std::size_t largest_expression_count = 256;  // of an experiment

enum class Operation {
    operand,      // ExpressionNode::operand; no arguments
    negate,       // -a
    add,          // a + b
    subtract,     // a - b
    multiply,     // a * b
    divide,       // a / b
    compare,      // a COMPARISON b: exactly where compared_exactly() says so
    conjunction,  // a and b
    disjunction,  // a or b
    negation,     // not a
    choice,       // a ? b : c; both are computed
    call          // ExpressionNode::function of the arguments
};

struct ExpressionNode {
    Operation operation = Operation::operand;
    Operand operand;  // its quantity is not `expression`
    Comparison comparison = Comparison::equal;
    std::size_t function = 0;            // place in function_table()
    std::vector<std::size_t> arguments;  // places of earlier nodes

    bool operator==(const ExpressionNode&) const = default;
};

struct Expression {
    std::string text;  // as written, with its parentheses
    std::vector<ExpressionNode> nodes;
    std::size_t line = 0;  // of the experiment's file; 0 when built by hand

    bool operator==(const Expression&) const = default;
};

// Whether a node gives a truth, not a number.
bool gives_truth(Operation);

// Calls visit(operand) for every operand, in the order written.
template <class Visit>
void each_operand(const Expression& expression, Visit&& visit) {
    for (const ExpressionNode& node : expression.nodes) {
        if (node.operation == Operation::operand) visit(node.operand);
    }
}

// Whether a `compare` node compares two operands exactly.
bool compares_exactly(const Expression&, const ExpressionNode&);

// Throws Error when the nodes are no tree: none at all, too many, an argument that does not come before, a function
// that does not exist, a wrong number of arguments.
void check_expression(const Expression&);

}  // namespace pelage
