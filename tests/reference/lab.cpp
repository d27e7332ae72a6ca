// See lab.hpp.
#include "lab.hpp"

#include "core/prepattern.hpp"
#include "reference/backend.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>
#include <random>

namespace test {

using namespace pelage;

namespace {

constexpr double none = std::numeric_limits<double>::infinity();

Experiment tissue(Statement create, const std::vector<std::string>& names) {
    Experiment experiment;
    Phase phase;
    for (const std::string& name : names) {
        experiment.chemicals.push_back({name, {-none, none}, false, nullptr});
        phase.bounds.push_back({-none, none});
        phase.rates.push_back(std::nullopt);
    }
    experiment.prepattern.push_back(std::move(create));
    experiment.phases.push_back(phase);
    experiment.outputs.push_back({});
    return experiment;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

bool same_bits(const std::vector<std::vector<double>>& a, const std::vector<std::vector<double>>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto& x, const auto& y) { return same_bits(x, y); });
}

}  // namespace

Experiment matrix(std::size_t columns, std::size_t rows, Boundary boundary, Stencil stencil,
                  const std::vector<std::string>& names) {
    Experiment experiment = tissue(CreateMatrix{columns, rows, boundary, 0.0, 0.0}, names);
    experiment.stencil = stencil;
    return experiment;
}

Experiment volume(std::size_t columns, std::size_t rows, std::size_t layers, Boundary boundary, Stencil stencil,
                  const std::vector<std::string>& names) {
    Experiment experiment = tissue(CreateVolume{columns, rows, layers, boundary}, names);
    experiment.stencil = stencil;
    return experiment;
}

Experiment grid(std::size_t columns, std::size_t rows, bool wrap, const std::vector<std::string>& names) {
    return tissue(CreateGrid{Arrangement::sqr_grid, columns, rows, 0.0, 0.0, 0.0, false, wrap}, names);
}

Rule rule(Action action, Condition condition) {
    Rule result;
    result.action = std::move(action);
    result.condition = std::move(condition);
    return result;
}

Operand number(double value) { return Operand::number(value); }

Condition compare(Operand left, Comparison comparison, Operand right) { return Compare{left, comparison, right}; }

Snapshot blank(const Experiment& experiment) { return initial_state(experiment); }

std::unique_ptr<Tissue> start(const Experiment& experiment, const Snapshot& initial, Precision precision) {
    return reference_backend(precision)->make_tissue(experiment, initial);
}

Snapshot after(std::uint64_t iterations, const Experiment& experiment, const Snapshot& initial, Precision precision) {
    const auto running = start(experiment, initial, precision);
    running->advance(iterations);
    return running->read();
}

std::vector<double> scatter(std::size_t count, double low, double high, std::uint32_t seed) {
    std::mt19937 words(seed);
    std::vector<double> values(count);
    for (double& value : values) value = low + (high - low) * (static_cast<double>(words()) * 0x1p-32);
    return values;
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

double spread(const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return *high - *low;
}

bool same(const Snapshot& a, const Snapshot& b) {
    return a.iteration == b.iteration && a.columns == b.columns && a.rows == b.rows && same_bits(a.conc, b.conc) &&
           same_bits(a.diff, b.diff) && same_bits(a.mappings, b.mappings) && same_bits(a.x, b.x) &&
           same_bits(a.y, b.y) && same_bits(a.polarity_x, b.polarity_x) && same_bits(a.polarity_y, b.polarity_y) &&
           a.birth == b.birth && a.neighbours == b.neighbours && a.fixed == b.fixed;
}

}  // namespace test
