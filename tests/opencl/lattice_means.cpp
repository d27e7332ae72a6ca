// Rates between neighbours that are taken once: they follow whatever changes the rates.
#include "core/growable.hpp"
#include "core/lattice.hpp"
#include "lattice_run.hpp"
#include "opencl/lattice/means.hpp"

using namespace pelage;
using namespace pelage::verify;
using namespace test;

namespace {

const Case& uneven_case() {
    const auto& cases = lattice_cases();
    return *std::ranges::find(cases, "rates/uneven/nine-point/absorbing", &Case::name);
}

// Every second line twice.
Insertion every_second(const Tissue& tissue, bool column) {
    Insertion insertion{column, {}};
    const std::size_t picks = column ? tissue.rows() : tissue.columns();
    const std::size_t places = column ? tissue.columns() : tissue.rows();
    for (std::size_t i = 0; i < picks; ++i) insertion.picks.push_back(static_cast<std::uint32_t>((2 * i) % places));
    return insertion;
}

}  // namespace

TEST_CASE("means of rates follow growth, rates set anew and states written") {
    const Case& one = uneven_case();
    const Experiment experiment = one.experiment({37, 23});
    const Snapshot before = first_state(one, experiment);
    const auto expected = reference_backend(Precision::single_)->make_tissue(experiment, before);
    const auto found = opencl_backend()->make_tissue(experiment, before);
    const auto both = [&](const auto& change) {
        change(*expected);
        change(*found);
        require_equal(expected->read(), found->read());
    };

    both([](Tissue& tissue) { tissue.advance(3); });
    both([](Tissue& tissue) { growable(tissue).expand(every_second(tissue, true)); });
    both([](Tissue& tissue) { tissue.advance(3); });
    both([](Tissue& tissue) { growable(tissue).expand(every_second(tissue, false)); });
    both([](Tissue& tissue) { tissue.advance(3); });
    both([&](Tissue& tissue) { tissue.write(before); });
    both([](Tissue& tissue) { tissue.advance(3); });

    Snapshot other = before;
    for (double& rate : other.diff[0]) rate *= 0.5;
    for (double& x : other.polarity_x) x = -x;
    both([&](Tissue& tissue) { tissue.write(other); });
    both([](Tissue& tissue) { tissue.advance(3); });
    REQUIRE(mistrusted(before, expected->read()).empty());
}

TEST_CASE("means of rates are taken only where no rule changes rates or polarity") {
    const Case& one = uneven_case();
    const Experiment experiment = one.experiment({37, 23});
    const LatticePlan plan = lattice_plan(experiment, first_state(one, experiment));
    const Session session(select_device(""), {});
    LatticePlan even = plan;
    for (RateKind& rate : even.rates) rate = RateKind::uniform;
    RuleUse writes;
    writes.rates_written.insert(0);
    RuleUse turns;
    turns.polarizes.insert(0);

    CHECK(means_pay(session, plan, RuleUse{}) == (session.info().type == "cpu"));
    CHECK_FALSE(means_pay(session, even, RuleUse{}));
    CHECK_FALSE(means_pay(session, plan, writes));
    CHECK_FALSE(means_pay(session, plan, turns));
}
