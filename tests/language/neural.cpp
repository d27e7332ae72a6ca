// Networks in the language, numbered chemicals and fields of blobs.
#include "core/error.hpp"
#include "core/fields.hpp"
#include "core/prepattern.hpp"
#include "io/file_bytes.hpp"
#include "io/sha256.hpp"
#include "language/error_case.hpp"
#include "language/lint.hpp"
#include "language/parse.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

using namespace pelage;
using Catch::Matchers::Contains;

namespace {

const std::string networks = PELAGE_SOURCE "/tests/io/networks/";
const std::string eight = "define chemicals x 8 floor none\ncreate matrix 6 5 wrap\n";

Experiment with_networks(const std::string& text, StartPictures pictures = StartPictures::read) {
    return parse_experiment(text, "t.pex", networks, nullptr, pictures);
}

std::string network_message(const std::string& text) {
    try {
        with_networks(text);
    } catch (const Error& error) {
        return error.what();
    }
    return "(none)";
}

}  // namespace

TEST_CASE("chemicals with numbers are defined at once") {
    const Experiment e =
        with_networks("define chemical a\ndefine chemicals x 3 floor none limit 2\ncreate matrix 2 2\n");

    REQUIRE(e.chemicals.size() == 4);
    CHECK(e.chemicals[1].name == "x0");
    CHECK(e.chemicals[3].name == "x2");
    CHECK(e.chemicals[3].bounds.limit == 2.0);
    CHECK(std::isinf(e.chemicals[3].bounds.floor));
    CHECK(e.phases[0].bounds[3].limit == 2.0);
}

TEST_CASE("chemicals with numbers have bounds, and names of their own") {
    CHECK(network_message("define chemical x1\ndefine chemicals x 3\n") ==
          "t.pex:2:18: chemical 'x1' is defined already");
    CHECK_THAT(network_message("define chemicals x 65\n"), Contains("t.pex:1:20:"));
    CHECK_THAT(network_message("define chemical u\ndefine chemicals x 64\n"),
               Contains("t.pex:2:20: 1 chemicals too many; at most 64 are allowed"));
    CHECK_THAT(network_message("define chemicals x 3 floor 2 limit 1\n"), Contains("above its limit"));
    CHECK_THAT(network_message("define chemicals x 3 conc \"a.png\"\n"), Contains("t.pex:1:22:"));
    CHECK_THAT(network_message("define chemicals 3 x\n"), Contains("t.pex:1:20: 'x' is not a whole number"));
}

TEST_CASE("a network reacts with the chemicals that are named, or all") {
    const Experiment all = with_networks(
        "define chemicals x 4\ncreate matrix 6 5 wrap\n"
        "rule always react all neural \"stored.npz\" rate 0.5\n");
    const Neural& neural = std::get<Neural>(all.rules.at(0).action);
    CHECK(neural.species == std::vector<std::size_t>{0, 1, 2, 3});
    CHECK(neural.network->chemicals == 4);
    CHECK(neural.rate == Operand::number(0.5));
    CHECK(neural.diffusion == Operand::number(1.0));

    const Experiment named = with_networks(eight +
                                           "rule if x0 conc > 1 react x7 x0 x2 x1 neural \"protocol2.npy\" "
                                           "diffusion (x0 + 1) rate x3 conc\n");
    const Neural& some = std::get<Neural>(named.rules.at(0).action);
    CHECK(some.species == std::vector<std::size_t>{7, 0, 2, 1});
    CHECK(some.rate == Operand::concentration(3));
    CHECK(some.diffusion.quantity == Quantity::expression);
}

TEST_CASE("a chemical may be called all, or neural") {
    const Experiment e = with_networks(
        "define chemical all\ndefine chemical neural\ncreate matrix 3 3\nrule always react all neural turing alpha 16 "
        "beta "
        "12\n");
    CHECK(std::holds_alternative<React>(e.rules.at(0).action));
}

TEST_CASE("the network's file is among the inputs, also of a run that goes on") {
    const std::string text = "define chemicals x 4\ncreate matrix 6 5\nrule always react all neural \"stored.npz\"\n";
    for (const StartPictures pictures : {StartPictures::read, StartPictures::left_out}) {
        const Experiment e = with_networks(text, pictures);
        REQUIRE(e.inputs.size() == 1);
        CHECK(e.inputs[0].name == "stored.npz");
        CHECK(e.inputs[0].sha256 == sha256(read_file(networks + "stored.npz")));
        CHECK(e.inputs[0].throughout);
        CHECK(std::get<Neural>(e.rules.at(0).action).network != nullptr);
    }
}

TEST_CASE("what a network does not take") {
    CHECK(network_message(eight + "rule always react all neural \"stored.npz\"\n") ==
          "t.pex:3:19: the network takes 4 chemicals; found 8");
    CHECK(network_message(eight + "rule always react x0 x1 x0 x2 neural \"stored.npz\"\n") ==
          "t.pex:3:25: 'x0' is given twice; a network takes different chemicals");
    CHECK_THAT(network_message(eight + "rule always react x0 x9 x1 x2 neural \"stored.npz\"\n"),
               Contains("t.pex:3:22: unknown chemical 'x9'"));
    CHECK_THAT(network_message(eight + "rule always react x0 x1 x2 x3 neural \"none.npz\"\n"),
               Contains("t.pex:3:38: cannot read '") && Contains("none.npz"));
    CHECK_THAT(network_message(eight + "rule always react x0 x1 x2 x3 neural \"calls_system.npy\"\n"),
               Contains("it asks for 'posix.system'"));
    CHECK_THAT(network_message(eight + "rule always react x0 x1 x2 x3 neural \"stored.npz\" speed 1\n"),
               Contains("t.pex:3:51:") && Contains("rate, diffusion"));
    CHECK_THAT(
        network_message("define chemicals x 4\ncreate hex_grid 4 4\nrule always react all neural \"stored.npz\"\n"),
        Contains("t.pex:3:30:") && Contains("lattice"));
    CHECK_THAT(network_message(eight + "rule always react x0 nerual \"stored.npz\"\n"), Contains("'neural'"));
}

