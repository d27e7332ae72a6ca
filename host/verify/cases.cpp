// See cases.hpp: the table, and its cases of diffusion, reactions and rates.
#include "verify/cases.hpp"

#include "verify/lab.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace pelage::verify {

const char* word(Boundary boundary) {
    switch (boundary) {
        case Boundary::no_flux:
            return "no-flux";
        case Boundary::wrap:
            return "wrap";
        case Boundary::absorbing:
            return "absorbing";
    }
    return "?";
}

const char* word(Stencil stencil) {
    switch (stencil) {
        case Stencil::moore:
            return "moore";
        case Stencil::nine_point:
            return "nine-point";
        case Stencil::five_point:
            return "five-point";
        case Stencil::sims:
            return "sims";
        case Stencil::own:
            return "own-weights";
        case Stencil::seven_point:
            return "seven-point";
        case Stencil::twenty_seven_point:
            return "twenty-seven-point";
    }
    return "?";
}

std::string Size::text() const {
    const std::string plane = fmt::format("{} x {}", columns, rows);
    return layers == 0 ? plane : fmt::format("{} x {}", plane, layers);
}

std::vector<Size> sharp_sizes() {
    return {{1, 1},   {1, 7},   {17, 1}, {2, 3},   {3, 2},   {5, 5},    {15, 4},  {16, 16},
            {17, 31}, {31, 17}, {33, 3}, {63, 64}, {65, 97}, {127, 61}, {257, 31}};
}
std::vector<Size> few_sizes() { return {{1, 1}, {2, 3}, {1, 5}, {19, 1}, {37, 29}, {130, 41}}; }

namespace {

constexpr Stencil stencils[] = {Stencil::nine_point, Stencil::moore, Stencil::five_point, Stencil::sims, Stencil::own};
constexpr Boundary boundaries[] = {Boundary::no_flux, Boundary::wrap, Boundary::absorbing};

// U knows no bounds, V is held between two.
Experiment diffusing(Lab lab) {
    const auto u = lab.chemical("U", {4, 1}, {0.8, 0}, unbounded);
    const auto v = lab.chemical("V", {4, 1}, {0.2, 0}, {3.25, 4.75});
    lab.rule(react(model_named("turing"), {u, v}, {16, 12}));
    return lab.time_step(0.02).done();
}

// Every model of the table on chemicals of its own.
Experiment reacting(Lab lab) {
    for (std::size_t model = 0; model < model_table().size(); ++model) {
        React react{Model{model}, {}, number(0.75), {}};
        for (const ModelSpecies& species : react.model.facts().species) {
            const Spread conc{(species.low + species.high) / 2, (species.high - species.low) / 2};
            const double rate = react.species.empty() ? 0.11 : 0.07;
            const std::string name = react.model.facts().word + " " + species.name;
            react.species.push_back(lab.chemical(name, conc, {rate, 0}, unbounded));
        }
        for (const double parameter : sensible(react.model.facts(), 0)) react.parameters.push_back(number(parameter));
        lab.rule(react);
    }
    return lab.time_step(0.01).done();
}

// Chemicals with rates that differ between cells, feel direction, are the same everywhere, or are none.
Experiment uneven(Lab lab) {
    lab.chemical("U", {4, 2}, {0.3, 0.25}, unbounded);
    lab.chemical("V", {2, 1}, {0.2, 0}, unbounded);
    lab.chemical("W", {3, 1}, {0.25, 0}, {0.5, 4.5}, true);
    const auto still = lab.chemical("S", {1, 0.5}, {0, 0}, unbounded);
    lab.rule(change(still, number(0.125)));
    lab.polarity(30, 180);
    return lab.time_step(0.25).done();
}

// Some cells without a polarity, some without rates.
void uneven_touch(Snapshot& state) {
    for (std::size_t cell = 0; cell < state.cells(); cell += 3) {
        state.polarity_x[cell] = 0.0;
        if (cell % 2 == 0) state.polarity_y[cell] = 0.0;
        if (cell % 5 == 0) state.diff[0][cell] = 0.0;
    }
}

// A cell whose gradients are just as steep as one that is not followed yet: the least that is lies above it.
void hardly_steep_touch(Snapshot& state) {
    if (state.columns < 5 || state.rows < 5) return;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            const std::size_t cell = (row + 1) * state.columns + column + 1;
            state.conc[0][cell] = 0.25;
            state.conc[1][cell] = row == 1 && column == 2 ? 0.0001 : 0.0;
        }
    }
}

