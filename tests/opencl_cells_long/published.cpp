// Whole published growth runs on the device against the float reference, compared every 500 iterations.
#include "support/free_cells.hpp"
#include "support/shared.hpp"

#include <catch2/catch.hpp>

using namespace pelage;

namespace {

void check_whole_run(const std::string& file, std::size_t cells_at_least) {
    if (test::shared_missing(file)) return;
    const auto experiment = test::experiment_file(file);
    const auto expected = test::on_reference(experiment);
    const auto found = test::on_device(experiment);

    test::check_equal_runs(*expected, *found, experiment->last_iteration(), 500);

    CHECK(found->cells() > cells_at_least);
}

}  // namespace

TEST_CASE("the leopard's 14,000 iterations equal the reference's, bit for bit") {
    check_whole_run("pex/paper/25-saturated-leopard.pex", 5000);
}

TEST_CASE("uniform growth's 15,000 iterations equal the reference's, bit for bit") {
    check_whole_run("pex/benchmark/benchmark-02-uniform-growth.pex", 4000);
}

TEST_CASE("the leopard's last state depends neither on the skin nor on interruptions") {
    const std::string file = "pex/paper/25-saturated-leopard.pex";
    if (test::shared_missing(file)) return;
    const auto experiment = test::experiment_file(file);
    const std::uint64_t iterations = experiment->last_iteration();
    const auto run = [&](double skin) {
        CellsOptions options;
        options.skin = skin;
        const auto tissue = test::on_device(experiment, options);
        tissue->advance(iterations);
        return tissue->read();
    };
    const Snapshot expected = run(0.3);

    CHECK(expected.cells() > 5000);
    CHECK(test::difference(expected, run(0.001)) == test::no_difference);
    CHECK(test::difference(expected, run(2.0)) == test::no_difference);

    const auto first = test::on_device(experiment);
    first->advance(7777);
    const auto second = test::on_device(experiment);
    second->write(first->read());
    second->advance(iterations - 7777);
    CHECK(test::difference(expected, second->read()) == test::no_difference);
}