TEST_CASE("a network whose diffusion is below 0 is refused, too fast or backward ones are warned of") {
    CHECK(network_message(eight + "rule always react x0 x1 x2 x3 neural \"stored.npz\" diffusion -0.5\n") ==
          "t.pex:3:61: the diffusion -0.5 is below 0; every difference would grow without end");
    const auto warned = [](const std::string& options) {
        Outline outline;
        const Experiment e =
            parse_experiment(eight + "rule always react x0 x1 x2 x3 neural \"stored.npz\" " + options + "\n", "t.pex",
                             networks, &outline);
        std::string all;
        for (const Warning& one : lint(e, outline, e.last_iteration())) {
            if (one.lint != "unused-chemical") all += fmt::format("{}:{} {};", one.line, one.column, one.lint);
        }
        return all;
    };
    CHECK(warned("diffusion 0.375") == "");
    CHECK(warned("rate 0.5 diffusion 4") == "3:60 unstable;");
    CHECK(warned("rate -1 diffusion 0.25") == "3:51 backwards;");
}

TEST_CASE("blobs are round, stand where the seed puts them and go over the edge of a torus") {
    const auto field = [](const std::string& text) {
        const Experiment e = with_networks("define chemical U\n" + text +
                                           "use chemical U conc (f)\nuse seed 5\ncreate matrix 24 20 wrap\n");
        return initial_state(e).conc[0];
    };
    const std::vector<double> one = field("define field f blobs 1 sigma 2\n");
    const auto top = static_cast<std::size_t>(std::max_element(one.begin(), one.end()) - one.begin());
    const std::size_t row = top / 24, column = top % 24;
    CHECK(one[top] == 1.0);
    for (const auto& [right, up] : {std::pair{3, 0}, {0, 3}, {21, 0}, {0, 17}}) {  // -3 is 21 or 17 on the torus
        const std::size_t cell =
            (row + static_cast<std::size_t>(up)) % 20 * 24 + (column + static_cast<std::size_t>(right)) % 24;
        CHECK(one[cell] == Approx(std::exp(-9.0 / 8.0)).epsilon(1e-6));
    }
    CHECK(field("define field f blobs 0 sigma 2\n") == std::vector<double>(480, 0.0));
    const std::vector<double> other = field("define field g blobs 1 sigma 2\ndefine field f blobs 1 sigma 2\n");
    CHECK(other != one);
    double sum = 0.0, single = 0.0;
    for (const double value : field("define field f blobs 9 sigma 2\n")) sum += value;
    for (const double value : one) single += value;
    CHECK(sum == Approx(9 * single).epsilon(1e-6));
}

TEST_CASE("blobs in a volume are round in three dimensions and go through its faces where they are joined") {
    const auto field = [](const std::string& count, const std::string& boundary) {
        return initial_state(with_networks("define chemical U\ndefine field f blobs " + count +
                                           " sigma 1.5\nuse chemical U conc (f)\nuse seed 5\ncreate volume 14 12 10 " +
                                           boundary + "\n"))
            .conc[0];
    };
    for (const bool wrap : {true, false}) {
        const std::vector<double> one = field("1", wrap ? "wrap" : "no-flux");
        const auto top = static_cast<std::size_t>(std::max_element(one.begin(), one.end()) - one.begin());
        CHECK(one[top] == 1.0);
        double worst = 0.0;
        for (std::size_t cell = 0; cell < one.size(); ++cell) {
            double square = 0.0;
            for (const auto& [stride, count] : {std::pair<std::size_t, std::size_t>{1, 14}, {14, 12}, {168, 10}}) {
                const std::size_t a = cell / stride % count, b = top / stride % count, far = a > b ? a - b : b - a;
                const auto d = static_cast<double>(wrap ? std::min(far, count - far) : far);
                square += d * d;
            }
            worst = std::max(worst, std::abs(one[cell] - std::exp(-square / (2 * 1.5 * 1.5))));
        }
        CHECK(worst < 1e-6);
    }
    const std::vector<double> many = field("9", "wrap"), one = field("1", "wrap");
    CHECK(std::accumulate(many.begin(), many.end(), 0.0) ==
          Approx(9 * std::accumulate(one.begin(), one.end(), 0.0)).epsilon(1e-6));
}

TEST_CASE("blobs need a number, a width and a lattice") {
    const std::string u = "define chemical U\n";
    CHECK_THAT(network_message(u + "define field f blobs -1 sigma 2\n"), Contains("t.pex:2:22:"));
    CHECK_THAT(network_message(u + "define field f blobs 3 sigma 0\n"), Contains("t.pex:2:30:"));
    CHECK_THAT(network_message(u + "define field f blobs 3\n"), Contains("sigma"));
    CHECK_THAT(network_message(u + "define field f blobs 3 sigma 1\ncreate hex_grid 4 4\n"), Contains("lattice"));
}