// Two gradients to follow, the second one where U is large; W spreads along what results.
Experiment polarized(Lab lab) {
    const auto u = lab.chemical("U", {4, 2}, {0.3, 0}, unbounded);
    const auto v = lab.chemical("V", {2, 1}, {0.05, 0.03}, unbounded);
    lab.chemical("W", {3, 1}, {0.25, 0.1}, unbounded, true);
    lab.rule(Polarize{v});
    lab.rule(Polarize{u}, compare(quantity(Quantity::concentration, u), Comparison::greater, number(4)));
    lab.rule(Polarize{v}, Probability{number(0.125)});
    return lab.time_step(0.25).done();
}

}  // namespace

std::vector<Case> diffusion_cases() {
    std::vector<Case> cases;
    for (const Stencil stencil : stencils) {
        for (const Boundary boundary : boundaries) {
            const auto make = [=](Size size) {
                return diffusing(Lab::matrix(size.columns, size.rows, boundary, stencil));
            };
            cases.push_back(
                {fmt::format("diffusion/{}/{}", word(stencil), word(boundary)), make, sharp_sizes(), 60, {}});
        }
    }
    for (const Boundary boundary : boundaries) {
        const auto make = [=](Size size) { return diffusing(Lab::wide(size.columns, size.rows, boundary)); };
        cases.push_back({fmt::format("diffusion/5x5/{}", word(boundary)), make, sharp_sizes(), 60, {}});
    }
    for (const bool wrap : {false, true}) {
        const auto make = [=](Size size) { return diffusing(Lab::grid(size.columns, size.rows, wrap)); };
        cases.push_back({fmt::format("diffusion/published/{}", wrap ? "wrap" : "open"), make, sharp_sizes(), 60, {}});
    }
    return cases;
}

std::vector<Case> reaction_cases() {
    const auto fused = [](Size size) { return reacting(Lab::matrix(size.columns, size.rows, Boundary::no_flux)); };
    const auto published = [](Size size) { return reacting(Lab::grid(size.columns, size.rows, true)); };
    return {{"reaction/fused", fused, few_sizes(), 60, {}, false, true},
            {"reaction/published", published, few_sizes(), 60, {}, false, true}};
}

std::vector<Case> rate_cases() {
    std::vector<Case> cases;
    const std::vector<Size> sizes{{1, 6}, {7, 1}, {2, 2}, {3, 5}, {4, 3}, {18, 17}, {67, 23}};
    const auto add = [&](const std::string& name, const std::function<Lab(Size)>& lab, bool with_uneven) {
        const auto turning = [lab](Size size) { return polarized(lab(size)); };
        cases.push_back({"rates/polarized/" + name, turning, sizes, 60, hardly_steep_touch, false, true});
        if (!with_uneven) return;
        const auto fixed = [lab](Size size) { return uneven(lab(size)); };
        cases.push_back({"rates/uneven/" + name, fixed, sizes, 60, uneven_touch, false, true});
    };
    for (const Stencil stencil : stencils) {
        for (const Boundary boundary : boundaries) {
            const bool like_nine_point = stencil == Stencil::sims || stencil == Stencil::own;  // but for the weights
            if (like_nine_point && boundary != Boundary::absorbing) continue;
            const auto lab = [=](Size size) { return Lab::matrix(size.columns, size.rows, boundary, stencil); };
            add(fmt::format("{}/{}", word(stencil), word(boundary)), lab, stencil == Stencil::nine_point);
        }
    }
    add(
        "published/open", [](Size size) { return Lab::grid(size.columns, size.rows, false); }, true);
    add(
        "published/wrap", [](Size size) { return Lab::grid(size.columns, size.rows, true); }, true);
    return cases;
}

const std::vector<Case>& lattice_cases() {
    static const std::vector<Case> table = [] {
        std::vector<Case> cases;
        for (const auto& part : {diffusion_cases(), reaction_cases(), rate_cases(), rule_cases(), growth_cases(),
                                 neural_cases(), extreme_cases(), volume_cases(), timed_cases()}) {
            cases.insert(cases.end(), part.begin(), part.end());
        }
        return cases;
    }();
    return table;
}

const Case& lattice_case(const std::string& name) {
    for (const Case& one : lattice_cases()) {
        if (one.name == name) return one;
    }
    throw std::out_of_range("no lattice case is named " + name);
}

}  // namespace pelage::verify
