// A lattice that holds all that a fused program may hold.
#pragma once

#include "core/prepattern.hpp"
#include "core/tissue.hpp"
#include "verify/lab.hpp"

#include <cstdint>
#include <vector>

namespace test {

using namespace pelage;
using namespace pelage::verify;

// Two chemicals that react and one that follows them by rules with draws.
inline Experiment busy(std::size_t columns, std::size_t rows, Boundary boundary) {
    Lab lab = Lab::matrix(columns, rows, boundary);
    const std::size_t u = lab.chemical("U", {4, 2}, {5, 0}, {0, 6});
    const std::size_t v = lab.chemical("V", {4, 2}, {1, 0});
    const std::size_t m = lab.chemical("M", {1, 1}, {0, 0}, unbounded);
    lab.rule(react(model_named("turing"), {u, v}, {16, 12}));
    lab.rule(change(v, number(0.005), 0.005), compare(quantity(Quantity::row), Comparison::less, number(5)));
    lab.rule(And{}, compare(quantity(Quantity::column), Comparison::greater, number(5)));
    lab.rule(change(m, quantity(Quantity::concentration, u)), Probability{number(0.3)});
    lab.rule(Set{Target::concentration, m, quantity(Quantity::random)},
             compare(quantity(Quantity::x), Comparison::less, quantity(Quantity::y)));
    return lab.time_step(0.01).done();
}

inline Snapshot run(Backend& backend, const Experiment& experiment, std::vector<std::uint64_t> parts) {
    const auto tissue = backend.make_tissue(experiment);
    for (const std::uint64_t part : parts) tissue->advance(part);
    return tissue->read();
}

}  // namespace test
