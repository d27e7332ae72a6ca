// See array_quantities.hpp.
#include "verify/array_quantities.hpp"

#include "core/functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pelage::verify {

double QuantityWriter::middle_of_place(const std::string& what) const {
    const auto half = [](std::size_t count) { return std::floor(static_cast<double>(count) / 2); };
    const auto even = [](std::size_t count) { return count % 2 == 0 ? 1.0 : 0.0; };
    const Size& size = case_.size;
    const bool lattice = case_.realm == Realm::lattice;
    const bool grid = lattice || case_.realm == Realm::volume;  // one of whose places it is
    if (what == "X") return grid ? (lattice ? 0.5 : 0.0) + even(size.columns) : 0.0;
    if (what == "Y") return grid ? (lattice ? -3.25 : 0.0) + even(size.rows) : 0.0;
    if (what == "Z") return grid ? even(size.layers) : 0.0;
    if (what == "ROW") return half(size.rows);
    if (what == "COLUMN") return half(size.columns);
    if (what == "LAYER") return half(size.layers);
    if (what == "ROWS") return static_cast<double>(size.rows);
    if (what == "COLUMNS") return static_cast<double>(size.columns);
    if (what == "LAYERS") return static_cast<double>(size.layers);
    return 0.5;
}

double QuantityWriter::middle(const std::string& what) const {
    const auto start = static_cast<double>(std::stoull(case_.world()["start"]));
    if (what == "conc") return 1.5;
    if (what == "diff") return 0.125;
    if (what == "mapping") return 0.78125;
    if (what == "AGE") return 6;
    if (what == "BIRTH") return std::max(0.0, start - 6);
    if (what == "ITERATION") return start + 4;
    if (what == "TIME") return 0.05 * start + 0.2;
    if (what == "expression" || what == "around") return 0.75;
    if (what == "NEIGHBORS") {
        if (case_.realm == Realm::mesh) return 6;
        return case_.realm == Realm::cells ? 5 : 3;
    }
    return middle_of_place(what);
}

std::string QuantityWriter::text(const std::string& what) const {
    if (what == "conc") return nth_ % 2 == 0 ? "G conc" : "Q conc";
    if (what == "diff") return nth_ % 2 == 0 ? "W diff" : "Q diff";
    if (what == "mapping") return "M";
    if (what == "number") return "0.375";
    if (what == "expression") return expression();
    if (what == "around") return around();
    return what;
}

// One number or another, from 0.05 to 0.75, by a condition of every sign and joint.
std::string QuantityWriter::choice() const {
    const char* const signs[] = {"==", "!=", "<", "<=", ">", ">="};
    const char* const joints[] = {"G {} 1.5 and Q < 3.5", "G {} 1.5 or Q < 2.5", "not (G {} 1.5)"};
    const std::size_t turn = nth_ + case_.made->number;
    const std::string first = fmt::format(fmt::runtime(joints[turn / 2 % 3]), signs[turn % 6]);
    const char* const field = nth_ % 2 == 0 ? "slope" : "ramp";
    const std::string whole = nth_ % 2 == 0 ? fmt::format(" * if(AGE {} 6, 1, 0.75)", signs[turn % 6]) : "";
    return fmt::format("if({}, 0.5 * {}, -(G - 3) / 4) * if(G {} 2, 1, 0.5){}", first, field, signs[(turn + 2) % 6],
                       whole);
}

// Between 0.25 and 2: a function of what changes, and of what belongs to the place, and a choice. The rules with
// expressions take the functions in turn.
std::string QuantityWriter::expression() const {
    const auto before = case_.made->rules.begin();
    const auto of_world = std::count_if(before, before + static_cast<std::ptrdiff_t>(nth_),
                                        [&](const ArrayRow& rule) { return has_expression(case_.realm, rule); });
    const std::size_t turn = case_.made->expressions + static_cast<std::size_t>(of_world);
    const FunctionFacts& function = function_table()[turn % function_table().size()];
    const char* const arguments[] = {"Q", "(2 - ramp)", "(G + 1)"};
    std::string call = function.name + "(";
    for (std::size_t i = 0; i < function.parameters.size(); ++i)
        call += fmt::format("{}{}", i == 0 ? "" : ", ", arguments[(nth_ + i) % 3]);
    const char* const others[] = {"0.1 * cos(X + TIME)", "(Q - previous(Q))", "0.1 * sin(X * Y) * ramp"};
    const char* const other = others[nth_ % 3];
    return fmt::format("(min(1.25, max(0.25, {} + {})) + {})", call + ")", other, choice());  // NaN gives 0.25
}

// Between 0.25 and 1.25: what looks at neighbours, in each world another part of it or all at once.
std::string QuantityWriter::around() const {
    const bool gradients = case_.realm != Realm::mesh && case_.made->number % 3 != 2;
    std::string sum = "0.75";
    if (!gradients || case_.made->number % 3 != 1) sum += " + 0.05 * laplacian(Q)";
    if (gradients) sum += " + 0.125 * gradient_x(Q) - 0.25 * gradient_y(B)";
    if (gradients && case_.realm == Realm::volume) sum += " + 0.1875 * gradient_z(Q)";
    return fmt::format("(min(1.25, max(0.25, {})))", sum);
}

std::string_view QuantityWriter::partner(const std::string& what, bool alike) {
    struct Pair {
        std::string_view what, alike, other;
    };
    constexpr Pair pairs[] = {{"conc", "M", "AGE"},
                              {"diff", "M", "NEIGHBORS"},
                              {"mapping", "G conc", "AGE"},
                              {"X", "Y", "ITERATION"},
                              {"Y", "X", "NEIGHBORS"},
                              {"Z", "Y", "AGE"},
                              {"AGE", "BIRTH", "Q conc"},
                              {"BIRTH", "AGE", "X"},
                              {"ROW", "COLUMN", "Q conc"},
                              {"COLUMN", "ROW", "Y"},
                              {"LAYER", "ROW", "Q conc"},
                              {"ROWS", "COLUMNS", "G conc"},
                              {"COLUMNS", "ROWS", "M"},
                              {"LAYERS", "COLUMNS", "Z"},
                              {"number", "AGE", "G conc"},
                              {"NEIGHBORS", "AGE", "M"},
                              {"ITERATION", "BIRTH", "X"},
                              {"TIME", "X", "ITERATION"},
                              {"expression", "Q conc", "AGE"},
                              {"around", "Q conc", "AGE"}};
    for (const Pair& pair : pairs) {
        if (pair.what == what) return alike ? pair.alike : pair.other;
    }
    return alike ? "RANDOM" : "AGE";
}

}  // namespace pelage::verify
