// See cases.hpp. Bytes: every array that a step must read or write is counted once a cell, float; caches are free.
// Flops of a nine-point step: a field's sums 8, its update 2; Turing 5, Gray-Scott 9, linked to the sum by 2 fma;
// bounds 2 a field.
#include "bench/cases.hpp"

#include "bench/formula_cases.hpp"
#include "core/neural.hpp"
#include "language/parse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string_view>
#include <utility>

namespace pelage::bench {

namespace {

const std::vector<std::size_t> lattice_sides{10, 32, 100, 128, 256, 512, 1024, 2048, 3162, 4096};
const std::vector<std::size_t> middle_sides{1024};
const std::vector<std::size_t> quick_sides{24, 48};

std::size_t square(std::size_t side) { return side * side; }

std::string turing(std::size_t side, const char* boundary) {
    return fmt::format(
        "define chemical U limit 6\ndefine chemical V\ndefine time_step 0.01\nuse seed 7\n"
        "use chemical U conc 4 diff 10\nuse chemical V conc 4.5 dev 0.5 diff 2\n"
        "create matrix {0} {0} {1}\nrule always react U V turing alpha 16 beta 12\n",
        side, boundary);
}

std::string set_cells(std::size_t first, std::size_t count, const char* what) {
    return fmt::format("set cells {} to {} chemical {}\n", first, first + count - 1, what);
}

// Bands of V, which soon fill the lattice with a maze for good; from noise V would die out everywhere.
std::string gray_scott(std::size_t side, const char* boundary) {
    std::string text = fmt::format(
        "define chemical U limit 1\ndefine chemical V limit 1\nuse seed 7\n"
        "use chemical U conc 0.9 dev 0.1 diff 0.2\nuse chemical V conc 0 diff 0.1\ncreate matrix {0} {0} {1}\n",
        side, boundary);
    for (std::size_t row = 0; row < side; row += 24) {
        const std::size_t count = std::min<std::size_t>(9, side - row) * side;
        text += set_cells(row * side, count, "U conc 0.5") + set_cells(row * side, count, "V conc 0.25 dev 0.05");
    }
    return text + "rule always react U V gray-scott f 0.037 k 0.06\n";
}

// A small spot in an empty field, which neither grows nor goes. All around it V has decayed as far as single precision
// goes, as it would in a longer run.
std::string gray_scott_seed(std::size_t side) {
    constexpr std::size_t spot = 9;
    std::string text = fmt::format(
        "define chemical U limit 1\ndefine chemical V limit 1\nuse seed 7\n"
        "use chemical U conc 1 diff 0.2\nuse chemical V conc 1e-37 diff 0.1\ncreate matrix {0} {0} wrap\n",
        side);
    const std::size_t width = std::min(spot, side);
    for (std::size_t row = (side - width) / 2; row < (side + width) / 2; ++row) {
        const std::size_t first = row * side + (side - width) / 2;
        text += set_cells(first, width, "U conc 0.5") + set_cells(first, width, "V conc 0.25");
    }
    return text + "rule always react U V gray-scott f 0.037 k 0.0655\n";
}

// One chemical driven to either side of a threshold.
std::string reinforcement(std::size_t side) {
    return fmt::format(
        "define chemical C floor none\ndefine time_step 0.0015\nuse seed 7\n"
        "use chemical C conc 5 dev 3 diff 1\ncreate matrix {0} {0} no-flux\n"
        "rule always react C reinforcement threshold 5 width 5\n",
        side);
}

// A pattern and a third chemical that follows it.
std::string three_chemicals(std::size_t side) {
    return fmt::format(
        "define chemical U\ndefine chemical V floor 2\ndefine chemical C floor none\ndefine time_step 0.0015\n"
        "use seed 7\nuse chemical U conc 4 diff 200\nuse chemical V conc 4 dev 0.5 diff 5\n"
        "use chemical C conc 5 dev 3 diff 1\ncreate matrix {0} {0} no-flux\n"
        "rule always react U V turing alpha 16 beta 12\n"
        "rule always react C reinforcement threshold 5 width 5\n",
        side);
}

// V spreads along the polarity of each cell only.
std::string anisotropic(std::size_t side) {
    return fmt::format(
        "define chemical U\ndefine chemical V anisotropic\nuse seed 7\n"
        "use chemical U conc 4 dev 1 diff 0.024\nuse chemical V conc 4 dev 1 diff 0.00625\n"
        "use polarity 30 dev 60\ncreate matrix {0} {0} no-flux\n"
        "rule always react U V scale 0.008 turing alpha 16 beta 12\n",
        side);
}

std::string noise(std::size_t side) {
    return turing(side, "wrap") + "rule probability 0.01 change V conc 0.1 dev 0.05\n";
}

struct Hexagons {
    std::size_t columns = 1;
    std::size_t rows = 1;
};

// About as wide as high: rows are 1.7321 apart, columns 2.
Hexagons hexagons(std::size_t cells) {
    const auto columns = std::max<std::size_t>(
        1, static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(cells) * 1.7321 / 2))));
    return {columns, std::max<std::size_t>(1, (cells + columns / 2) / columns)};
}

