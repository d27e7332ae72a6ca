// See cases.hpp: bounds of every kind, values at the ends of what a float can hold, and sizes beyond 16 bits.
#include "language/parse.hpp"
#include "verify/cases.hpp"
#include "verify/lab.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <utility>

namespace pelage::verify {

namespace {

// The same reaction and diffusion under every kind of bounds; all but the last are reached.
Experiment saturated(Lab lab) {
    const std::array<Bounds, 6> kinds{
        {{3.5, infinite}, {-infinite, 4.5}, {3.75, 4.25}, {0, 4}, {-4, 4.75}, {-1e30, 1e30}}};
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const auto u = lab.chemical(fmt::format("U{}", i), {4, 1.5}, {0.4, 0}, kinds[i]);
        const auto v = lab.chemical(fmt::format("V{}", i), {4, 1.5}, {0.02, 0}, unbounded);
        lab.rule(react(model_named("turing"), {u, v}, {16, 12}));
    }
    return lab.time_step(0.02).done();
}

// Sums and products alone: their results are defined whatever goes in.
Experiment plain_arithmetic(Lab lab) {
    const auto u = lab.chemical("U", {1, 0.5}, {0.25, 0}, unbounded);
    const auto v = lab.chemical("V", {1, 0.5}, {0, 0}, {-infinite, 1e38});
    const auto w = lab.chemical("W", {1, 0.5}, {0, 0}, unbounded);
    lab.rule(change(v, quantity(Quantity::concentration, u)));
    lab.rule(
        change(w, quantity(Quantity::concentration, v)),
        compare(quantity(Quantity::concentration, w), Comparison::less_equal, quantity(Quantity::concentration, v)));
    return lab.time_step(0.5).done();
}

constexpr std::size_t apart = 29;  // few cells: what spreads from them must leave others alone

void special_values(Snapshot& state) {
    using Limits = std::numeric_limits<float>;
    const std::array<float, 12> values{0.0f,
                                       -0.0f,
                                       Limits::denorm_min(),
                                       -Limits::denorm_min(),
                                       3 * Limits::denorm_min(),
                                       Limits::min(),
                                       -Limits::min() / 2,
                                       Limits::max(),
                                       -Limits::max(),
                                       Limits::infinity(),
                                       -Limits::infinity(),
                                       Limits::quiet_NaN()};
    for (std::size_t chemical = 0; chemical < state.conc.size(); ++chemical) {
        for (std::size_t cell = chemical; cell < state.cells(); cell += apart) {
            state.conc[chemical][cell] = static_cast<double>(values[cell / apart % values.size()]);
        }
    }
}

constexpr double subnormal = 0x1p-130;

// Subnormal numbers are 0, in and out: as numbers of rules, as start values (of chemical Z, which nothing changes,
// too), as differences, as products.
Experiment near_zero(Lab lab) {
    const auto u = lab.chemical("U", {1, 0.5}, {0.25, 0}, unbounded);
    const auto v = lab.chemical("V", {1, 0.5}, {0.1, 0}, {subnormal, 1});
    const auto w = lab.chemical("W", {1, 0.5}, {subnormal, 0}, unbounded);
    const auto z = lab.chemical("Z", {1, 0.5}, {0, 0}, {-infinite, 1});
    lab.rule(react(model_named("gray-scott"), {u, v}, {0, 0.06}, 0.1));
    lab.rule(change(v, quantity(Quantity::concentration, w)));
    lab.rule(change(w, number(0x1p-120)), compare(number(subnormal), Comparison::less_equal, number(0)));
    lab.rule(Set{Target::concentration, w, number(-subnormal)},
             compare(quantity(Quantity::concentration, z), Comparison::equal, number(subnormal)));
    return lab.time_step(0.5).done();
}

// While it grows by interpolation.
Experiment grown_near_zero(Lab lab) {
    Expand growth;
    growth.columns = growth.rows = 1;
    growth.interpolation = Interpolation::bicubic;
    lab.rule(growth).every = 3;
    return near_zero(std::move(lab));
}

// About the smallest normal number: one in four is subnormal.
void tiny_values(Snapshot& state) {
    constexpr double step = 0x1p-143;
    for (std::size_t chemical = 0; chemical < state.conc.size(); ++chemical) {
        for (std::size_t cell = 0; cell < state.cells(); ++cell) {
            const std::size_t drawn = ((cell + 131 * chemical) * 2654435761u) % 1'000'003;
            state.conc[chemical][cell] = step * (static_cast<double>(drawn) - 200'000.0);
        }
    }
}

Experiment spreading(Lab lab) {
    lab.chemical("U", {4, 1}, {0.5, 0}, unbounded);
    lab.chemical("V", {4, 1}, {0.25, 0}, {3.25, 4.75});
    return lab.time_step(0.25).done();
}

// Rules act in rows and columns whose number has more than 16 bits, and where there are more than those.
Experiment far_lines(Lab lab) {
    const std::size_t u = lab.chemical("U", {4, 1}, {0.5, 0}, unbounded);
    const std::size_t v = lab.chemical("V", {4, 1}, {0.25, 0}, {3.25, 4.75});
    const auto beyond = [&](std::size_t chemical, Quantity what, double amount) {
        lab.rule(change(chemical, number(amount)), compare(quantity(what), Comparison::greater, number(65'536)));
    };
    beyond(u, Quantity::row, 0.25);
    beyond(u, Quantity::columns, 0.375);
    beyond(v, Quantity::column, 0.25);
    beyond(v, Quantity::rows, 0.375);
    return lab.time_step(0.25).done();
}

// Every cell looks three columns and rows far.
Experiment looking_around(Size size) {
    return parse_experiment(
        fmt::format("define chemical U floor none\nuse seed 5\nuse chemical U conc 2 dev 0.5 diff 0.125\n"
                    "define stencil look 7x7 1 0 0 2 0 0 3  0 4 0 0 6 0 0  2 0 0 0 0 0 0  5 0 4 -49 0 0 7  "
                    "0 0 0 0 0 1 0  0 0 0 0 0 0 2  0 3 0 5 0 0 4\n"
                    "create matrix {} {}\nrule always change U conc (look(U) / 128)\n",
                    size.columns, size.rows),
        "sizes/many-columns-around", ".");
}

}  // namespace

std::vector<Case> extreme_cases() {
    const auto matrix = [](Experiment (*make)(Lab), Boundary boundary) {
        return [=](Size size) { return make(Lab::matrix(size.columns, size.rows, boundary)); };
    };
    const auto grid = [](Experiment (*make)(Lab)) {
        return [=](Size size) { return make(Lab::grid(size.columns, size.rows, true)); };
    };
    const std::vector<Size> sizes{{5, 7}, {33, 30}, {64, 17}};
    // More rows than 16 bits count, more columns, more cells.
    const std::vector<Size> large{{3, 65'539}, {65'539, 3}, {257, 257}};
    return {
        {.name = "saturation/fused", .experiment = matrix(saturated, Boundary::no_flux), .sizes = few_sizes()},
        {.name = "saturation/published", .experiment = grid(saturated), .sizes = few_sizes()},
        {.name = "values/special/fused",
         .experiment = matrix(plain_arithmetic, Boundary::wrap),
         .sizes = sizes,
         .iterations = 3,
         .touch = special_values},
        {.name = "values/special/published",
         .experiment = grid(plain_arithmetic),
         .sizes = sizes,
         .iterations = 3,
         .touch = special_values},
        {.name = "values/denormal/fused",
         .experiment = matrix(near_zero, Boundary::no_flux),
         .sizes = sizes,
         .iterations = 20,
         .touch = tiny_values},
        {.name = "values/denormal/published",
         .experiment = grid(near_zero),
         .sizes = sizes,
         .iterations = 20,
         .touch = tiny_values},
        {.name = "values/denormal/grown",
         .experiment = matrix(grown_near_zero, Boundary::wrap),
         .sizes = sizes,
         .iterations = 12,
         .touch = tiny_values,
         .grows = true},
        {.name = "sizes/many-rows", .experiment = matrix(far_lines, Boundary::wrap), .sizes = large, .iterations = 3},
        // Large enough for several strips: of single steps, and of passes of several.
        {.name = "sizes/strips",
         .experiment = matrix(spreading, Boundary::wrap),
         .sizes = {{19, 11}, {97, 101}, {203, 211}},
         .iterations = 90},
        // More cells than a launch of shared steps takes all iterations of.
        {.name = "sizes/many-cells",
         .experiment = matrix(spreading, Boundary::no_flux),
         .sizes = {{1033, 1021}},
         .iterations = 3},
        {.name = "sizes/many-columns-around",
         .experiment = looking_around,
         .sizes = {{65'539, 3}, {3, 65'539}},
         .iterations = 3}};
}

}  // namespace pelage::verify
