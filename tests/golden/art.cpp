// The Gray-Scott art that is written as text: what experiments/gray-scott holds against McConnell's program.
#include "core/fields.hpp"
#include "core/prepattern.hpp"
#include "core/space.hpp"
#include "io/drawn.hpp"
#include "language/parse.hpp"
#include "lattice_support.hpp"
#include "reference/backend.hpp"
#include "support/shared.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace {

using namespace pelage;

Experiment art(std::size_t side, const std::string& start, const std::string& bias, const std::string& colours) {
    const std::string text = fmt::format(
        "define parameter F 0.0367\ndefine parameter K 0.0620\n{}include \"gray-scott/chemistry.pex\"\n"
        "create matrix {} {} absorbing\ninclude \"gray-scott/start-{}.pex\"\ninclude \"gray-scott/{}.pex\"\n"
        "include \"gray-scott/colours-{}.pex\"\n",
        bias == "no-bias" ? "" : "define parameter bias 0.005\ndefine parameter segments 20\n", side, side, start, bias,
        colours);
    return parse_experiment(text, "art.pex", PELAGE_SOURCE "/experiments");
}

double largest_difference(const std::vector<double>& found, const std::string& array) {
    return test::difference(found, test::golden("gray_scott/" + array).values).largest;
}

}  // namespace

TEST_CASE("the initial concentration maps are the program's, on both sizes") {
    if (test::shared_missing("golden/gray_scott/gs_init_maps")) return;
    const std::array<std::string, 6> starts{"square", "circle", "three-squares", "line", "triangle", "points"};
    for (std::size_t i = 0; i < starts.size(); ++i) {
        for (const std::size_t side : {256u, 1024u}) {
            INFO(starts[i] << ' ' << side);
            const Snapshot state = initial_state(art(side, starts[i], "no-bias", "grey"), Precision::double_);
            CHECK(largest_difference(state.conc[1], fmt::format("gs_init_maps/B_mode{}_{}", i, side)) == 0.0);
            CHECK(std::ranges::all_of(state.conc[0], [](double a) { return a == 1.0; }));
        }
    }
}

TEST_CASE("the directional biases are the program's, and so is what grows under them") {
    if (test::shared_missing("golden/gray_scott/gs_bias_256")) return;
    const std::array<std::string, 5> biases{"rows", "columns", "diagonals", "radial", "sine"};
    for (std::size_t i = 0; i < biases.size(); ++i) {
        INFO(biases[i]);
        const Experiment experiment = art(256, "square", "bias-" + biases[i], "grey");
        const Lattice lattice = std::get<Lattice>(space_of(experiment));
        const auto fields =
            field_values(experiment, {lattice.columns, lattice.rows, lattice.x, lattice.y}, Precision::double_);
        CHECK(largest_difference(fields.at(0), fmt::format("gs_bias_256/kill_mode{}", i + 1)) < 1e-8);
        const auto backend = reference_backend(Precision::double_);
        const auto tissue = backend->make_tissue(experiment, initial_state(experiment, Precision::double_));
        tissue->advance(300);
        CHECK(largest_difference(tissue->read().conc[1], fmt::format("gs_bias_256/B300_mode{}", i + 1)) < 4e-6);
    }
}

TEST_CASE("the colour modes are the program's") {
    if (test::shared_missing("golden/gray_scott/colour_modes_crop64")) return;
    const auto crop = [](const std::string& name) { return test::golden("gray_scott/colour_modes_crop64/" + name); };
    const std::array<std::string, 6> modes{"default", "grey", "power", "gradient-power", "fire", "ice"};
    const std::vector<double> a = crop("A").values, b = crop("B").values;
    const std::vector<double> da = crop("dA").values, db = crop("dB").values;
    for (std::size_t mode = 0; mode < modes.size(); ++mode) {
        INFO(modes[mode]);
        const Experiment experiment = art(64, "square", "no-bias", modes[mode]);
        Snapshot state = initial_state(experiment, Precision::double_);
        for (std::size_t i = 0; i < experiment.chemicals.size(); ++i) {
            const std::string& name = experiment.chemicals[i].name;
            auto& values = state.conc[i];
            const bool of_a = name == "A" || name == "previous(A)";
            const bool before = name.starts_with("previous");
            for (std::size_t cell = 0; cell < values.size(); ++cell)
                values[cell] = (of_a ? a : b)[cell] - (before ? (of_a ? da : db)[cell] : 0.0);
        }
        const Drawn drawn(experiment, experiment.outputs.at(0), 0, state);
        const NpyArray colours = crop(fmt::format("mode{}", mode));
        const std::size_t channels = colours.values.size() / a.size();
        double largest = 0.0;
        for (std::size_t cell = 0; cell < a.size(); ++cell) {
            for (std::size_t c = 0; c < std::min<std::size_t>(channels, 3); ++c) {
                const auto columns = drawn.columns();
                const double found = std::clamp(columns[std::min(c, columns.size() - 1)][cell], 0.0, 1.0);
                const double wanted = std::clamp(colours.values[cell * channels + c], 0.0, 1.0);
                largest = std::max(largest, std::abs(found - wanted));
            }
        }
        CHECK(largest < 1e-4);
    }
}
