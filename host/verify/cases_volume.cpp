// See cases.hpp: what a cell can do, in volumes.
#include "core/expression.hpp"
#include "verify/cases.hpp"
#include "verify/lab.hpp"

#include <fmt/format.h>

namespace pelage::verify {

namespace {

constexpr Stencil volume_stencils[] = {Stencil::seven_point, Stencil::twenty_seven_point};
constexpr Boundary volume_boundaries[] = {Boundary::no_flux, Boundary::wrap, Boundary::absorbing};

// One cell, lines along each axis, fewer layers than a wave has steps, odd ones, several strips.
std::vector<Size> volume_sizes() {
    return {{1, 1, 1}, {1, 1, 9}, {9, 1, 1}, {1, 5, 2}, {7, 5, 3}, {16, 3, 4}, {33, 2, 9}, {18, 17, 6}, {5, 23, 7}};
}

Operand volume_conc(std::size_t chemical) { return quantity(Quantity::concentration, chemical); }

// U knows no bounds, V is held between two, S only keeps within its own.
Experiment diffusing_volume(Lab lab) {
    const auto u = lab.chemical("U", {4, 1}, {0.5, 0}, unbounded);
    const auto v = lab.chemical("V", {4, 1}, {0.2, 0}, {0.5, 4.75});
    lab.chemical("S", {2, 1}, {0, 0}, {1.5, 2.5});
    lab.rule(react(model_named("turing"), {u, v}, {16, 12}));
    return lab.time_step(0.02).done();
}

// Every model of the table on chemicals of its own.
Experiment reacting_volume(Lab lab) {
    for (std::size_t model = 0; model < model_table().size(); ++model) {
        React react{Model{model}, {}, number(0.75), {}};
        for (const ModelSpecies& species : react.model.facts().species) {
            const Spread start{(species.low + species.high) / 2, (species.high - species.low) / 2};
            const std::string name = react.model.facts().word + " " + species.name;
            react.species.push_back(lab.chemical(name, start, {0.07, 0}, unbounded));
        }
        for (const double parameter : sensible(react.model.facts(), 0)) react.parameters.push_back(number(parameter));
        lab.rule(react);
    }
    return lab.time_step(0.01).done();
}

// Rates that differ between cells, some of them 0; rates that rules change; a phase that makes them equal.
Experiment uneven_volume(Lab lab) {
    lab.chemical("U", {4, 2}, {0.3, 0.25}, unbounded);
    lab.chemical("V", {2, 1}, {0.2, 0}, unbounded);
    const auto w = lab.chemical("W", {3, 1}, {0.15, 0.1}, {0.5, 4.5});
    lab.rule(change_rate(w, number(-0.001), 0.01), Probability{number(0.5)});
    lab.rule(Set{Target::rate, w, number(0.125)}, compare(quantity(Quantity::layer), Comparison::equal, number(1)));
    lab.phase(20).rates[0] = 0.25;
    return lab.time_step(0.25).done();
}

void uneven_volume_touch(Snapshot& state) {
    for (std::size_t cell = 0; cell < state.cells(); cell += 5) state.diff[0][cell] = 0.0;
}

// (first + second) * third
Expression product_of(const Operand& first, const Operand& second, const Operand& third) {
    Expression made;
    made.text = "(a + b) * c";
    const auto leaf = [&](const Operand& operand) {
        ExpressionNode node;
        node.operand = operand;
        made.nodes.push_back(node);
        return made.nodes.size() - 1;
    };
    const auto join = [&](Operation operation, std::size_t a, std::size_t b) {
        ExpressionNode node;
        node.operation = operation;
        node.arguments = {a, b};
        made.nodes.push_back(node);
        return made.nodes.size() - 1;
    };
    const std::size_t sum = join(Operation::add, leaf(first), leaf(second));
    join(Operation::multiply, sum, leaf(third));
    return made;
}

// Every quantity once as an operand and once in a condition; draws, sets, maps, expressions, chains.
Experiment ruled_volume(Lab lab) {
    const Quantity all[] = {Quantity::neighbours, Quantity::age,  Quantity::birth,   Quantity::x,
                            Quantity::y,          Quantity::z,    Quantity::row,     Quantity::column,
                            Quantity::layer,      Quantity::rows, Quantity::columns, Quantity::layers,
                            Quantity::iteration,  Quantity::time, Quantity::random};
    const auto fed = lab.chemical("F", {10, 4}, {0.05, 0}, {0, 20});
    for (const Quantity what : all) {
        const auto place = lab.chemical(fmt::format("Q{}", static_cast<int>(what)), {1, 1}, {0, 0}, unbounded);
        lab.rule(change(place, quantity(what)));
        lab.rule(change(place, number(0.25)), compare(quantity(what), Comparison::less, volume_conc(fed)));
    }
    const auto slope = lab.chemical("S", {1, 1}, {0.1, 0}, unbounded);
    for (const Quantity what : {Quantity::gradient_x, Quantity::gradient_y, Quantity::gradient_z, Quantity::laplacian})
        lab.rule(change(slope, quantity(what, fed)), compare(quantity(what, slope), Comparison::less, number(0.5)));
    const auto mapping = lab.mapping("M");
    lab.rule(Map{volume_conc(fed), 6, 14, mapping, -1, 1});
    // Seldom enough that waves of several steps lie between.
    lab.rule(change(fed, quantity(Quantity::mapping, mapping), 0.125), Probability{number(0.5)}).every = 7;
    lab.rule(And{}, compare(quantity(Quantity::layer), Comparison::greater_equal, quantity(Quantity::row)));
    lab.rule(Set{Target::concentration, fed, quantity(Quantity::random)}, Probability{number(0.05)});
    const std::size_t product = lab.expression(
        product_of(quantity(Quantity::layer), quantity(Quantity::gradient_z, fed), quantity(Quantity::laplacian, fed)));
    const Operand computed{Quantity::expression, 0.0, product};
    lab.rule(Formula{{{fed, computed}, {slope, quantity(Quantity::z)}}}).from = 3;
    return lab.done();
}

// Rules act in columns, rows and layers whose number has more than 16 bits, and where there are more than those.
Experiment far_lines_of_volume(Lab lab) {
    const auto told = lab.chemical("Q", {10, 4}, {0.05, 0}, unbounded);
    double amount = 1;
    for (const Quantity what :
         {Quantity::column, Quantity::row, Quantity::layer, Quantity::columns, Quantity::rows, Quantity::layers}) {
        lab.rule(change(told, number(amount)), compare(quantity(what), Comparison::greater, number(65'536)));
        amount /= 2;
    }
    return lab.done();
}

Experiment neural_volume(Lab lab) {
    Neural neural;
    neural.network = drawn_network(4, 6, 7);
    for (std::size_t i = 0; i < 4; ++i)
        neural.species.push_back(lab.chemical(fmt::format("h{}", i), {0.0, 0.5}, {0.0, 0.0}, unbounded));
    neural.diffusion = number(0.5);
    lab.rule(neural);
    return lab.time_step(0.125).done();
}

}  // namespace

std::vector<Case> volume_cases() {
    std::vector<Case> cases;
    const auto add = [&](const std::string& name, auto make, Boundary boundary, Stencil stencil, bool divides,
                         std::function<void(Snapshot&)> touch = {}) {
        const auto experiment = [=](Size size) {
            return make(Lab::volume(size.columns, size.rows, size.layers, boundary, stencil));
        };
        cases.push_back(
            {fmt::format("volume/{}", name), experiment, volume_sizes(), 40, std::move(touch), false, divides});
    };
    for (const Stencil stencil : volume_stencils) {
        for (const Boundary boundary : volume_boundaries)
            add(fmt::format("diffusion/{}/{}", word(stencil), word(boundary)), diffusing_volume, boundary, stencil,
                false);
    }
    add("reaction/wrap", reacting_volume, Boundary::wrap, Stencil::seven_point, true);
    add("rates/no-flux", uneven_volume, Boundary::no_flux, Stencil::seven_point, true, uneven_volume_touch);
    add("rates/wrap", uneven_volume, Boundary::wrap, Stencil::twenty_seven_point, true, uneven_volume_touch);
    add("rates/absorbing", uneven_volume, Boundary::absorbing, Stencil::seven_point, true, uneven_volume_touch);
    add("rules/no-flux", ruled_volume, Boundary::no_flux, Stencil::seven_point, true);
    add("rules/wrap", ruled_volume, Boundary::wrap, Stencil::twenty_seven_point, true);
    add("rules/absorbing", ruled_volume, Boundary::absorbing, Stencil::seven_point, true);
    add("neural/wrap", neural_volume, Boundary::wrap, Stencil::seven_point, false);
    add("neural/absorbing", neural_volume, Boundary::absorbing, Stencil::twenty_seven_point, false);
    add("far-lines", far_lines_of_volume, Boundary::wrap, Stencil::seven_point, false);
    cases.back().sizes = {{65'539, 1, 2}, {2, 65'539, 1}, {1, 2, 65'539}};
    cases.back().iterations = 6;
    return cases;
}

}  // namespace pelage::verify
