// See check.hpp: what must hold whatever the numbers are, on states drawn from the seed.
#include "core/growable.hpp"
#include "core/growth.hpp"
#include "core/prepattern.hpp"
#include "verify/cases.hpp"
#include "verify/check.hpp"
#include "verify/lab.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>

namespace pelage::verify {

namespace {

constexpr Size size{37, 26};

std::uint64_t iterations_of(const Place& place) { return place.small() ? 5 : 24; }

struct Start {
    Experiment experiment;
    Snapshot state;
};

// The case's experiment on concentrations that are drawn from the seed and exact in a float.
Start start(const std::string& name, std::uint64_t seed) {
    Start made{lattice_case(name).experiment(size), {}};
    made.state = initial_state(made.experiment);
    std::mt19937_64 engine(seed);
    for (auto& plane : made.state.conc) {
        for (double& value : plane) value = 3.0 + static_cast<double>(engine() % 2048) / 1024;
    }
    return made;
}

Snapshot after(Place& place, const Setting& setting, const Start& from) {
    const auto tissue = place.backend(setting).make_tissue(from.experiment, from.state);
    tissue->advance(iterations_of(place));
    return tissue->read();
}

// The cell that takes the place of (row, column).
using Turn = std::size_t (*)(std::size_t row, std::size_t column, std::size_t rows, std::size_t columns);

std::size_t mirrored(std::size_t row, std::size_t column, std::size_t, std::size_t columns) {
    return row * columns + (columns - 1 - column);
}
std::size_t upside_down(std::size_t row, std::size_t column, std::size_t rows, std::size_t columns) {
    return (rows - 1 - row) * columns + column;
}
std::size_t shifted(std::size_t row, std::size_t column, std::size_t rows, std::size_t columns) {
    return (row + 11) % rows * columns + (column + 5) % columns;
}

Snapshot turned(Snapshot state, Turn turn) {
    for (auto& plane : state.conc) {
        const std::vector<double> before = plane;
        for (std::size_t row = 0; row < state.rows; ++row) {
            for (std::size_t column = 0; column < state.columns; ++column) {
                plane[row * state.columns + column] = before[turn(row, column, state.rows, state.columns)];
            }
        }
    }
    return state;
}

// What goes in turned comes out turned, to the bit.
Outcome symmetric(Place& place, const std::string& name, const std::vector<Turn>& turns, std::uint64_t seed) {
    Outcome outcome;
    const Start from = start(name, seed);
    for (const Path path : {Path::step, Path::streamed}) {
        if (path == Path::streamed && !place.full()) continue;
        const Snapshot straight = after(place, {.path = path}, from);
        for (std::size_t i = 0; i < turns.size(); ++i) {
            const Start other{from.experiment, turned(from.state, turns[i])};
            add(outcome.tally, turned(straight, turns[i]), after(place, {.path = path}, other), Precision::single_,
                fmt::format("{}, symmetry {}", name, i + 1));
        }
    }
    conclude(outcome);
    return outcome;
}

// One advance, or many, or one of each state that was read: the same bits.
Outcome splits(Place& place, const std::string& name, std::uint64_t seed) {
    Outcome outcome;
    const Start from = start(name, seed);
    const Snapshot whole = after(place, {}, from);
    std::mt19937_64 engine(seed);
    const std::uint64_t iterations = iterations_of(place);
    for (int attempt = 0; attempt < (place.small() ? 1 : 3); ++attempt) {
        auto tissue = place.backend({}).make_tissue(from.experiment, from.state);
        for (std::uint64_t done = 0; done < iterations;) {
            const std::uint64_t piece = std::min<std::uint64_t>(1 + engine() % 9, iterations - done);
            tissue->advance(piece);
            done += piece;
            if (engine() % 4 != 0) continue;
            const Snapshot middle = tissue->read();
            tissue = place.backend({}).make_tissue(from.experiment, middle);
        }
        add(outcome.tally, whole, tissue->read(), Precision::single_, fmt::format("{}, split {}", name, attempt + 1));
    }
    conclude(outcome);
    return outcome;
}

// Diffusion alone moves what there is and makes none.
Outcome conserves(Place& place, Boundary boundary, std::uint64_t seed) {
    Outcome outcome;
    Lab lab = Lab::matrix(size.columns, size.rows, boundary);
    lab.chemical("U", {4, 1}, {0.2, 0}, unbounded);
    Start from{lab.done(), {}};
    from.state = start("diffusion/nine-point/wrap", seed).state;
    from.state.conc.resize(1);
    from.state.diff.assign(1, std::vector<double>(from.state.cells(), static_cast<double>(0.2f)));
    const auto sum = [](const Snapshot& state) {
        return std::accumulate(state.conc[0].begin(), state.conc[0].end(), 0.0);
    };
    const Snapshot end = after(place, {}, from);
    const double before = sum(from.state);
    outcome.tally.cells_compared = end.cells();
    outcome.tally.max_relative = std::abs(sum(end) - before) / before;
    const double bound = 1e-7 * static_cast<double>(iterations_of(place));
    if (outcome.tally.max_relative > bound) {
        outcome.verdict = Verdict::failed;
        outcome.message =
            fmt::format("the sum of all concentrations changed by {:.3g} of itself; rounding explains {:.3g}",
                        outcome.tally.max_relative, bound);
    } else if (end.conc[0] == from.state.conc[0]) {
        outcome.verdict = Verdict::mistrusted;
        outcome.message = "nothing has spread";
    }
    return outcome;
}

// A cosine along a row shrinks by 1 + 2 D dt (cos k - 1) a step: the eigenvalue of the nine-point stencil.
Outcome decays(Place& place) {
    Outcome outcome;
    constexpr std::size_t waves = 3;
    constexpr double rate = 0.3;
    constexpr double dt = 0.5;
    Lab lab = Lab::matrix(size.columns, size.rows, Boundary::wrap);
    lab.chemical("U", {4, 1}, {rate, 0}, unbounded);
    Start from{lab.time_step(dt).done(), {}};
    from.state = initial_state(from.experiment);
    const double k = 2 * std::numbers::pi * waves / static_cast<double>(size.columns);
    const auto wave = [&](std::size_t cell) { return std::cos(k * static_cast<double>(cell % size.columns)); };
    for (std::size_t cell = 0; cell < from.state.cells(); ++cell) {
        from.state.conc[0][cell] = static_cast<double>(static_cast<float>(wave(cell)));
    }
    const Snapshot end = after(place, {}, from);
    const auto iterations = static_cast<double>(iterations_of(place));
    const double factor = std::pow(1 + 2 * rate * dt * (std::cos(k) - 1), iterations);
    for (std::size_t cell = 0; cell < end.cells(); ++cell) {
        const double error = std::abs(end.conc[0][cell] - factor * wave(cell));
        outcome.tally.max_absolute = std::max(outcome.tally.max_absolute, error);
    }
    outcome.tally.cells_compared = end.cells();
    const double bound = 1e-7 * iterations;
    if (!(outcome.tally.max_absolute <= bound)) {
        outcome.verdict = Verdict::failed;
        outcome.message = fmt::format("a cosine is off its discrete decay by {:.3g}; rounding explains {:.3g}",
                                      outcome.tally.max_absolute, bound);
    }
    return outcome;
}

// Taking out what an expansion put in gives back what was there.
Outcome projects(Place& place, std::uint64_t seed) {
    Outcome outcome;
    const Start from = start("diffusion/nine-point/no-flux", seed);
    std::mt19937_64 engine(seed);
    for (const bool column : {true, false}) {
        const std::size_t lines = column ? size.rows : size.columns;
        const std::size_t places = column ? size.columns : size.rows;
        Insertion insertion{column, {}};
        for (std::size_t i = 0; i < lines; ++i)
            insertion.picks.push_back(static_cast<std::uint32_t>(engine() % places));
        const auto tissue = place.backend({}).make_tissue(from.experiment, from.state);
        growable(*tissue).expand(insertion);
        const Snapshot grown = tissue->read();
        Snapshot back = from.state;
        for (std::size_t cell = 0; cell < back.cells(); ++cell) {
            const std::size_t row = cell / size.columns;
            const std::size_t at = cell % size.columns;
            const std::size_t pick = insertion.picks[column ? row : at];
            const std::size_t grown_row = !column && row > pick ? row + 1 : row;
            const std::size_t grown_at = column && at > pick ? at + 1 : at;
            const std::size_t twin = (grown_row + (!column && row == pick ? 1 : 0)) * grown.columns + grown_at +
                                     (column && at == pick ? 1 : 0);
            for (std::size_t i = 0; i < back.conc.size(); ++i) {
                const double value = grown.conc[i].at(grown_row * grown.columns + grown_at);
                back.conc[i][cell] = grown.conc[i].at(twin) == value ? value : std::nan("");  // the twin is its equal
            }
        }
        add(outcome.tally, from.state, back, Precision::single_, column ? "a column more" : "a row more");
    }
    conclude(outcome);
    return outcome;
}

}  // namespace

std::vector<Check> law_checks(std::uint64_t seed) {
    const auto law = [](const std::string& name, bool quick, std::function<Outcome(Place&)> run) {
        return Check{"laws/" + name, "laws", quick, std::move(run)};
    };
    const auto turns = [=](const std::string& name, bool quick, const std::vector<Turn>& all) {
        const bool shift = all.front() == shifted;
        return law(fmt::format("{}/{}", shift ? "translation" : "mirror", name), quick,
                   [=](Place& place) { return symmetric(place, name, all, seed); });
    };
    const auto split = [=](const std::string& name, bool quick) {
        return law("split/" + name, quick, [=](Place& place) { return splits(place, name, seed); });
    };
    return {turns("diffusion/nine-point/no-flux", true, {mirrored, upside_down}),
            turns("diffusion/sims/absorbing", true, {mirrored, upside_down}),
            turns("diffusion/moore/wrap", true, {mirrored, upside_down}),
            turns("diffusion/five-point/no-flux", true, {mirrored, upside_down}),
            turns("diffusion/nine-point/wrap", true, {shifted}),
            turns("diffusion/published/wrap", true, {shifted}),
            split("rules/draws/fused", true),
            split("rules/restless", false),
            split("growth/wrap", false),
            law("mass/no-flux", true, [=](Place& place) { return conserves(place, Boundary::no_flux, seed); }),
            law("mass/wrap", false, [=](Place& place) { return conserves(place, Boundary::wrap, seed); }),
            law("decay", false, decays),
            law("projection", true, [=](Place& place) { return projects(place, seed); })};
}

}  // namespace pelage::verify
