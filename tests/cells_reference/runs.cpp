// See runs.hpp.
#include "cells_reference/runs.hpp"

#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "reference/cells/tissue.hpp"

#include <bit>

namespace test {

using namespace pelage;

namespace {

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) return false;
    }
    return true;
}

bool same_bits(const std::vector<std::vector<double>>& a, const std::vector<std::vector<double>>& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!same_bits(a[i], b[i])) return false;
    }
    return true;
}

}  // namespace

std::unique_ptr<Tissue> cells(const std::string& text, const Snapshot& state, Precision precision,
                              NeighbourSearch search) {
    auto experiment = std::make_shared<const Experiment>(parse_experiment(text, "test.pex", "."));
    return make_reference_cells(std::move(experiment), state, precision, search);
}

std::unique_ptr<Tissue> cells(const std::string& text, Precision precision, NeighbourSearch search) {
    return cells(text, initial(text), precision, search);
}

Snapshot after(Tissue& tissue, std::uint64_t iterations) {
    tissue.advance(iterations);
    return tissue.read();
}

Snapshot initial(const std::string& text) { return initial_state(parse_experiment(text, "test.pex", ".")); }

bool same(const Snapshot& a, const Snapshot& b) {
    return a.iteration == b.iteration && same_bits(a.conc, b.conc) && same_bits(a.diff, b.diff) &&
           same_bits(a.mappings, b.mappings) && same_bits(a.x, b.x) && same_bits(a.y, b.y) &&
           same_bits(a.polarity_x, b.polarity_x) && same_bits(a.polarity_y, b.polarity_y) && a.birth == b.birth &&
           a.neighbours == b.neighbours && a.fixed == b.fixed && a.mirrors == b.mirrors;
}

}  // namespace test
