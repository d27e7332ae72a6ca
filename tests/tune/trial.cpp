// Candidates put to the test: wrong ones, ones that throw, and this device's own.
#include "tune/trial.hpp"

#include "core/error.hpp"
#include "lattices.hpp"
#include "reference/backend.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>

using namespace pelage;
using namespace pelage::tune;
using test::spots;

namespace {

const Candidate streamed{Path::streamed, 0, {4, 0, 0, 0}};

Problem small_problem() { return make_problem(spots(24, 16), 0, 5000, 1'000'000); }

Subject on_reference(const OpenclOptions& options, const Experiment& experiment, const Snapshot& start) {
    return {reference_backend(options.precision)->make_tissue(experiment, start), [] {}};
}

// A streamed candidate begins with one bit of one value wrong: not the last one, which diffusion might round away.
Subject with_a_flipped_bit(const OpenclOptions& options, const Experiment& experiment, Snapshot start) {
    double& value = start.conc[1][77];
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
    if (options.path == Path::streamed) value = static_cast<double>(std::bit_cast<float>(bits ^ 0x100u));
    return on_reference(options, experiment, start);
}

}  // namespace

TEST_CASE("a candidate with the bits of single steps is timed") {
    TestStand stand(small_problem(), {}, on_reference, 0.002);

    const Trial trial = stand.try_out(streamed);

    CHECK(trial.verdict == Verdict::good);
    CHECK(trial.updates_per_second > 1000);
    CHECK(trial.message.empty());
}

TEST_CASE("a candidate with one wrong bit is struck out and never timed") {
    TestStand stand(small_problem(), {}, with_a_flipped_bit, 0.002);

    const Trial trial = stand.try_out(streamed);

    CHECK(trial.verdict == Verdict::wrong);
    CHECK(struck_out(trial.verdict));
    CHECK(trial.updates_per_second == 0);
    CHECK_THAT(trial.message, Catch::Contains("conc[") && Catch::Contains("expected"));
}

TEST_CASE("where bits are given up for speed, a small difference is none") {
    OpenclOptions options;
    options.fast = true;
    TestStand stand(small_problem(), options, with_a_flipped_bit, 0.002);

    CHECK(stand.try_out(streamed).verdict == Verdict::good);
}

TEST_CASE("even where bits are given up for speed, a large difference is wrong") {
    OpenclOptions options;
    options.fast = true;
    const Begin far_off = [](const OpenclOptions& own, const Experiment& experiment, Snapshot start) {
        if (own.path == Path::streamed) start.conc[1][77] += 1;
        return on_reference(own, experiment, start);
    };
    TestStand stand(small_problem(), options, far_off, 0.002);

    CHECK(stand.try_out(streamed).verdict == Verdict::wrong);
}

TEST_CASE("a candidate that throws is struck out with the reason") {
    const Begin refusing = [](const OpenclOptions& options, const Experiment& experiment, const Snapshot& start) {
        if (options.path == Path::streamed) throw Error("no local memory is left");
        return on_reference(options, experiment, start);
    };
    TestStand stand(small_problem(), {}, refusing, 0.002);

    const Trial trial = stand.try_out(streamed);

    CHECK(trial.verdict == Verdict::refused);
    CHECK(trial.message == "no local memory is left");
    CHECK(stand.try_out({}).verdict == Verdict::good);
}

TEST_CASE("what is timed goes back to its start before the rules' last iteration") {
    std::uint64_t latest = 0;
    const Begin watched = [&](const OpenclOptions& options, const Experiment& experiment, const Snapshot& start) {
        Subject subject = on_reference(options, experiment, start);
        subject.finish = [&latest, tissue = subject.tissue.get()] { latest = std::max(latest, tissue->iteration()); };
        return subject;
    };
    TestStand stand(make_problem(spots(3, 2), 500, 600, 1000), {}, watched, 0.02);

    const Trial trial = stand.try_out(streamed);

    CHECK(trial.verdict == Verdict::good);
    CHECK(latest > 1400);
    CHECK(latest <= 1500);
}

TEST_CASE("on this device no quick candidate is wrong, and those that are good are what they say") {
    const DeviceInfo device = select_device();
    OpenclOptions options;
    options.device = std::to_string(device.index);
    TestStand stand(make_problem(spots(90, 70), 0, 5000, 1'000'000), options, begin_on_device, 0.002);

    for (const Candidate& candidate : candidates(device, Precision::single_, Effort::quick)) {
        const Trial trial = stand.try_out(candidate);
        INFO(candidate.text() << ": " << trial.message);
        CHECK((trial.verdict == Verdict::good || trial.verdict == Verdict::unfit));
        CHECK_FALSE(trial.how.empty());
        if (candidate.path == Path::streamed) CHECK(trial.verdict == Verdict::good);
    }
}

TEST_CASE("a trial survives the trip through JSON") {
    for (const Verdict verdict :
         {Verdict::good, Verdict::unfit, Verdict::wrong, Verdict::refused, Verdict::crashed, Verdict::hung}) {
        const Trial trial{streamed, verdict, 1.5e9, "fused, streamed", "why"};

        const Trial back = trial_from_json(to_json(trial));

        CHECK(back.candidate == trial.candidate);
        CHECK(back.verdict == verdict);
        CHECK(back.updates_per_second == trial.updates_per_second);
        CHECK(back.how == trial.how);
        CHECK(back.message == trial.message);
    }
    auto json = to_json(Trial{});
    json["verdict"] = "splendid";
    CHECK_THROWS_AS(trial_from_json(json), Error);
}
