// The search: its order, its budget, what it remembers, under a clock of the test's own.
#include "tune/search.hpp"

#include <catch2/catch.hpp>

#include <map>

using namespace pelage;
using namespace pelage::tune;

namespace {

Candidate of_depth(std::size_t depth) { return {Path::streamed, 16, {depth, 0, 0, 0}}; }

// Candidates that take `seconds` each and reach the speeds one gives them.
class Bench {
public:
    double seconds = 0.5;
    std::map<std::size_t, double> speeds;     // by depth; 1e9 where none is given
    std::map<std::size_t, double> durations;  // by depth; `seconds` where none is given
    std::map<std::size_t, Verdict> verdicts;
    std::vector<Candidate> tried;
    std::size_t kept = 0;
    double now = 100;

    Hands hands() {
        Hands hands;
        hands.clock = [this] { return now; };
        hands.keep = [this](const Record&) { ++kept; };
        hands.announce = [](std::size_t, std::size_t, const Candidate&) {};
        hands.try_out = [this](const Candidate& candidate, double running, double whole) {
            return take(candidate, std::min(running, whole));
        };
        return hands;
    }

private:
    std::optional<Trial> take(const Candidate& candidate, double limit) {
        const std::size_t depth = candidate.cut.depth;
        tried.push_back(candidate);
        const double wanted = durations.contains(depth) ? durations.at(depth) : seconds;
        now += std::min(wanted, limit);
        if (wanted > limit) return {};
        Trial trial;
        trial.candidate = candidate;
        if (verdicts.contains(depth)) trial.verdict = verdicts.at(depth);
        if (trial.verdict == Verdict::good) trial.updates_per_second = speeds.contains(depth) ? speeds.at(depth) : 1e9;
        return trial;
    }
};

const std::vector<Candidate> list{{}, of_depth(8), of_depth(16), of_depth(24), of_depth(32)};

}  // namespace

TEST_CASE("an exhaustive search tries all, and the best again in turn with the defaults") {
    Bench bench;
    bench.speeds = {{16, 2e9}};
    Record record;

    search(record, list, Effort::exhaustive, {}, bench.hands());

    CHECK(record.complete);
    CHECK(record.exhaustive);
    CHECK(record.trials.size() == list.size());
    CHECK(record.best() == of_depth(16));
    REQUIRE(bench.tried.size() == list.size() + 2 * 4);
    CHECK(bench.tried[5] == Candidate{});
    CHECK(bench.tried[6] == of_depth(16));
    CHECK(bench.kept == bench.tried.size() + 1);
}

TEST_CASE("where nothing is faster, nothing is timed again") {
    Bench bench;
    Record record;

    search(record, list, Effort::exhaustive, {}, bench.hands());

    CHECK(bench.tried.size() == list.size());
    CHECK(record.best() == Candidate{});
}

TEST_CASE("defaults that were only disturbed the first time win after all") {
    Bench bench;
    bench.speeds = {{0, 0.5e9}};
    Record record;
    Hands hands = bench.hands();
    hands.announce = [&](std::size_t, std::size_t, const Candidate&) {
        if (bench.tried.size() == list.size()) bench.speeds[0] = 1e9;
    };

    search(record, list, Effort::exhaustive, {}, hands);

    CHECK(record.best() == Candidate{});
}

TEST_CASE("a quick search ends within its budget, whatever candidates take") {
    Bench bench;
    bench.seconds = GENERATE(0.1, 0.7, 1.9, 4.9, 30.0);
    bench.speeds = {{8, 3e9}};
    std::vector<Candidate> many = list;
    for (std::size_t depth = 40; depth < 400; depth += 8) many.push_back(of_depth(depth));
    Record record;

    search(record, many, Effort::quick, quick_budget, bench.hands());

    CHECK(bench.now - 100 <= quick_budget.whole + 1e-9);
    CHECK(record.complete == (bench.seconds < 5));
    CHECK_FALSE(record.exhaustive);
}

TEST_CASE("what the budget cut off is not struck out") {
    Bench bench;
    bench.durations = {{16, 60.0}};
    Record record;

    search(record, list, Effort::quick, quick_budget, bench.hands());

    CHECK(record.trials.size() == 2);
    CHECK(record.find(of_depth(16)) == nullptr);
}

TEST_CASE("what hangs is struck out, and the others are tried") {
    Bench bench;
    bench.durations = {{16, 60.0}};
    Record record;

    search(record, list, Effort::exhaustive, {}, bench.hands());

    REQUIRE(record.find(of_depth(16)) != nullptr);
    CHECK(record.find(of_depth(16))->verdict == Verdict::hung);
    CHECK_THAT(record.find(of_depth(16))->message, Catch::Contains("20 seconds"));
    CHECK(record.trials.size() == list.size());
}

TEST_CASE("what hung under a shorter limit is tried again under a longer one, by an exhaustive search") {
    Bench bench;
    bench.durations = {{16, 10.0}};
    Budget impatient;
    impatient.candidate = 2;
    Record record;
    search(record, list, Effort::exhaustive, impatient, bench.hands());
    REQUIRE(record.find(of_depth(16))->verdict == Verdict::hung);
    CHECK(record.find(of_depth(16))->limit == 2);
    CHECK_FALSE(has_more_patience(impatient, record));
    CHECK(has_more_patience({}, record));

    search(record, list, Effort::exhaustive, impatient, bench.hands());
    CHECK(record.find(of_depth(16))->verdict == Verdict::hung);
    search(record, list, Effort::exhaustive, {}, bench.hands());
    CHECK(record.find(of_depth(16))->verdict == Verdict::good);
}

TEST_CASE("a search that was interrupted goes on where it was, and does not touch what was struck out") {
    Bench bench;
    Record record;
    record.exhaustive = true;
    record.put({{}, Verdict::good, 1e9, "", ""});
    record.put({of_depth(8), Verdict::crashed, 0, "", "signal 11"});

    search(record, list, Effort::exhaustive, {}, bench.hands());

    CHECK(bench.tried == std::vector<Candidate>{of_depth(16), of_depth(24), of_depth(32)});
    CHECK(record.find(of_depth(8))->verdict == Verdict::crashed);
}

TEST_CASE("an exhaustive search after a quick one times all anew but what was struck out") {
    Bench bench;
    Record record;
    record.complete = true;
    record.put({{}, Verdict::good, 5e9, "", ""});
    record.put({of_depth(8), Verdict::wrong, 0, "", "bits"});

    search(record, list, Effort::exhaustive, {}, bench.hands());

    CHECK(record.find({})->updates_per_second == 1e9);
    CHECK(record.find(of_depth(8))->verdict == Verdict::wrong);
    CHECK(bench.tried.size() == 4);
}

TEST_CASE("a candidate that crashes when it is timed again is struck out") {
    Bench bench;
    bench.speeds = {{16, 2e9}};
    Record record;
    Hands hands = bench.hands();
    hands.announce = [&](std::size_t, std::size_t, const Candidate&) {
        if (bench.tried.size() == list.size()) bench.verdicts = {{16, Verdict::crashed}};
    };

    search(record, list, Effort::exhaustive, {}, hands);

    CHECK(record.find(of_depth(16))->verdict == Verdict::crashed);
    CHECK(record.best() == Candidate{});
}
