// The waist: what Tissue does for every backend before the backend's own work.
#include "core/tissue.hpp"
#include "core/growable.hpp"

#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "core/support_experiments.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace pelage;
using Catch::Matchers::Contains;

namespace {

// Writes down what it was asked to do.
class Recorder : public Growable {
public:
    Recorder(const Experiment& experiment, const Snapshot& initial)
        : Growable(std::make_shared<const Experiment>(experiment), initial), state_(initial) {}

    std::vector<std::string> log;

private:
    std::size_t do_cells() const override { return state_.cells(); }
    void do_advance(std::uint64_t first, std::uint64_t count) override {
        log.push_back(fmt::format("advance {} {}", first, count));
    }
    void do_expand(const Insertion& insertion) override {
        log.push_back(fmt::format("{} at {}x{}", insertion.column ? "column" : "row", columns(), rows()));
    }
    void do_resample(const Resampling& to) override {
        log.push_back(fmt::format("{}x{} to {}x{}", columns(), rows(), to.across.places, to.up.places));
    }
    void do_set_rate(std::size_t chemical, double rate) override {
        log.push_back(fmt::format("rate {} {}", chemical, rate));
    }
    Snapshot do_read() const override { return state_; }
    void do_write(const Snapshot& snapshot) override { state_ = snapshot; }
    std::optional<NonFinite> do_non_finite() const override { return std::nullopt; }

    Snapshot state_;
};

Experiment growing() {
    Experiment experiment = test::turing_matrix(6, 4);
    experiment.phases.push_back(experiment.phases.front());
    experiment.phases.back().begin = 7;
    experiment.phases.back().rates[0] = 2.5;
    Rule growth;
    growth.every = 5;
    growth.offset = 1;
    growth.from = 1;
    growth.until = 6;
    growth.action = Expand{1, 1, true, Distribution::uniform, 1, 0, 0, true};
    experiment.rules.push_back(growth);
    return experiment;
}

}  // namespace

TEST_CASE("advance cuts at expansions and phases, wherever it is split") {
    const Experiment experiment = growing();
    const std::vector<std::string> wanted{"advance 0 1",   "row at 6x4",  "column at 6x5", "advance 1 5", "row at 7x5",
                                          "column at 7x6", "advance 6 1", "rate 0 2.5",    "advance 7 3"};

    Recorder whole(experiment, initial_state(experiment));
    whole.advance(10);
    Recorder split(experiment, initial_state(experiment));
    split.advance(1);
    split.advance(0);
    split.advance(5);
    split.advance(4);

    CHECK(whole.log == wanted);
    CHECK(split.log == wanted);
    CHECK(whole.iteration() == 10);
    CHECK(whole.columns() == 8);
    CHECK(whole.rows() == 6);
}

TEST_CASE("an expansion by interpolation is one stretch to the new size") {
    Experiment experiment = growing();
    std::get<Expand>(experiment.rules.back().action).interpolation = Interpolation::bilinear;
    Recorder tissue(experiment, initial_state(experiment));

    tissue.advance(8);

    CHECK(tissue.log == std::vector<std::string>{"advance 0 1", "6x4 to 7x5", "advance 1 5", "7x5 to 8x6",
                                                 "advance 6 1", "rate 0 2.5", "advance 7 1"});
    CHECK(tissue.columns() == 8);
    CHECK(tissue.rows() == 6);
}

TEST_CASE("a state that no run can come to is refused") {
    const Experiment experiment = test::turing_matrix(3, 2);
    const Snapshot good = initial_state(experiment);
    Recorder tissue(experiment, good);
    const auto refused = [&](auto change) {
        Snapshot state = good;
        change(state);
        try {
            tissue.write(state);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("(none)");
    };

    CHECK(refused([](Snapshot& s) { s.iteration = largest_iteration; }) == "(none)");
    CHECK_THAT(refused([](Snapshot& s) { s.iteration = largest_iteration + 1; }), Contains("cannot pass 4294967295"));
    CHECK_THAT(refused([](Snapshot& s) { s.birth[4] = 1; }), Contains("cell 4") && Contains("born at iteration 1"));
    CHECK_THAT(refused([](Snapshot& s) { s.mirrors = {{0, 6}}; }), Contains("cells 0 and 6; cells 0 to 5 exist"));
    CHECK(refused([](Snapshot& s) { s.order = {1, 2, 0}; }) == "(none)");
    CHECK_THAT(refused([](Snapshot& s) {
                   s.order = {0, 2};
               }),
               Contains("cell 2 in it; it has cells 0 to 1, each once"));
    CHECK_THAT(refused([](Snapshot& s) { s.order = {0, 0}; }), Contains("cell 0 twice"));
    CHECK_THAT(refused([](Snapshot& s) { s.order = {0, 1, 2, 3, 4, 5, 6}; }), Contains("it has cells 0 to 5"));
    CHECK_THAT(refused([](Snapshot& s) { s.diff[1][3] = -0.01; }), Contains("rate -0.01 of 'V' in cell 3"));
}

TEST_CASE("expand refuses picks that do not fit") {
    const Experiment experiment = test::turing_matrix(3, 2);
    Recorder tissue(experiment, initial_state(experiment));

    CHECK_THROWS_WITH(growable(tissue).expand({true, {0, 1, 2}}), Contains("needs 2 picks; found 3"));
    CHECK_THROWS_WITH(growable(tissue).expand({true, {0, 3}}), Contains("a pick of 3 lies outside 0..2"));
    CHECK_NOTHROW(growable(tissue).expand({true, {0, 2}}));
}

TEST_CASE("write refuses a state of another shape") {
    const Experiment experiment = test::turing_matrix(3, 2);
    Recorder tissue(experiment, initial_state(experiment));
    Snapshot state = tissue.read();

    state.conc[1].pop_back();

    CHECK_THROWS_WITH(tissue.write(state), Contains("conc has 5 entries; the experiment needs 6"));
}

TEST_CASE("a run cannot pass the last iteration that the random counter can hold") {
    const Experiment experiment = test::turing_matrix(3, 2);
    Recorder tissue(experiment, initial_state(experiment));

    CHECK_THROWS_AS(tissue.advance(largest_iteration + 1), Error);
}
