// Lengths and times in a .vti are those of the theory of diffusion.
#include "core/prepattern.hpp"
#include "io/vtk.hpp"
#include "language/parse.hpp"
#include "reference/backend.hpp"
#include "scratch.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

using namespace pelage;
using test::Scratch;

namespace {

double number_after(const std::string& text, const std::string& mark) {
    const auto at = text.find(mark);
    REQUIRE(at != std::string::npos);
    return std::stod(text.substr(at + mark.size()));
}

// Half the distance from the highest to the lowest value.
double amplitude(const Snapshot& state) {
    const auto [low, high] = std::minmax_element(state.conc[0].begin(), state.conc[0].end());
    return (*high - *low) / 2;
}

struct Case {
    const char* cells;
    double diffusivity;  // squares of the unit of length in a unit of time, where the rate is 1
};

}  // namespace

TEST_CASE("a wave dies away as its length and the time in a .vti say") {
    const Scratch scratch;
    const auto [cells, diffusivity] =
        GENERATE(Case{"create matrix 64 5 wrap", 1.0}, Case{"define stencil moore\ncreate matrix 64 5 wrap", 3.0},
                 Case{"define stencil five-point\ncreate matrix 64 5 wrap", 1.0},
                 Case{"define stencil sims\ncreate matrix 64 5 wrap", 0.3}, Case{"create sqr_grid 64 5 wrap", 3.0});
    const auto experiment =
        parse_experiment(std::string("define chemical U floor none\nuse chemical U diff 0.5\n") + cells +
                             "\nphase \"slow\" 200\ndefine time_step 0.05\nphase \"quick\" 100\ndefine time_step 0.1\n",
                         "wave.pex", "");
    const auto backend = reference_backend(Precision::double_);
    auto start = initial_state(experiment);
    for (std::size_t i = 0; i < start.cells(); ++i)
        start.conc[0][i] = std::cos(2 * std::numbers::pi * static_cast<double>(i % 64) / 64);
    const auto tissue = backend->make_tissue(experiment, start);
    tissue->advance(300);
    const auto end = tissue->read();

    write_vti(scratch / "end.vti", end, experiment, Precision::double_);
    const auto text = test::get(scratch / "end.vti");
    const double length = 64 * number_after(text, "Spacing=\"");
    const double time = number_after(text, "format=\"ascii\">");  // the first field is TimeValue
    const double wave_number = 2 * std::numbers::pi / length;

    CHECK(time == Approx(20));
    CHECK(std::log(amplitude(start) / amplitude(end)) ==
          Approx(0.5 * diffusivity * wave_number * wave_number * time).epsilon(0.005));
}
