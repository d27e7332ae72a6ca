// Whole published runs of free cells without chance: their last states.
#include "support/published_check.hpp"
#include "support/shared.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace {

using namespace pelage;

double range(const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return *high - *low;
}

// Where rounding alone moves cells by more than a hundredth of the range, the pattern must be the same as a pattern.
void check_pattern(const test::PublishedCells& published, const Snapshot& state) {
    const std::vector<double> x = published.array("x_0"), y = published.array("y_0");  // nothing moves in these
    const auto conc = published.by_chemical("conc_final");
    for (std::size_t chemical = 0; chemical < conc.size(); ++chemical) {
        INFO(published.experiment().chemicals[chemical].name);
        const auto wanted = static_cast<double>(test::count_features(x, y, conc[chemical]));
        const auto found = static_cast<double>(test::count_features(x, y, state.conc[chemical]));
        CHECK(std::abs(found - wanted) <= 3 + 0.1 * wanted);
        CHECK(test::ks_distance(state.conc[chemical], conc[chemical]) < 0.02);
    }
}

void check_final(const std::string& name, bool chaotic) {
    if (test::shared_missing("golden/pattern_explorer")) return;
    const test::PublishedCells published(name);
    const auto tissue = test::start_published(published.experiment());

    const std::string wrong = test::published_mismatch(published, *tissue, "final");

    CHECK(wrong == "");
    const double noise = published.noise("final") / range(published.array("conc_final"));
    CHECK((noise > 0.01) == chaotic);
    if (chaotic) check_pattern(published, tissue->read());
}

}  // namespace

TEST_CASE("whole run of basic-modulation 04") { check_final("basic-modulation__modulation-04-stripes-to-spots", true); }
TEST_CASE("whole run of basic-reinforcement 09") {
    check_final("basic-reinforcement__reinforcement-09-varying-deviation", false);
}
TEST_CASE("whole run of basic-reinforcement 10") {
    check_final("basic-reinforcement__reinforcement-10-varying-diffusion", false);
}
TEST_CASE("whole run of basic-turing 01") { check_final("basic-turing__turing-01-initial-concentrations", true); }
TEST_CASE("whole run of basic-turing 02") { check_final("basic-turing__turing-02-concentration-variation", false); }
TEST_CASE("whole run of basic-turing 04") { check_final("basic-turing__turing-04-scale-effect", false); }
TEST_CASE("whole run of basic-turing 06") { check_final("basic-turing__turing-06-diffusion-rates-2", false); }
TEST_CASE("whole run of basic-turing 08") { check_final("basic-turing__turing-08-scale-parameter", false); }
TEST_CASE("whole run of the paper's Turing patterns") { check_final("paper__03-turing-patterns", false); }
TEST_CASE("whole run of the paper's Sanderson rings") { check_final("paper__06-sanderson-rings", true); }
