// The hand-written baselines give the reference's bits: otherwise they would be measured for other work.
#include "bench/cases.hpp"
#include "bench/openmp.hpp"
#include "bench/points.hpp"
#include "bench/tissue_tasks.hpp"
#include "core/prepattern.hpp"
#include "language/parse.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <bit>
#include <string>
#include <vector>

using namespace pelage;

namespace {

std::string matrix(const std::string& reaction, std::size_t columns, std::size_t rows, const char* boundary) {
    return fmt::format(
        "define chemical U limit 4.6\ndefine chemical V floor 0.1\ndefine time_step 0.02\nuse seed 5\n"
        "use chemical U conc 4 dev 0.75 diff 5\nuse chemical V conc 0.5 dev 0.5 diff 1.5\n"
        "create matrix {} {} {}\nrule always react U V scale 0.75 {}\n",
        columns, rows, boundary, reaction);
}

// Empty when both have the same bits after `iterations`, in three stretches for the baseline.
std::string compared(bench::Task& expected, bench::Task& found, std::uint64_t iterations,
                     const bench::Outcome& initial) {
    expected.work(iterations);
    found.work(1);
    found.work(iterations / 2);
    found.work(iterations - 1 - iterations / 2);
    return bench::disagreement(initial, expected.outcome(), found.outcome());
}

}  // namespace

TEST_CASE("the OpenMP lattice has the reference's bits at any size and boundary") {
    const std::vector<std::pair<Model, std::string>> models{{model_named("turing"), "turing alpha 16 beta 12"},
                                                            {model_named("gray-scott"), "gray-scott f 0.37 k 0.6"}};
    const std::vector<std::pair<std::size_t, std::size_t>> sizes{{1, 1},  {1, 5},   {7, 1},   {2, 3},
                                                                 {16, 4}, {17, 31}, {65, 33}, {300, 20}};
    for (const auto& [model, text] : models) {
        for (const bool wrap : {true, false}) {
            for (const auto& [columns, rows] : sizes) {
                INFO(text << (wrap ? " wrap " : " no-flux ") << columns << " x " << rows);
                const Experiment experiment =
                    parse_experiment(matrix(text, columns, rows, wrap ? "wrap" : "no-flux"), "test", ".");
                const auto initial = std::make_shared<const Snapshot>(initial_state(experiment));
                const auto reference = bench::reference_task(experiment, initial);
                const auto baseline = bench::openmp_lattice({model, wrap}, experiment, *initial);

                CHECK(compared(*reference, *baseline, 24, bench::outcome_of(*initial)) == "");
            }
        }
    }
}

TEST_CASE("a small spot in an empty field keeps no subnormal numbers, on the baseline as on the reference") {
    const auto& cases = bench::all_cases();
    const auto one = std::ranges::find_if(cases, [](const bench::Case& c) { return c.name == "gray-scott-seed"; });
    REQUIRE(one != cases.end());
    const Experiment experiment = bench::experiment_of(*one, 220);
    const auto initial = std::make_shared<const Snapshot>(initial_state(experiment));
    const auto reference = bench::reference_task(experiment, initial);
    const auto baseline = bench::openmp_lattice(*one->kernel, experiment, *initial);

    CHECK(compared(*reference, *baseline, 300, bench::outcome_of(*initial)) == "");

    const auto subnormal = [](std::uint32_t word) { return (word & 0x7f800000u) == 0 && (word & 0x7fffffffu) != 0; };
    for (const bench::Array& found : baseline->outcome()) CHECK(std::ranges::none_of(found.words, subnormal));
    const auto there = [](std::uint32_t word) { return std::bit_cast<float>(word) > 0.01f; };
    const auto spot = std::ranges::count_if(baseline->outcome()[1].words, there);
    CHECK((spot > 50 && spot < 500));
}

TEST_CASE("the OpenMP volume and mesh have the reference's bits at any size") {
    const std::string numbers =
        "define chemical U limit 4.6\ndefine chemical V floor 0.1\ndefine time_step 0.02\nuse seed 5\n"
        "use chemical U conc 4 dev 0.75 diff 1.5\nuse chemical V conc 0.5 dev 0.5 diff 1\n";
    const auto check = [&](const std::string& rest, const auto& make) {
        INFO(rest);
        const Experiment experiment = parse_experiment(numbers + rest, "test", ".");
        const auto initial = std::make_shared<const Snapshot>(initial_state(experiment));
        const auto reference = bench::reference_task(experiment, initial);
        const auto baseline = make(experiment, *initial);
        CHECK(compared(*reference, *baseline, 24, bench::outcome_of(*initial)) == "");
    };
    for (const char* size : {"1 1 1", "1 5 2", "7 1 3", "17 6 5", "33 3 4"}) {
        check(fmt::format("create volume {} wrap\nrule always react U V scale 0.75 gray-scott f 0.37 k 0.6\n", size),
              bench::openmp_volume);
    }
    for (const char* shape : {"icosphere 0", "icosphere 2", "torus 7 5", "torus 16 8 weights cotangent"})
        check(fmt::format("create {}\nrule always react U V scale 0.75 turing alpha 16 beta 12\n", shape),
              bench::openmp_mesh);
}

