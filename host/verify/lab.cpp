// See lab.hpp.
#include "verify/lab.hpp"

#include <cmath>

namespace pelage::verify {

namespace {

void start(Experiment& experiment) {
    Phase first;
    first.time_step = 0.05;
    experiment.phases.push_back(first);
    experiment.outputs.emplace_back();
}

}  // namespace

Lab Lab::matrix(std::size_t columns, std::size_t rows, Boundary boundary, Stencil stencil) {
    Lab lab;
    start(lab.experiment_);
    lab.experiment_.stencil = stencil;
    // All different, so that no two directions can be mistaken for each other.
    lab.experiment_.weights = {0.0625, 0.5, 0.125, 0.25, -2.15625, 0.375, 0.1875, 0.625, 0.03125};
    lab.create_ = CreateMatrix{columns, rows, boundary, 0.5, -3.25};
    return lab;
}

Lab Lab::wide(std::size_t columns, std::size_t rows, Boundary boundary) {
    Lab lab = matrix(columns, rows, boundary, Stencil::own);
    StencilWeights& weights = lab.experiment_.weights;
    weights.assign(25, 0.0);
    double sum = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] = static_cast<double>(1 + i * 7 % 29) / 128;
    weights[12] -= sum;
    return lab;
}

Lab Lab::volume(std::size_t columns, std::size_t rows, std::size_t layers, Boundary boundary, Stencil stencil) {
    Lab lab;
    start(lab.experiment_);
    lab.experiment_.stencil = stencil;
    lab.create_ = CreateVolume{columns, rows, layers, boundary};
    return lab;
}

Lab Lab::grid(std::size_t columns, std::size_t rows, bool wrap) {
    Lab lab;
    start(lab.experiment_);
    CreateGrid create;
    create.columns = columns;
    create.rows = rows;
    create.wrap = wrap;
    lab.create_ = create;
    return lab;
}

std::size_t Lab::chemical(const std::string& name, Spread conc, Spread diff, Bounds bounds, bool anisotropic) {
    const std::size_t place = experiment_.chemicals.size();
    experiment_.chemicals.push_back({name, bounds, anisotropic, nullptr});
    for (Phase& phase : experiment_.phases) {
        phase.bounds.push_back(bounds);
        phase.rates.push_back(std::nullopt);
    }
    uses_.push_back(UseChemical{place, conc, diff});
    return place;
}

std::size_t Lab::mapping(const std::string& name) {
    experiment_.mappings.push_back(name);
    return experiment_.mappings.size() - 1;
}

std::size_t Lab::expression(Expression expression) {
    experiment_.expressions.push_back(std::move(expression));
    return experiment_.expressions.size() - 1;
}

Rule& Lab::rule(Action action, Condition condition) {
    Rule rule;
    rule.action = std::move(action);
    rule.condition = std::move(condition);
    experiment_.rules.push_back(std::move(rule));
    return experiment_.rules.back();
}

Phase& Lab::phase(std::uint64_t begin) {
    Phase next = experiment_.phases.back();
    next.begin = begin;
    next.rates.assign(next.rates.size(), std::nullopt);
    experiment_.phases.push_back(next);
    return experiment_.phases.back();
}

Lab& Lab::time_step(double dt) {
    for (Phase& phase : experiment_.phases) phase.time_step = dt;
    return *this;
}

Lab& Lab::polarity(double degrees, double deviation) {
    uses_.push_back(UsePolarity{Spread{degrees, deviation}});
    return *this;
}

Lab& Lab::seed(std::int64_t value) {
    experiment_.seed = value;
    return *this;
}

Experiment Lab::done() const {
    Experiment experiment = experiment_;
    experiment.prepattern = uses_;
    experiment.prepattern.push_back(create_);
    validate(experiment);
    return experiment;
}

Operand number(double value) { return Operand::number(value); }
Operand quantity(Quantity what, std::size_t index) { return {what, 0.0, index}; }

Condition compare(Operand left, Comparison comparison, Operand right) { return Compare{left, comparison, right}; }

React react(Model model, std::vector<std::size_t> species, std::vector<double> parameters, double scale) {
    React action;
    action.model = model;
    action.species = std::move(species);
    action.scale = number(scale);
    for (const double parameter : parameters) action.parameters.push_back(number(parameter));
    return action;
}

Change change(std::size_t chemical, Operand amount, double deviation) {
    return {Target::concentration, chemical, amount, deviation};
}
Change change_rate(std::size_t chemical, Operand amount, double deviation) {
    return {Target::rate, chemical, amount, deviation};
}

}  // namespace pelage::verify
