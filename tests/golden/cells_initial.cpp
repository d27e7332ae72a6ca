// Free cells of the published program before the first iteration: number for number.
#include "core/prepattern.hpp"
#include "core/space.hpp"
#include "support/published_cells.hpp"
#include "support/shared.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace pelage;

std::size_t unequal(const std::vector<double>& found, const std::vector<double>& published) {
    std::size_t count = found.size() == published.size() ? 0 : 1;
    for (std::size_t i = 0; i < std::min(found.size(), published.size()); ++i)
        count += found[i] == published[i] ? 0 : 1;
    return count;
}

template <class V>
std::vector<double> doubles(const std::vector<V>& values) {
    return {values.begin(), values.end()};
}

void check_initial(const test::PublishedCells& published) {
    INFO(published.name());
    const Experiment& experiment = published.experiment();

    const Snapshot state = initial_state(experiment);

    CHECK(std::holds_alternative<FreeCells>(space_of(experiment)));
    CHECK(unequal(state.x, published.array("x_0")) == 0);
    CHECK(unequal(state.y, published.array("y_0")) == 0);
    CHECK(unequal(state.polarity_x, published.array("px_0")) == 0);
    CHECK(unequal(state.polarity_y, published.array("py_0")) == 0);
    CHECK(unequal(doubles(state.birth), published.array("birth_0")) == 0);
    CHECK(unequal(doubles(state.fixed), published.array("fixed_0")) == 0);
    const auto conc = published.by_chemical("conc_0"), diff = published.by_chemical("diff_0");
    for (std::size_t chemical = 0; chemical < experiment.chemicals.size(); ++chemical) {
        CHECK(unequal(state.conc[chemical], conc[chemical]) == 0);
        CHECK(unequal(state.diff[chemical], diff[chemical]) == 0);
    }
}

}  // namespace

TEST_CASE("every published tissue of free cells starts number for number") {
    if (test::shared_missing("golden/pattern_explorer")) return;
    const std::vector<std::string> names = test::published_cells();
    REQUIRE(names.size() >= 24);

    for (const std::string& name : names) check_initial(test::PublishedCells(name));
}
