// Whole published runs of growing tissues: by statistics, with draws of our own.
#include "core/neighbours.hpp"
#include "core/searching.hpp"
#include "support/published_check.hpp"
#include "support/shared.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <future>
#include <map>
#include <numeric>

namespace {

using namespace pelage;

struct Grown {  // what is measured of a grown tissue
    std::vector<double> x, y, neighbours;
    std::vector<std::vector<double>> conc;
    std::map<std::uint64_t, double> population;  // at fifths of the run
    SearchStatistics search;                     // of spatial sorting, once in 100 iterations, while it grows
};

Grown grow(const Experiment& experiment, std::uint64_t iterations) {
    const auto tissue = test::start_published(experiment);
    const std::size_t first = tissue->cells();
    Grown grown;
    while (tissue->iteration() < iterations) {
        tissue->advance(100);
        if (tissue->iteration() % (iterations / 5) == 0) {
            grown.population[tissue->iteration()] = static_cast<double>(tissue->cells());
        }
        const auto search = search_statistics(*tissue);
        if (search && tissue->cells() > first) grown.search += *search;
    }
    Snapshot state = tissue->read();
    grown.x = std::move(state.x);
    grown.y = std::move(state.y);
    grown.neighbours.assign(state.neighbours.begin(), state.neighbours.end());
    grown.conc = std::move(state.conc);
    return grown;
}

Grown theirs(const test::PublishedCells& published) {
    Grown tissue{published.array("x_final"),
                 published.array("y_final"),
                 published.array("neighbors_final"),
                 published.by_chemical("conc_final"),
                 {},
                 {}};
    const std::uint64_t fifth = published.iterations() / 5;
    for (std::uint64_t at = fifth; at <= published.iterations(); at += fifth) {
        tissue.population[at] = static_cast<double>(published.population().at(at));
    }
    return tissue;
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double deviation(const std::vector<double>& values) {
    const double middle = mean(values);
    double sum = 0.0;
    for (const double value : values) sum += (value - middle) * (value - middle);
    return std::sqrt(sum / (static_cast<double>(values.size()) - 1));
}

bool flat(const std::vector<double>& values) { return deviation(values) < 1e-4 * std::abs(mean(values)); }

double mean_feature_size(const Grown& tissue, std::size_t chemical) {
    return static_cast<double>(tissue.x.size()) /
           static_cast<double>(test::count_features(tissue.x, tissue.y, tissue.conc[chemical]));
}

std::map<std::string, double> measure(const Grown& tissue) {
    const std::vector<double> near = test::nearest_distances(tissue.x, tissue.y);
    std::map<std::string, double> found{
        {"mean of neighbours", mean(tissue.neighbours)},
        {"deviation of neighbours", deviation(tissue.neighbours)},
        {"share with six neighbours",
         static_cast<double>(std::ranges::count(tissue.neighbours, 6.0)) / static_cast<double>(tissue.x.size())},
        {"nearest distance, lower decile", test::quantile(near, 0.1)},
        {"nearest distance, median", test::quantile(near, 0.5)},
        {"nearest distance, upper decile", test::quantile(near, 0.9)},
    };
    for (const auto& [iteration, cells] : tissue.population) found["cells at " + std::to_string(iteration)] = cells;
    for (std::size_t chemical = 0; chemical < tissue.conc.size(); ++chemical) {
        const std::string of = " of chemical " + std::to_string(chemical);
        found["mean" + of] = mean(tissue.conc[chemical]);
        found["deviation" + of] = deviation(tissue.conc[chemical]);
        found["cells a feature" + of] = mean_feature_size(tissue, chemical);
    }
    return found;
}

// Their tissue is one more draw from the distribution of ours: it lies within t * s * sqrt(1 + 1 / n) of the mean of n
// with probability 0.999 where the measure is normally distributed (Student's t, two-sided).
void check_one_of(const std::vector<std::map<std::string, double>>& ours, const std::map<std::string, double>& theirs) {
    REQUIRE(ours.size() == 6);
    const double t = 6.869;  // 5 degrees of freedom
    for (const auto& [what, value] : theirs) {
        std::vector<double> sample;
        for (const auto& run : ours) sample.push_back(run.at(what));
        INFO(what << ": theirs " << value << ", ours " << mean(sample) << " +- " << deviation(sample));
        CHECK(std::abs(value - mean(sample)) <= t * deviation(sample) * std::sqrt(1 + 1.0 / 6) + 1e-9);
    }
}

SearchStatistics check_growth(const std::string& name) {
    const test::PublishedCells published(name);
    std::vector<std::future<Grown>> runs;
    for (std::int64_t seed = 101; seed <= 106; ++seed) {
        runs.push_back(std::async(std::launch::async, grow, published.reseeded(seed), published.iterations()));
    }
    std::vector<std::map<std::string, double>> ours;
    SearchStatistics search;
    for (std::future<Grown>& run : runs) {
        const Grown grown = run.get();
        ours.push_back(measure(grown));
        search += grown.search;
    }
    check_one_of(ours, measure(theirs(published)));
    return search;
}

// One run of ours beside theirs. Spread of the population: pure birth with `rate` a cell and iteration for `iterations`
// would give n e (e - 1), e = exp(rate * iterations), as the variance; the division limit only narrows it.
void check_beside(const std::string& name, double rate, double iterations) {
    if (test::shared_missing("golden/pattern_explorer")) return;
    const test::PublishedCells published(name);
    const Grown wanted = theirs(published);

    const Grown found = grow(published.experiment(), published.iterations());

    const double growth = std::exp(rate * iterations);
    const double spread = std::sqrt(2.0 * 1813 * growth * (growth - 1));
    CHECK(std::abs(static_cast<double>(found.x.size()) - static_cast<double>(wanted.x.size())) < 4 * spread);
    CHECK(test::total_variation(found.neighbours, wanted.neighbours) < 0.06);
    for (std::size_t chemical = 0; chemical < found.conc.size(); ++chemical) {
        INFO("chemical " << chemical);
        if (flat(wanted.conc[chemical])) {
            CHECK(mean(found.conc[chemical]) == Approx(mean(wanted.conc[chemical])).epsilon(1e-3));
        } else {
            CHECK(test::ks_distance(found.conc[chemical], wanted.conc[chemical]) < 0.08);
        }
    }
}

}  // namespace

TEST_CASE("uniform growth: six tissues of ours and theirs are of one kind") {
    if (test::shared_missing("golden/pattern_explorer")) return;
    check_growth("growth-uniform__uniform-01-standard-turing");
}

TEST_CASE("border growth: six tissues of ours and theirs are of one kind") {
    if (test::shared_missing("golden/pattern_explorer")) return;
    check_growth("paper__10-border-growth");
}

TEST_CASE("leopard by spatial sorting: six tissues of ours and theirs are of one kind, and few neighbours are missed") {
    if (test::shared_missing("golden/pattern_explorer")) return;

    const SearchStatistics search = check_growth("paper__25-saturated-leopard");

    CHECK(search.iterations > 500);
    CHECK(search.miss_rate() < 0.005);  // 2017 paper, section 4
    CHECK(search.neighbours_missed > 0);
}

TEST_CASE("centre growth: the published population, which knows no chance, and a tissue like theirs") {
    if (test::shared_missing("golden/pattern_explorer")) return;
    const test::PublishedCells published("paper__09-center-growth");
    const Grown wanted = theirs(published);
    const auto tissue = test::start_published(published.experiment());

    std::size_t wrong = 0;
    for (const auto& [iteration, cells] : published.population()) {
        tissue->advance(iteration - tissue->iteration());
        wrong += tissue->cells() == cells ? 0 : 1;
    }
    const Snapshot state = tissue->read();

    CHECK(published.population().size() > 100);
    CHECK(wrong == 0);
    const std::vector<double> neighbours(state.neighbours.begin(), state.neighbours.end());
    CHECK(test::total_variation(neighbours, wanted.neighbours) < 0.06);
    CHECK(test::ks_distance(state.conc[0], wanted.conc[0]) < 0.08);
    CHECK(test::ks_distance(state.conc[1], wanted.conc[1]) < 0.08);
}

TEST_CASE("uniform growth with reinforcement beside theirs") {
    check_beside("growth-uniform__uniform-03-reinforcement", 1e-4, 8000);
}
TEST_CASE("uniform growth from random seeds beside theirs") {
    check_beside("growth-uniform__uniform-04-random-seeds", 1e-4, 8000);
}
TEST_CASE("uniform growth with a prepattern beside theirs") {
    check_beside("growth-uniform__uniform-06-prepattern", 1e-4, 8000);
}
TEST_CASE("the benchmark's uniform growth beside theirs") {
    check_beside("benchmark__benchmark-02-uniform-growth", 1e-4, 13000);
}
TEST_CASE("uniform growth with frozen chemicals beside theirs") {
    check_beside("paper__13-frozen-chemicals", 1e-4, 13000);
}
