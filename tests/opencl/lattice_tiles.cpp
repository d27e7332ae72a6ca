// Tiles in local memory: the bits of the reference, whatever their shape and the number of work-items.
#include "busy_lattice.hpp"
#include "lattice_run.hpp"
#include "opencl/lattice/choice.hpp"

using namespace pelage;
using namespace pelage::verify;
using namespace test;

namespace {

OpenclOptions tiled(LatticeCut cut = {}, std::size_t width = 0) {
    OpenclOptions made;
    made.path = Path::tiled;
    made.variants = 1;
    made.width = width;
    made.cut = cut;
    return made;
}

}  // namespace

TEST_CASE("tiled: every shape gives the same bits") {
    struct Shape {
        LatticeCut cut;
        Boundary boundary = Boundary::wrap;
        std::size_t width = 1;
    };
    const auto [cut, boundary, width] =
        GENERATE(Shape{{1, 1, 1, 1}, Boundary::wrap, 1}, Shape{{2, 5, 3, 7}, Boundary::no_flux, 1},
                 Shape{{4, 32, 32, 64}, Boundary::no_flux, 0}, Shape{{8, 16, 64, 128}, Boundary::absorbing, 1},
                 Shape{{5, 100, 2, 3}, Boundary::wrap, 1});
    const Experiment experiment = busy(71, 43, boundary);
    INFO(cut.depth << " deep, " << cut.columns << " x " << cut.rows << ", groups of " << cut.group);

    const Snapshot expected = run(*reference_backend(Precision::single_), experiment, {23});

    const auto device = opencl_backend(tiled(cut, width));
    require_equal(expected, run(*device, experiment, {23}));
    require_equal(expected, run(*device, experiment, {1, 9, 2, 11}));
}

TEST_CASE("tiled: shapes that do not fit local memory are cut down to it") {
    const Experiment experiment = busy(90, 70, Boundary::wrap);
    const Snapshot expected = run(*reference_backend(Precision::double_), experiment, {10});
    OpenclOptions vast = tiled({64, 4096, 4096, 1u << 20}, 1);
    vast.precision = Precision::double_;

    require_equal(expected, run(*opencl_backend(vast), experiment, {10}));
}

TEST_CASE("streamed: every shape gives the same bits") {
    const auto cut =
        GENERATE(LatticeCut{1, 8, 1, 1}, LatticeCut{16, 64, 4, 2}, LatticeCut{32, 512, 16, 1}, LatticeCut{3, 20, 5, 7});
    const Experiment experiment = busy(131, 57, Boundary::no_flux);
    OpenclOptions streamed = tiled(cut, cut.group == 1 ? 0 : 1);
    streamed.path = Path::streamed;

    const Snapshot expected = run(*reference_backend(Precision::single_), experiment, {37});

    require_equal(expected, run(*opencl_backend(streamed), experiment, {37}));
}

TEST_CASE("tiled: a lattice that outgrows its tiles gets larger ones, and the reference's bits") {
    Lab lab = Lab::matrix(88, 88, Boundary::no_flux);
    lab.chemical("U", {5, 3}, {1, 0}, unbounded);
    Rule& growth = lab.rule(Expand{6, 6, true, Distribution::uniform, 1.0, 0.0, 0.0, true});
    growth.from = 8;
    growth.until = 24;
    growth.every = 8;
    const Experiment experiment = lab.time_step(0.05).done();
    const auto cut = [](double cells) {
        Work work;
        work.cells = cells;
        RuleNeeds needs;
        needs.fields = {1, 0};
        return choose(opencl_backend(tiled())->device(), needs, work, tiled()).cut;
    };
    if (cut(88 * 88) == cut(106 * 106)) WARN("SKIPPED: this device has one size of tiles for both");

    for (const std::size_t variants : {0u, 16u}) {
        OpenclOptions options = tiled();
        options.variants = variants;
        require_equal(run(*reference_backend(Precision::single_), experiment, {40}),
                      run(*opencl_backend(options), experiment, {40}));
    }
}

TEST_CASE("tiled: a run says that it took them, and how deep") {
    const Experiment experiment = busy(16, 16, Boundary::wrap);

    const auto tissue = opencl_backend(tiled({4, 8, 8, 4}))->make_tissue(experiment);
    tissue->advance(2);

    REQUIRE(tissue->report().size() == 1);
    CHECK(tissue->report().front() ==
          "from iteration 0: tiled, up to 4 iterations of a tile in local memory; as asked for");
}
