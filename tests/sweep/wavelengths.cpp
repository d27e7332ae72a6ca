// Patterns have the wavelength that Turing's theory says, over a map of two rates.
#include "csv.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <string>

using test::command;
using test::Folder;
using test::Outcome;
using test::read_all;
using test::rows_of;

namespace {

// Schnakenberg's system, near where patterns begin. U = 1, V = 0.9 is steady.
const std::string schnakenberg =
    "define parameter pace 0.01\ndefine parameter far 0.13\n"
    "define chemical U floor none\ndefine chemical V floor none\nuse seed 5\n"
    "use chemical U conc 1 dev 0.02 diff 0.012\nuse chemical V conc 0.9 diff far\ncreate matrix 128 128 wrap\n"
    "rule always react U by (pace * (0.1 - U + U ^ 2 * V)) V by (pace * (0.9 - U ^ 2 * V))\nstop at 10000\n";

// The larger root of the characteristic polynomial of the system's linear part at the square of a wave number.
double growth(double square, double pace, double far) {
    const double uu = 0.8 * pace - 0.012 * square, uv = pace, vu = -1.8 * pace, vv = -pace - far * square;
    const double half_trace = (uu + vv) / 2;
    return half_trace + std::sqrt(half_trace * half_trace - (uu * vv - uv * vu));
}

double fastest_wavelength(double pace, double far) {
    double best = -1, found = 0;
    for (double wave = 0.2; wave < 1; wave += 1e-3) {
        const double rate = growth(wave * wave, pace, far);
        if (!(rate > best)) continue;
        best = rate;
        found = 2 * std::numbers::pi / wave;
    }
    return found;
}

}  // namespace

TEST_CASE("patterns of a map have the wavelength that grows fastest, to a tenth") {
    const Folder folder;
    const Outcome outcome = command({"sweep", folder.write("map.pex", schnakenberg), "--vary", "pace=0.006:0.012:5",
                                     "--vary", "far=0.12:0.15:5", "--out", folder / "out"});
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const auto rows = rows_of(read_all(folder / "out/sweep.csv"));
    REQUIRE(rows.size() == 25);
    for (const auto& row : rows) {
        const double pace = std::stod(row.at("pace")), far = std::stod(row.at("far"));
        INFO("pace " << pace << ", far " << far);
        CHECK(std::stod(row.at("deviation")) > 0.01);
        CHECK(std::stod(row.at("wavelength")) == Approx(fastest_wavelength(pace, far)).epsilon(0.1));
    }
}