TEST_CASE("the OpenMP network has the reference's bits at any size") {
    const auto& cases = bench::all_cases();
    const auto one = std::ranges::find_if(cases, [](const bench::Case& c) { return c.suite == "neural"; });
    REQUIRE(one != cases.end());
    for (const std::size_t side : {3u, 16u, 21u}) {
        INFO(side);
        const Experiment experiment = bench::experiment_of(*one, side);
        const auto initial = std::make_shared<const Snapshot>(initial_state(experiment));
        const auto reference = bench::reference_task(experiment, initial);
        const auto baseline = bench::openmp_network(experiment, *initial);
        CHECK(compared(*reference, *baseline, 5, bench::outcome_of(*initial)) == "");
    }
}

TEST_CASE("the OpenMP cell step has the reference's bits while cells move and lists are renewed") {
    const auto& cases = bench::all_cases();
    const auto one = std::ranges::find_if(cases, [](const bench::Case& c) { return c.name == "tissue"; });
    REQUIRE(one != cases.end());
    for (const std::size_t cells : {1u, 2u, 40u, 1500u}) {
        INFO(cells << " cells");
        std::string text = one->text(cells);
        text.replace(text.find("dev 0.2\n"), 8, "dev 1.5\n");  // they lie on top of each other and must move far
        const Experiment experiment = parse_experiment(text, "test", ".");
        const auto initial = std::make_shared<const Snapshot>(initial_state(experiment));
        const auto reference = bench::reference_task(experiment, initial);
        const auto baseline = bench::openmp_cells(experiment, *initial);

        CHECK(compared(*reference, *baseline, 150, bench::outcome_of(*initial)) == "");

        baseline->restart();
        CHECK(bench::disagreement({}, bench::outcome_of(*initial), baseline->outcome()) == "");
    }
}

TEST_CASE("all searches of the neighbours suite find the same sets") {
    const auto session = std::make_shared<const Session>(select_device(), OpenclOptions{});
    for (const bool shuffled : {false, true}) {
        for (const std::size_t count : {1u, 17u, 3000u}) {
            INFO(count << (shuffled ? " scattered" : " hexagonal"));
            const bench::Points points = bench::make_points(count, shuffled);
            const auto reference = bench::reference_search(points);
            const auto one_thread = bench::nanoflann_search(points, false);
            const auto threads = bench::nanoflann_search(points, true);
            const auto device = bench::opencl_search(session, points);
            for (bench::Task* task : {reference.get(), one_thread.get(), threads.get(), device.get()}) task->work(2);

            const bench::Outcome expected = reference->outcome();

            CHECK((count < 100 || expected[1].words.size() > 5 * count));
            CHECK(bench::disagreement({}, expected, one_thread->outcome()) == "");
            CHECK(bench::disagreement({}, expected, threads->outcome()) == "");
            CHECK(bench::disagreement({}, expected, device->outcome()) == "");
        }
    }
}

TEST_CASE("the filled Gray-Scott case stays filled, and the spot of the other one neither grows nor goes") {
    const auto share = [](const char* name, std::size_t side, std::uint64_t iterations) {
        const auto& cases = bench::all_cases();
        const auto one = std::ranges::find_if(cases, [&](const bench::Case& c) { return c.name == name; });
        const Experiment experiment = bench::experiment_of(*one, side);
        const auto baseline = bench::openmp_lattice(*one->kernel, experiment, initial_state(experiment));
        baseline->work(iterations);
        const auto there = [](std::uint32_t word) { return std::bit_cast<float>(word) > 0.05f; };
        const auto words = baseline->outcome()[1].words;
        return static_cast<double>(std::ranges::count_if(words, there)) / static_cast<double>(words.size());
    };
    for (const std::uint64_t iterations : {2'000u, 8'000u}) {
        CHECK(share("gray-scott", 64, iterations) > 0.5);
        CHECK(share("gray-scott-seed", 64, iterations) * 64 * 64 == Approx(109).margin(15));
    }
}