std::size_t hexagon_count(std::size_t cells) { return hexagons(cells).columns * hexagons(cells).rows; }

std::string tissue(std::size_t cells, const char* more) {
    const Hexagons grid = hexagons(cells);
    return fmt::format(
        "define chemical U\ndefine chemical V\ndefine domain {0} {0}\ndefine division_limit 6\nuse seed 7\n"
        "use chemical U conc 4 dev 2 diff 0.15\nuse chemical V conc 4 dev 2 diff 0.01\n"
        "create hex_grid {1} {2} dev 0.2\nrule always react U V scale 0.01 turing alpha 16 beta 12\n{3}",
        4 * std::max(grid.columns, grid.rows) + 100, grid.columns, grid.rows, more);
}

Case lattice(std::string name, std::vector<std::size_t> sizes, double bytes, double flops,
             std::function<std::string(std::size_t)> text) {
    Case one;
    one.suite = "lattice";
    one.name = std::move(name);
    one.sizes = std::move(sizes);
    one.quick_sizes = quick_sides;
    one.text = std::move(text);
    one.cells = square;
    one.bytes = bytes;
    one.flops = flops;
    return one;
}

std::vector<Case> lattice_cases() {
    std::vector<Case> cases;
    cases.push_back(lattice("turing", lattice_sides, 16, 32, [](std::size_t n) { return turing(n, "wrap"); }));
    cases.back().kernel = Kernel{model_named("turing"), true};
    cases.push_back(
        lattice("turing-no-flux", middle_sides, 16, 32, [](std::size_t n) { return turing(n, "no-flux"); }));
    cases.back().kernel = Kernel{model_named("turing"), false};
    cases.push_back(lattice("gray-scott", {256, 1024}, 16, 37, [](std::size_t n) { return gray_scott(n, "wrap"); }));
    cases.back().kernel = Kernel{model_named("gray-scott"), true};
    cases.push_back(lattice("gray-scott-seed", {256, 1024}, 16, 37, gray_scott_seed));
    cases.back().kernel = Kernel{model_named("gray-scott"), true};
    cases.back().twin = [](std::size_t n) { return gray_scott(n, "wrap"); };
    cases.push_back(
        lattice("gray-scott-no-flux", middle_sides, 16, 37, [](std::size_t n) { return gray_scott(n, "no-flux"); }));
    cases.back().kernel = Kernel{model_named("gray-scott"), false};
    cases.back().by_default = false;
    cases.push_back(lattice("reinforcement", middle_sides, 8, 23, reinforcement));
    cases.push_back(lattice("three-chemicals", middle_sides, 24, 53, three_chemicals));
    // Eight pairs: two rates with two roundings each (14), their mean (5), the exchange (4).
    cases.push_back(lattice("anisotropic", middle_sides, 28, 20 + 8 * 23, anisotropic));
    // A draw of Philox is about 100 whole-number operations.
    cases.push_back(lattice("noise", middle_sides, 16, 132, noise));
    return cases;
}

