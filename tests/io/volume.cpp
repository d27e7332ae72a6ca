// Files of volumes: arrays of three dimensions, stacks, slices and projections, checkpoints.
#include "core/error.hpp"
#include "io/checkpoint.hpp"
#include "io/exr.hpp"
#include "io/field.hpp"
#include "io/npy.hpp"
#include "io/projection.hpp"
#include "io/results.hpp"
#include "scratch.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using Catch::Matchers::Contains;
using namespace pelage;
using test::Scratch;

namespace {

// 4 x 3 x 2 cells; U is the cell's number.
Snapshot small_volume() {
    Snapshot state = test::lattice(4, 6);
    state.rows = 3;
    state.layers = 2;
    for (std::size_t cell = 0; cell < state.cells(); ++cell) state.conc[0][cell] = static_cast<double>(cell);
    return state;
}

Experiment of_volume() {
    Experiment experiment = test::experiment();
    experiment.prepattern = {CreateVolume{4, 3, 2, Boundary::no_flux}};
    return experiment;
}

std::vector<double> seen(const Projection& projection) {
    const Snapshot state = small_volume();
    return projected(projection, state, {state.conc[0]}).values.front();
}

}  // namespace

TEST_CASE("a volume's results are arrays of three dimensions, stacks and pictures") {
    const Scratch scratch;
    ResultOptions options;
    options.formats = parse_formats("exr,png,npy,csv,vti");
    const Snapshot state = small_volume();
    const auto files = write_results(scratch.folder(), "final", state, of_volume(), options);
    CHECK(std::ranges::find(files, "final.vti") != files.end());
    const NpyArray array = read_npy(scratch / "final.U.npy");
    CHECK(array.shape == std::vector<std::size_t>{2, 3, 4});
    CHECK(array.values == state.conc[0]);
    const auto stack = read_exr(scratch / "final.exr");
    CHECK(stack.names == std::vector<std::string>{"L0000.U", "L0000.V", "L0001.U", "L0001.V", "Y"});
    CHECK(stack.columns == 4);
    CHECK(stack.rows == 3);
    CHECK(stack.values[2] == std::vector<double>(state.conc[0].begin() + 12, state.conc[0].end()));
    CHECK_THAT(test::get(scratch / "final.csv"), Contains("id,x,y,layer,birth") && Contains("\n12,"));
    CHECK_THAT(test::get(scratch / "final.vti"),
               Contains("WholeExtent=\"0 4 0 3 0 2\"") && Contains("Origin=\"-2 -1.5 -1\""));
}

TEST_CASE("slices are at right angles to each axis, the middle layer is the usual one") {
    using Kind = Projection::Kind;
    CHECK(seen({Kind::slice, Axis::z, 0}) == std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
    CHECK(seen({}) == seen({Kind::slice, Axis::z, 1}));
    CHECK(seen({Kind::slice, Axis::y, 2}) == std::vector<double>{8, 9, 10, 11, 20, 21, 22, 23});
    CHECK(seen({Kind::slice, Axis::x, 3}) == std::vector<double>{3, 7, 11, 15, 19, 23});
    CHECK(projected_size({Kind::slice, Axis::x, 3}, {4, 3, 2}) == std::array<std::size_t, 2>{3, 2});
    CHECK(projected_size({Kind::slice, Axis::y, 2}, {4, 3, 2}) == std::array<std::size_t, 2>{4, 2});
}

TEST_CASE("the largest value along z is seen, and what is no number before all others") {
    Snapshot state = small_volume();
    state.conc[0][13] = std::numeric_limits<double>::quiet_NaN();
    state.conc[0][2] = 99;
    const auto found = projected({Projection::Kind::maximum}, state, {state.conc[0]}).values.front();
    CHECK(found[0] == 12.0);
    CHECK(std::isnan(found[1]));
    CHECK(found[2] == 99.0);
}

TEST_CASE("what is in front covers what lies behind, the more the larger it is") {
    Output output;
    output.colormap = {"gray", {}};
    output.range = {0.0, 1.0};
    Snapshot state = small_volume();
    state.conc[0].assign(24, 0.0);
    const auto pixel = [&](double front, double back) {
        state.conc[0][0] = front;
        state.conc[0][12] = back;
        const Brush brush(output, {state.conc[0]}, {0.0, 1.0});
        return transparent_picture(state, brush, state.conc[0], {0.0, 1.0}).at(0, 2)[0];  // row 0 is the lowest line
    };
    CHECK(pixel(0.0, 0.0) == 0);
    CHECK(pixel(1.0, 0.0) > 64000);  // 1 - exp(-4) of white
    CHECK(pixel(0.0, 1.0) == pixel(1.0, 0.0));
    CHECK(pixel(0.3, 1.0) < pixel(0.0, 1.0));
    CHECK(pixel(0.6, 1.0) < pixel(0.3, 1.0));
}

TEST_CASE("a checkpoint keeps a volume's layers, and older ones have none") {
    const Scratch scratch;
    const CheckpointInfo info{"use seed 7\n", "t.pex", ".", Precision::single_, 1, "reference", "", "0.1.0"};
    write_checkpoint(scratch / "a.checkpoint", small_volume(), info);
    const Snapshot kept = read_checkpoint(scratch / "a.checkpoint").snapshot;
    CHECK(kept.rows == 3);
    CHECK(kept.layers == 2);
    CHECK(kept.conc == small_volume().conc);
    write_checkpoint(scratch / "b.checkpoint", test::lattice(4, 6), info);
    CHECK(read_checkpoint(scratch / "b.checkpoint").snapshot.layers == 0);
}
