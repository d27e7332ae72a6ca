// Charges of different sizes.
#include "aggregate/direct_sum.hpp"
#include "core/aggregate.hpp"
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "opencl/backend.hpp"
#include "reference/backend.hpp"
#include "verify/compare.hpp"

#include <fmt/ranges.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace pelage;

namespace {

Experiment sized(const std::string& size, const std::string& more = {}) {
    return parse_experiment(
        "define chemical order\ndefine chemical phi\ndefine chemical mass\nuse seed 5\ncreate charges 121 117\n"
        "set cells where (COLUMN == 60 and ROW == 60) chemical order conc 1\n" +
            more + "rule always aggregate order phi eta 3 " + size + "\n",
        "sized.pex", ".");
}

std::vector<std::unique_ptr<Tissue>> on_both(const Experiment& experiment) {
    std::vector<std::unique_ptr<Tissue>> tissues;
    tissues.push_back(reference_backend(Precision::single_)->make_tissue(experiment));
    for (const Path path : {Path::step, Path::shared}) {
        OpenclOptions options;
        options.path = path;
        tissues.push_back(opencl_backend(options)->make_tissue(experiment));
        options.work_group = 8;
        tissues.push_back(opencl_backend(options)->make_tissue(experiment));
    }
    return tissues;
}

// Off from sum (1 - size / r) in double, at most, over all sizes.
double error_a_size(const Snapshot& state) {
    const Front front(state, 0);
    double largest = 0.0, sizes = 0.0;
    for (const double size : state.conc[2]) sizes += size;
    for (const std::uint32_t site : front.places()) {
        if (site == no_site) continue;
        const double potential = test::sum_over_charges(state, front, site, [&](std::uint32_t charge, double distance) {
            return 1.0 - state.conc[2][charge] / distance;
        });
        largest = std::max(largest, std::abs(potential - state.conc[1][site]));
    }
    return largest / sizes;
}

std::string refusal(const Experiment& experiment) {
    try {
        reference_backend(Precision::single_)->make_tissue(experiment)->advance(3);
    } catch (const std::exception& error) {
        return error.what();
    }
    return "(none)";
}

}  // namespace

TEST_CASE("charges of different sizes take the same sites on both backends, in one go and from what was kept") {
    for (const char* size :
         {"size mass (0.5 + 3 * RANDOM)", "size mass (1 + mod(ITERATION, 50)) towards 40 0 strength 9",
          "size mass (0.001 + RANDOM ^ 8)", "size mass 1000"}) {
        const Experiment experiment =
            sized(size, "set cells where (COLUMN == 9 and ROW == 80) chemical order conc 2 chemical mass conc 30\n");
        INFO(size);
        const auto tissues = on_both(experiment);
        for (const std::uint64_t steps : std::vector<std::uint64_t>{0, 1, 2, 300, 400}) {
            for (const auto& tissue : tissues) {
                tissue->advance(steps);
                const auto differing = verify::differences(tissues.front()->read(), tissue->read());
                INFO("iteration " << tissue->iteration() << ": " << fmt::format("{}", fmt::join(differing, "; ")));
                REQUIRE(differing.empty());
            }
        }
        const Snapshot kept = tissues.front()->read();
        CHECK(kept.conc[2][60 * 121 + 60] == 1.0);
        CHECK(kept.conc[2][80 * 121 + 9] == 30.0);
        CHECK(error_a_size(kept) < 0x1p-21);
        tissues.front()->advance(100);
        for (const auto& tissue : tissues) {
            tissue->write(kept);
            tissue->advance(100);
            CHECK(verify::differences(tissues.front()->read(), tissue->read()).size() <= 1);
        }
    }
}

TEST_CASE("charges of the size 1 grow as those without a size do") {
    for (std::size_t i = 0; i < 3; ++i) {
        const auto plain = std::move(on_both(sized(""))[i]);
        const auto one = std::move(on_both(sized("size mass 1"))[i]);
        plain->advance(700);
        one->advance(700);
        CHECK(plain->read().conc[0] == one->read().conc[0]);
        CHECK(plain->read().conc[1] == one->read().conc[1]);
    }
}

TEST_CASE("each new charge has the size that its rule gives in that iteration") {
    const auto tissue = reference_backend(Precision::single_)->make_tissue(sized("size mass (2 + ITERATION / 4)"));
    tissue->advance(200);
    const Snapshot state = tissue->read();
    for (std::size_t site = 0; site < state.cells(); ++site) {
        const double order = state.conc[0][site];
        if (order > 1.0) CHECK(state.conc[2][site] == 2.0 + (order - 2.0) / 4.0);
        if (order == 0.0) CHECK(state.conc[2][site] == 0.0);
    }
    const auto bare = reference_backend(Precision::double_)->make_tissue(sized("size mass RANDOM"));
    const auto summed = opencl_backend()->make_tissue(sized("size mass (0 + RANDOM)"));
    bare->advance(100);
    summed->advance(100);
    CHECK(bare->read().conc == summed->read().conc);
    const auto drawn = reference_backend(Precision::single_)->make_tissue(sized("size mass (1 + RANDOM)"));
    drawn->advance(600);
    std::vector<double> sizes;
    const Snapshot after = drawn->read();
    double sum = 0.0;
    for (std::size_t site = 0; site < after.cells(); ++site) {
        if (after.conc[0][site] <= 1.0) continue;
        sizes.push_back(after.conc[2][site]);
        sum += sizes.back();
    }
    std::ranges::sort(sizes);
    CHECK(sizes.size() == 600);
    CHECK(std::ranges::adjacent_find(sizes) == sizes.end());
    CHECK(sizes.front() < 1.03);
    CHECK(sizes.back() > 1.97);
    CHECK(std::abs(sum / 600.0 - 1.5) < 0.06);  // 5 standard deviations
}

TEST_CASE("a large charge keeps growth away from itself") {
    const auto reach = [](const std::string& mass) {
        const auto tissue = reference_backend(Precision::single_)
                                ->make_tissue(sized("size mass 1",
                                                    "set cells where (COLUMN == 75 and ROW == 60) chemical "
                                                    "order conc 1 chemical mass conc " +
                                                        mass + "\n"));
        tissue->advance(300);
        const Snapshot state = tissue->read();
        double right = 0.0;
        for (std::size_t site = 0; site < state.cells(); ++site) {
            if (state.conc[0][site] > 2.0 && state.x[site] > state.x[75]) right += 1.0;
        }
        return right;
    };
    CHECK(reach("1") > 30.0);
    CHECK(reach("1000") < 0.5 * reach("1"));
}

TEST_CASE("sizes that mean nothing are refused") {
    CHECK_THAT(
        refusal(sized("size mass (1 - ITERATION)")),
        Catch::Contains("sized.pex:7: size of 'aggregate' is 0 at iteration 1; it must be a number from 0.001 to "
                        "1000"));
    CHECK_THAT(
        refusal(sized("size mass 1", "set cell 7 chemical order conc 1 chemical mass conc 2000\n")),
        Catch::Contains("the charge in column 7, row 0 starts with the size 2000; it must be 0, which stands for "
                        "1, or a number from 0.001 to 1000"));
    CHECK_THROWS_WITH(sized("radius RANDOM"), Catch::Contains("the same for all sites"));
}