// A list of neighbours holds about 8 ids in a tissue at rest; each costs 20 flops (distance, two exchanges, a push).
std::vector<Case> cell_cases() {
    Case one;
    one.suite = "cells";
    one.name = "tissue";
    one.sizes = {6'000, 20'000, 100'000, 1'000'000};
    one.quick_sizes = {600, 2'000};
    one.text = [](std::size_t cells) { return tissue(cells, ""); };
    one.cells = hexagon_count;
    one.bytes = 24 + 20 + 4 * 9;
    one.flops = 8 * 20 + 20;
    return {one};
}

// Written: a list of about 8 ids and its length. Looked at: about 28 points in nine bins, 5 flops each.
std::vector<Case> neighbour_cases() {
    std::vector<Case> cases;
    for (const bool shuffled : {false, true}) {
        Case one;
        one.suite = "neighbours";
        one.name = shuffled ? "scattered" : "hexagonal";
        one.sizes = {20'000, 100'000, 1'000'000};
        one.quick_sizes = {600, 2'000};
        one.cells = [](std::size_t points) { return points; };
        one.bytes = 8 + 4 * 9;
        one.flops = 28 * 5;
        one.shuffled = shuffled;
        cases.push_back(one);
    }
    return cases;
}

std::vector<Case> growth_cases() {
    Case matrix;
    matrix.suite = "growth";
    matrix.name = "expansion";
    matrix.sizes = {130, 512};
    matrix.quick_sizes = {24};
    matrix.text = [](std::size_t side) {
        return three_chemicals(side) + "rule every 50 always expand rows 1 columns 1 first rows\n";
    };
    matrix.cells = square;
    matrix.whole = 3'000;
    matrix.bytes = 24;
    matrix.flops = 53;

    Case tissues;
    tissues.suite = "growth";
    tissues.name = "division";
    tissues.sizes = {6'000, 100'000};
    tissues.quick_sizes = {600};
    tissues.text = [](std::size_t cells) {
        return tissue(cells, "rule probability 0.0002 divide direction 0 dev 180\n");
    };
    tissues.cells = hexagon_count;
    tissues.whole = 1'000;
    tissues.bytes = cell_cases().front().bytes;
    tissues.flops = cell_cases().front().flops;
    Case seedling = tissues;
    seedling.name = "small-division";
    seedling.sizes = {100, 300, 1'000};
    seedling.quick_sizes = {100};
    seedling.whole = 3'000;
    return {matrix, tissues, seedling};
}

std::string lightning(std::size_t side, std::string_view more = {}) {
    return fmt::format(
        "define chemical order\ndefine chemical potential\nuse seed 1\ncreate charges {0} {0}\n"
        "set cells where (COLUMN == {1} and ROW == {1}) chemical order conc 1\n"
        "rule always aggregate order potential eta 6.8{2}\n",
        side, side / 2, more);
}

// The side of a lattice that is wide for so many charges.
std::size_t wide_for(std::size_t charges) {
    return static_cast<std::size_t>(std::max(120.0, 4.0 * std::sqrt(static_cast<double>(charges))));
}

// What a charge costs does not grow: it adds to 36 numbers of some 200 blocks and to some 300 candidates near it.
std::vector<Case> far_field_cases(Case one) {
    one.name = "far-lightning";
    one.sizes = {10'000, 30'000};
    one.text = [](std::size_t charges) { return lightning(wide_for(charges), " far-field"); };
    one.far_field = true;
    one.bytes = 120'000;
    one.flops = 160'000;
    Case long_one = one;
    long_one.name = "long-far-lightning";
    long_one.sizes = {100'000, 1'000'000};
    long_one.text = [](std::size_t charges) { return lightning(charges <= 100'000 ? 2048 : 8192, " far-field"); };
    long_one.by_default = false;
    return {one, long_one};
}

// What a charge costs grows with how many there are: each is a look at all candidates, about two a charge. The smallest
// work for one is its term of the sum (21 operations) and a weight (40) for each of them.
std::vector<Case> aggregate_cases() {
    Case one;
    one.suite = "aggregate";
    one.name = "lightning";
    one.sizes = {1'000, 3'000, 10'000, 30'000};
    one.quick_sizes = {100};
    one.text = [](std::size_t charges) { return lightning(wide_for(charges)); };
    one.cells = [](std::size_t charges) { return charges; };
    one.particles = true;
    one.bytes = 40;
    one.flops = 122;
    Case long_one = one;
    long_one.name = "long-lightning";
    long_one.sizes = {100'000};
    long_one.text = [](std::size_t) { return lightning(2048); };
    long_one.by_default = false;
    std::vector<Case> cases{one, long_one};
    for (Case& far : far_field_cases(one)) cases.push_back(std::move(far));
    return cases;
}

// A ball of V in a torus of three dimensions, which soon fills it.
std::string gray_scott_volume(std::size_t side) {
    return fmt::format(
        "define chemical U limit 1\ndefine chemical V limit 1\nuse seed 7\n"
        "use chemical U conc 0.9 dev 0.1 diff 0.1\nuse chemical V conc 0 diff 0.05\ncreate volume {0} {0} {0} wrap\n"
        "set cells where (hypot(hypot(X, Y), Z) < {1}) chemical U conc 0.5 chemical V conc (0.25 + 0.05 * RANDOM)\n"
        "rule always react U V gray-scott f 0.037 k 0.06\n",
        side, 0.8 * static_cast<double>(side));
}

// A field's seven points 9, its update 2; all else as in a lattice.
std::vector<Case> volume_cases() {
    Case one;
    one.suite = "volume";
    one.name = "gray-scott-volume";
    one.sizes = {64, 128, 256};
    one.quick_sizes = {8, 12};
    one.text = gray_scott_volume;
    one.cells = [](std::size_t side) { return side * side * side; };
    one.bytes = 16;
    one.flops = 39;
    return {one};
}

// Of each cell's six edges the neighbour's place and the weight are read (48 bytes), and how many they are (4). An
// edge takes 3 operations a field.
std::vector<Case> mesh_cases() {
    Case one;
    one.suite = "mesh";
    one.name = "turing-torus";
    one.sizes = {71, 224, 708};
    one.quick_sizes = {6, 10};
    one.text = [](std::size_t side) {
        return fmt::format(
            "define chemical U limit 6\ndefine chemical V\ndefine time_step 0.01\nuse seed 7\n"
            "use chemical U conc 4 diff 5\nuse chemical V conc 4.5 dev 0.5 diff 1\ncreate torus {1} {0}\n"
            "rule always react U V turing alpha 16 beta 12\n",
            side, 2 * side);
    };
    one.cells = [](std::size_t side) { return 2 * side * side; };
    one.bytes = 16 + 48 + 4;
    one.flops = 2 * 6 * 3 + 13;
    return {one};
}

constexpr std::size_t network_chemicals = 32, network_hidden = 128;

std::string still_chemicals(std::size_t side) {
    std::string text = "define time_step 0.25\nuse seed 7\n";
    for (std::size_t i = 0; i < network_chemicals; ++i)
        text += fmt::format("define chemical c{0} floor none\nuse chemical c{0} conc (RANDOM - 0.5)\n", i);
    return text + fmt::format("create matrix {0} {0} wrap\n", side);
}

// Weights without a pattern, so small that nothing grows without bound.
void add_network(Experiment& experiment) {
    std::mt19937 numbers(7);
    const auto drawn = [&](std::size_t count, double size) {
        std::vector<double> values(count);
        for (double& value : values) value = size * (static_cast<double>(numbers()) * 0x1p-31 - 1);
        return values;
    };
    const std::size_t count = network_chemicals * network_hidden;
    const auto first = drawn(count, 0.75), bias = drawn(network_hidden, 1), second = drawn(count, 0.125);
    Neural neural;
    neural.network = std::make_shared<const Network>(
        make_network(network_chemicals, network_hidden, first, bias, second, "network"));
    for (std::size_t i = 0; i < network_chemicals; ++i) neural.species.push_back(i);
    Rule rule;
    rule.action = neural;
    experiment.rules.push_back(rule);
}

// As large as those that were published. Flops are those of its two products of matrix and vector alone.
std::vector<Case> neural_cases() {
    Case one;
    one.suite = "neural";
    one.name = "network";
    one.sizes = {128, 256};
    one.quick_sizes = {8, 12};
    one.text = still_chemicals;
    one.finish = add_network;
    one.cells = square;
    one.bytes = 8.0 * network_chemicals;
    one.flops = 4.0 * network_chemicals * network_hidden;
    return {one};
}

}  // namespace

const std::vector<Case>& all_cases() {
    static const std::vector<Case> cases = [] {
        std::vector<Case> list;
        for (const auto& part : {lattice_cases(), formula_cases(), cell_cases(), neighbour_cases(), growth_cases(),
                                 aggregate_cases(), volume_cases(), mesh_cases(), neural_cases()}) {
            list.insert(list.end(), part.begin(), part.end());
        }
        return list;
    }();
    return cases;
}

std::vector<Case> chosen_cases(const Options& options) {
    std::vector<Case> chosen;
    for (const Case& one : all_cases()) {
        if (options.suite != "all" && options.suite != one.suite) continue;
        const auto named = [&](const std::string& word) { return word == "all" || word == one.name; };
        const bool asked = std::ranges::any_of(options.cases, named);
        if (options.cases.empty() ? one.by_default : asked) chosen.push_back(one);
    }
    return chosen;
}

Experiment experiment_of(const Case& one, std::size_t size) {
    Experiment experiment = parse_experiment(one.text(size), fmt::format("bench case {} {}", one.name, size), ".");
    if (one.finish) one.finish(experiment);
    return experiment;
}

Experiment twin_of(const Case& one, std::size_t size) {
    return parse_experiment(one.twin(size), fmt::format("twin of bench case {} {}", one.name, size), ".");
}

}  // namespace pelage::bench
