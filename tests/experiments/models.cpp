// The library of models: each against something that is known of it.
#include "core/prepattern.hpp"
#include "core/space.hpp"
#include "language/parse.hpp"
#include "reference/backend.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

using namespace pelage;

namespace {

using Pair = std::array<double, 2>;

Experiment model(const std::string& name, std::size_t columns, std::size_t rows, std::vector<Setting> settings = {}) {
    Experiment experiment = parse_experiment_file(PELAGE_SOURCE "/experiments/models/" + name + ".pex", nullptr,
                                                  StartPictures::read, settings);
    resize_lattice(experiment, columns, rows);
    return experiment;
}

double parameter(const Experiment& experiment, const std::string& name) {
    const auto found = std::ranges::find(experiment.parameters, name, &Parameter::name);
    REQUIRE(found != experiment.parameters.end());
    return found->value;
}

// Runs in double from a state whose concentrations in column c are those of at(c), one a chemical.
struct Run {
    Run(const Experiment& experiment, const std::function<std::vector<double>(std::size_t)>& at)
        : before(initial_state(experiment, Precision::double_)) {
        for (std::size_t cell = 0; cell < before.cells(); ++cell) {
            const std::vector<double> values = at(cell % before.columns);
            for (std::size_t chemical = 0; chemical < values.size(); ++chemical)
                before.conc[chemical][cell] = values[chemical];
        }
        tissue = reference_backend(Precision::double_)->make_tissue(experiment, before);
    }
    Snapshot after(std::uint64_t iterations) {
        tissue->advance(iterations);
        return tissue->read();
    }
    Snapshot before;
    std::unique_ptr<Tissue> tissue;
};

constexpr std::size_t wide = 32;

double wave(std::size_t column, std::size_t waves) {
    return std::cos(2 * std::numbers::pi * static_cast<double>(waves * column) / wide);
}

// What the laplacian makes of a wave along rows, in a torus of `wide` columns.
double eigenvalue(std::size_t waves) {
    return 2 * (std::cos(2 * std::numbers::pi * static_cast<double>(waves) / wide) - 1);
}

// How much of the wave is in the first row.
double amplitude(const std::vector<double>& values, std::size_t waves) {
    double sum = 0.0;
    for (std::size_t column = 0; column < wide; ++column) sum += values[column] * wave(column, waves);
    return 2 * sum / wide;
}

// A homogeneous state of two chemicals that stays as it is, found by Newton's method, and the matrix of its linear
// part.
struct Linear {
    Pair point{};
    double uu = 0, uv = 0, vu = 0, vv = 0;
};

Linear linear_part(const std::function<Pair(Pair)>& rates, Pair guess) {
    Linear found{guess};
    for (int step = 0; step < 60; ++step) {
        const double h = 1e-6;
        const auto [u, v] = found.point;
        const Pair f = rates(found.point);
        const auto slope = [&](Pair up, Pair down, std::size_t which) {
            return (rates(up)[which] - rates(down)[which]) / (2 * h);
        };
        found.uu = slope({u + h, v}, {u - h, v}, 0);
        found.uv = slope({u, v + h}, {u, v - h}, 0);
        found.vu = slope({u + h, v}, {u - h, v}, 1);
        found.vv = slope({u, v + h}, {u, v - h}, 1);
        const double det = found.uu * found.vv - found.uv * found.vu;
        found.point[0] -= (found.vv * f[0] - found.uv * f[1]) / det;
        found.point[1] -= (found.uu * f[1] - found.vu * f[0]) / det;
    }
    return found;
}

// A small wave of both chemicals grows or decays as the dispersion relation says.
void check_dispersion(const std::string& name, const std::function<Pair(Pair)>& rates, Pair guess, std::size_t waves,
                      std::vector<Setting> settings = {}) {
    INFO(name);
    Experiment experiment = model(name, wide, 4, std::move(settings));
    const Linear linear = linear_part(rates, guess);
    const Snapshot start = initial_state(experiment, Precision::double_);
    const double spread = eigenvalue(waves);
    const double a = linear.uu + start.diff[0][0] * spread, d = linear.vv + start.diff[1][0] * spread;
    const double half_trace = (a + d) / 2, det = a * d - linear.uv * linear.vu;
    const double root = half_trace * half_trace - det;
    REQUIRE(root > 0);  // else the wave oscillates
    const double growth = half_trace + std::sqrt(root);
    const Pair direction{linear.uv, growth - a};
    const double small = 1e-6;
    Run run(experiment, [&](std::size_t column) {
        const double one = small * wave(column, waves);
        return std::vector{linear.point[0] + one * direction[0], linear.point[1] + one * direction[1]};
    });
    const std::uint64_t steps = 100;
    const double ratio = amplitude(run.after(steps).conc[0], waves) / (small * direction[0]);
    const double dt = experiment.phases[0].time_step;
    CHECK(ratio == Approx(std::pow(1 + dt * growth, static_cast<double>(steps))).epsilon(2e-3));
}

double total(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

// Where the first row falls below `level`, between cells.
double front(const std::vector<double>& values, std::size_t columns, double level) {
    for (std::size_t c = columns - 1; c-- > 0;) {
        if (values[c] >= level && values[c + 1] < level)
            return static_cast<double>(c) + (values[c] - level) / (values[c] - values[c + 1]);
    }
    return 0.0;
}

double front_speed(const Experiment& experiment, std::uint64_t from, std::uint64_t to) {
    Run run(experiment, [](std::size_t column) { return std::vector{column < 20 ? 1.0 : 0.0, 0.0}; });
    const std::size_t columns = run.before.columns;
    const double first = front(run.after(from).conc[0], columns, 0.5);
    const double second = front(run.after(to - from).conc[0], columns, 0.5);
    return (second - first) / (static_cast<double>(to - from) * experiment.phases[0].time_step);
}

}  // namespace

TEST_CASE("heat: a wave decays by its factor, exactly") {
    const Experiment experiment = model("heat", wide, 4);
    Run run(experiment, [](std::size_t column) { return std::vector{wave(column, 3)}; });
    const double factor = 1 + parameter(experiment, "kappa") * eigenvalue(3);
    CHECK(amplitude(run.after(40).conc[0], 3) == Approx(std::pow(factor, 40)).epsilon(1e-10));
}

TEST_CASE("wave: a standing wave oscillates with the frequency of its dispersion relation") {
    const Experiment experiment = model("wave", wide, 4);
    Run run(experiment, [](std::size_t column) { return std::vector{wave(column, 2), wave(column, 2)}; });
    const double c = parameter(experiment, "speed");
    const double omega = std::acos(1 + c * c * eigenvalue(2) / 2);
    CHECK(amplitude(run.after(150).conc[0], 2) ==
          Approx(std::cos(150.5 * omega) / std::cos(omega / 2)).epsilon(1e-8).margin(1e-10));
}

TEST_CASE("models with two chemicals: small waves grow as the dispersion relation says") {
    check_dispersion(
        "schnakenberg",
        [](Pair x) {
            return Pair{0.1 - x[0] + x[0] * x[0] * x[1], 0.9 - x[0] * x[0] * x[1]};
        },
        {1, 0.9}, 3);
    check_dispersion(
        "brusselator",
        [](Pair x) {
            return Pair{3 - 10 * x[0] + x[0] * x[0] * x[1], 9 * x[0] - x[0] * x[0] * x[1]};
        },
        {3, 3}, 6);
    check_dispersion(
        "lengyel-epstein",
        [](Pair x) {
            const double uv = x[0] * x[1] / (1 + x[0] * x[0]);
            return Pair{12 - x[0] - 4 * uv, 20 * 0.35 * (x[0] - uv)};
        },
        {2.4, 6.76}, 4);
    for (const double saturation : {0.0, 0.2}) {
        check_dispersion(
            saturation == 0.0 ? "gierer-meinhardt" : "meinhardt-stripes",
            [&](Pair x) {
                const double aa = x[0] * x[0];
                return Pair{0.02 + aa / (x[1] * (1 + saturation * aa)) - x[0], 1.5 * (aa - x[1])};
            },
            {1, 1}, 3);
    }
    check_dispersion(
        "fitzhugh-nagumo-labyrinth",
        [](Pair x) {
            return Pair{x[0] - x[0] * x[0] * x[0] - x[1], 0.05 * (x[0] - 2 * x[1] + 0.1)};
        },
        {-0.8, -0.35}, 1);
    check_dispersion("bard-lauder",
                     [](Pair x) {
                         return Pair{0.0625 * (16 - x[0] * x[1]), 0.0625 * (x[0] * x[1] - x[1] - 12)};
                     },
                     {4, 4}, 5, {{"uneven", "0"}});
}

TEST_CASE("Swift-Hohenberg: a small wave grows with the distance from the onset, less its detuning") {
    const Experiment experiment = model("swift-hohenberg", wide, 4);
    const double length = parameter(experiment, "length"), r = parameter(experiment, "r");
    const std::size_t waves = 4;
    const double w = length * length * eigenvalue(waves);
    Run run(experiment, [&](std::size_t column) {
        return std::vector{1e-6 * wave(column, waves), 1e-6 * w * wave(column, waves)};
    });
    const double first = amplitude(run.after(200).conc[0], waves);
    const double second = amplitude(run.after(400).conc[0], waves);
    const double rate = std::log(second / first) / (400 * experiment.phases[0].time_step);
    CHECK(rate == Approx(r - (1 + w) * (1 + w)).epsilon(0.02).margin(1e-3));
}

TEST_CASE("Cahn-Hilliard: what there is of each phase stays, and the energy falls") {
    const Experiment experiment = model("cahn-hilliard", 24, 20, {{"mean", "0.2"}});
    const Snapshot start = initial_state(experiment, Precision::double_);
    const auto tissue = reference_backend(Precision::double_)->make_tissue(experiment, start);
    tissue->advance(500);
    const Snapshot after = tissue->read();
    CHECK(total(after.conc[0]) == Approx(total(start.conc[0])).epsilon(1e-10));
    const auto energy = [](const Snapshot& state) {
        double sum = 0;
        for (const double u : state.conc[0]) sum += (u * u - 1) * (u * u - 1) / 4;
        return sum;
    };
    CHECK(energy(after) < 0.9 * energy(start));
}

TEST_CASE("Ginzburg-Landau: the homogeneous state turns with frequency -c3") {
    const Experiment experiment = model("ginzburg-landau", 8, 8);
    Run run(experiment, [](std::size_t) { return std::vector{1.0, 0.0}; });
    const Snapshot after = run.after(50);
    const double phase = std::atan2(after.conc[1][0], after.conc[0][0]);
    CHECK(phase == Approx(-parameter(experiment, "c3") * 50 * experiment.phases[0].time_step).epsilon(0.03));
}

TEST_CASE("fronts of Barkley's and Nagumo's media have the speed of the cubic") {
    Experiment barkley = model("barkley", 240, 3, {{"eps", "0.1"}});
    std::get<Formula>(barkley.rules.at(0).action).parts.pop_back();  // the speed is that without recovery
    const double a = parameter(barkley, "a"), b = parameter(barkley, "b");
    CHECK(front_speed(barkley, 400, 1200) == Approx(std::sqrt(5.0 / 0.2) * (1 - 2 * b / a)).epsilon(0.12));
    const Experiment pulse = model("fitzhugh-nagumo-pulse", 240, 3, {{"eps", "0.001"}});
    CHECK(front_speed(pulse, 150, 400) == Approx(std::sqrt(0.5) * (1 - 2 * 0.1)).epsilon(0.07));
}

TEST_CASE("states that stay: three species in balance, the Oregonator at rest") {
    const Experiment species = model("lotka-volterra-cyclic", 8, 8);
    const double balance = 1 / (1 + parameter(species, "alpha") + parameter(species, "beta"));
    Run run(species, [&](std::size_t) { return std::vector(3, balance); });
    const Snapshot after = run.after(100);
    for (const auto& values : after.conc) CHECK(values[5] == Approx(balance).epsilon(1e-12));

    const Experiment oregonator = model("oregonator", 8, 8);
    const double f = parameter(oregonator, "f"), q = parameter(oregonator, "q");
    // u (1 - u) (u + q) = f u (u - q), for u = v
    const double p = f + q - 1;
    const double rest = (-p + std::sqrt(p * p + 4 * q * (1 + f))) / 2;
    Run at_rest(oregonator, [&](std::size_t) { return std::vector{rest, rest}; });
    CHECK(at_rest.after(500).conc[0][3] == Approx(rest).epsilon(1e-9));
}

TEST_CASE("Kobayashi's crystal: every bit of it gives its latent heat") {
    const Experiment experiment = model("kobayashi-crystal", 40, 40);
    const Snapshot start = initial_state(experiment, Precision::double_);
    const auto tissue = reference_backend(Precision::double_)->make_tissue(experiment, start);
    tissue->advance(200);
    const Snapshot after = tissue->read();
    const double grown = total(after.conc[0]) - total(start.conc[0]);
    REQUIRE(grown > 20);
    CHECK(total(after.conc[1]) == Approx(parameter(experiment, "latent") * grown).epsilon(1e-6));
}
