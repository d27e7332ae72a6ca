// The planes that wait for the range of all snapshots.
#include "app/reel.hpp"
#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

using namespace pelage;
using app::Reel;
using app::SharedRanges;

namespace {

const std::string lattice = "define chemical U\ndefine chemical V\ncreate matrix 3 2\n";
const std::string cells = "define chemical U\ncreate hex_grid 3 2\noutput U\n";

Snapshot state(const Experiment& experiment, std::uint64_t iteration, double value) {
    Snapshot state = initial_state(experiment);
    state.iteration = iteration;
    for (auto& one : state.conc) one.assign(state.cells(), value);
    state.conc[0][0] = 0;
    return state;
}

// Iterations of the states that are drawn anew, and the range of the first output for all of them.
std::vector<std::uint64_t> redrawn(Reel& reel, ValueRange& range) {
    std::vector<std::uint64_t> all;
    reel.redraw([&](const Snapshot& state, const SharedRanges& ranges, const auto&) {
        all.push_back(state.iteration);
        range = ranges.at(0).value();
        CHECK(state.conc[0].back() == static_cast<double>(state.iteration));
    });
    return all;
}

Snapshot as_its_iteration(const Experiment& experiment, std::uint64_t iteration) {
    return state(experiment, iteration, static_cast<double>(iteration));
}

}  // namespace

TEST_CASE("pictures drawn before the range was known are drawn anew, once") {
    const test::Folder folder;
    const std::string text = GENERATE(lattice + "output U\noutput V range 0 1\noutput U normal 1\n", cells);
    const Experiment experiment = parse_experiment(text, "t.pex", "");
    Reel reel(folder.path(), experiment, "one", std::nullopt);

    for (const std::uint64_t iteration : {1u, 5u, 3u, 5u}) {
        const SharedRanges now = reel.keep(as_its_iteration(experiment, iteration));
        CHECK(now.at(0)->high == (iteration == 1 ? 1 : 5));
        if (now.size() > 1) CHECK_FALSE(now[1].has_value());
        if (now.size() > 1) CHECK_FALSE(now[2].has_value());
    }
    ValueRange range;
    CHECK(redrawn(reel, range) == std::vector<std::uint64_t>{1});
    CHECK(range == ValueRange{0, 5});
    CHECK(redrawn(reel, range).empty());
    CHECK(test::names_in(folder.path()).size() == 1);
    reel.discard();
    CHECK(test::names_in(folder.path()).empty());
}

TEST_CASE("a resumed run knows the states before it, and no later ones or those of other runs") {
    const test::Folder folder;
    const Experiment experiment = parse_experiment(lattice, "t.pex", "");
    {
        Reel first(folder.path(), experiment, "one", std::nullopt);
        for (const std::uint64_t iteration : {10u, 20u, 90u}) first.keep(as_its_iteration(experiment, iteration));
    }
    ValueRange range;
    SECTION("the same run") {
        Reel second(folder.path(), experiment, "one", 20);
        second.keep(as_its_iteration(experiment, 30));
        CHECK(redrawn(second, range) == std::vector<std::uint64_t>{10, 20});
        CHECK(range == ValueRange{0, 30});
    }
    SECTION("cut off in the middle of a state") {
        const auto file = folder / ".pelage-reel";
        std::filesystem::resize_file(file, std::filesystem::file_size(file) - 7);
        Reel second(folder.path(), experiment, "one", 95);
        second.keep(as_its_iteration(experiment, 99));
        CHECK(redrawn(second, range) == std::vector<std::uint64_t>{10, 20});
    }
    SECTION("another run, and no resumed one") {
        const bool resumed = GENERATE(false, true);
        Reel second(folder.path(), experiment, resumed ? "two" : "one", resumed ? std::optional(20ul) : std::nullopt);
        second.keep(as_its_iteration(experiment, 30));
        CHECK(redrawn(second, range).empty());
    }
}

TEST_CASE("a reel knows which pictures it can draw anew") {
    const test::Folder folder;
    const Experiment experiment = parse_experiment(lattice + "output U\n", "t.pex", "");
    const Experiment own = parse_experiment(lattice + "output U range each\n", "t.pex", "");
    Reel reel(folder.path(), experiment, "one", std::nullopt);
    (void)reel.keep(as_its_iteration(experiment, 4));

    CHECK(reel.can_redraw(4));
    CHECK_FALSE(reel.can_redraw(5));
    CHECK(Reel(folder.path(), own, "one", std::nullopt).can_redraw(5));
}

TEST_CASE("what an expression draws is kept as it was, whatever it reads") {
    const test::Folder folder;
    const std::string drawn = "output (U + AGE) as old\noutput rgb (U) (U) (U)\noutput V\n";
    const Experiment experiment = parse_experiment(lattice + drawn, "t.pex", "");
    {
        Reel reel(folder.path(), experiment, "one", std::nullopt);
        CHECK(reel.keep(as_its_iteration(experiment, 4)).at(0) == ValueRange{4, 8});
    }
    Reel reel(folder.path(), experiment, "one", 4);
    const SharedRanges ranges = reel.keep(as_its_iteration(experiment, 40));
    CHECK(ranges.at(0) == ValueRange{4, 80});
    CHECK_FALSE(ranges.at(1).has_value());

    std::size_t count = 0;
    reel.redraw([&](const Snapshot& state, const SharedRanges&, const app::OutputValues& values) {
        ++count;
        CHECK(values.at(0) == std::vector<double>{4, 8, 8, 8, 8, 8});
        CHECK_FALSE(values.at(2).has_value());
        CHECK(state.conc[1].back() == 4.0);
    });
    CHECK(count == 1);
}

TEST_CASE("without an output that shares its range nothing is kept") {
    const test::Folder folder;
    const std::string own = "output U range 0 1\noutput V range each\noutput V normal 2\n";
    const Experiment experiment = parse_experiment(lattice + own, "t.pex", "");
    Reel reel(folder.path(), experiment, "one", std::nullopt);

    const SharedRanges ranges = reel.keep(as_its_iteration(experiment, 4));

    CHECK(ranges == SharedRanges(3));
    CHECK(test::names_in(folder.path()).empty());
}

TEST_CASE("a folder that cannot be written to is named") {
    const Experiment experiment = parse_experiment(lattice, "t.pex", "");
    Reel reel("/proc", experiment, "one", std::nullopt);

    CHECK_THROWS_WITH(reel.keep(as_its_iteration(experiment, 4)), Catch::Contains("/proc/.pelage-reel"));
}
