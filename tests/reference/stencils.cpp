// Every stencil with every boundary on a 5 x 5 lattice, worked by hand: a one in a corner, a one in the middle.
#include "lab.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>

namespace {

using namespace pelage;
using Picture = std::array<double, 25>;  // bottom row first

struct Worked {
    const char* name;
    Boundary boundary;
    Picture corner;  // what a one in the bottom left corner makes of a field of zeros, less that one
};

constexpr Picture nine_middle{0, 0, 0,   0, 0,  //
                              0, 1, 4,   1, 0,  //
                              0, 4, -20, 4, 0,  //
                              0, 1, 4,   1, 0,  //
                              0, 0, 0,   0, 0};
constexpr Picture moore_middle{0, 0, 0,  0, 0,  //
                               0, 1, 1,  1, 0,  //
                               0, 1, -8, 1, 0,  //
                               0, 1, 1,  1, 0,  //
                               0, 0, 0,  0, 0};
constexpr Picture five_middle{0, 0, 0,  0, 0,  //
                              0, 0, 1,  0, 0,  //
                              0, 1, -4, 1, 0,  //
                              0, 0, 1,  0, 0,  //
                              0, 0, 0,  0, 0};

// The edge element repeats itself outward: the corner sees itself three times outside, its neighbours see it twice.
constexpr Picture nine_no_flux{-11, 5, 0, 0, 0,  //
                               5,   1, 0, 0, 0,  //
                               0,   0, 0, 0, 0,  //
                               0,   0, 0, 0, 0,  //
                               0,   0, 0, 0, 0};
constexpr Picture nine_wrap{-20, 4, 0, 0, 4,  //
                            4,   1, 0, 0, 1,  //
                            0,   0, 0, 0, 0,  //
                            0,   0, 0, 0, 0,  //
                            4,   1, 0, 0, 1};
constexpr Picture nine_absorbing{-20, 4, 0, 0, 0,  //
                                 4,   1, 0, 0, 0,  //
                                 0,   0, 0, 0, 0,  //
                                 0,   0, 0, 0, 0,  //
                                 0,   0, 0, 0, 0};
constexpr Picture moore_no_flux{-5, 2, 0, 0, 0,  //
                                2,  1, 0, 0, 0,  //
                                0,  0, 0, 0, 0,  //
                                0,  0, 0, 0, 0,  //
                                0,  0, 0, 0, 0};
constexpr Picture moore_wrap{-8, 1, 0, 0, 1,  //
                             1,  1, 0, 0, 1,  //
                             0,  0, 0, 0, 0,  //
                             0,  0, 0, 0, 0,  //
                             1,  1, 0, 0, 1};
constexpr Picture moore_absorbing{-8, 1, 0, 0, 0,  //
                                  1,  1, 0, 0, 0,  //
                                  0,  0, 0, 0, 0,  //
                                  0,  0, 0, 0, 0,  //
                                  0,  0, 0, 0, 0};
// The published grid leaves absent neighbours out.
constexpr Picture moore_absent{-3, 1, 0, 0, 0,  //
                               1,  1, 0, 0, 0,  //
                               0,  0, 0, 0, 0,  //
                               0,  0, 0, 0, 0,  //
                               0,  0, 0, 0, 0};
constexpr Picture five_no_flux{-2, 1, 0, 0, 0,  //
                               1,  0, 0, 0, 0,  //
                               0,  0, 0, 0, 0,  //
                               0,  0, 0, 0, 0,  //
                               0,  0, 0, 0, 0};
constexpr Picture five_wrap{-4, 1, 0, 0, 1,  //
                            1,  0, 0, 0, 0,  //
                            0,  0, 0, 0, 0,  //
                            0,  0, 0, 0, 0,  //
                            1,  0, 0, 0, 0};
constexpr Picture five_absorbing{-4, 1, 0, 0, 0,  //
                                 1,  0, 0, 0, 0,  //
                                 0,  0, 0, 0, 0,  //
                                 0,  0, 0, 0, 0,  //
                                 0,  0, 0, 0, 0};

// What one iteration adds to a field of zeros with a one in `cell`; rate times time step makes the weights whole.
Picture response(const Experiment& experiment, double rate, std::size_t cell, Precision precision) {
    Snapshot state = test::blank(experiment);
    state.diff[0].assign(25, rate);
    state.conc[0][cell] = 1.0;
    const Snapshot next = test::after(1, experiment, state, precision);
    Picture added{};
    for (std::size_t i = 0; i < 25; ++i) added[i] = next.conc[0][i] - state.conc[0][i];
    return added;
}

void check(const Experiment& experiment, double rate, const Picture& corner, const Picture& middle) {
    for (const Precision precision : {Precision::single_, Precision::double_}) {
        Picture turned = corner;
        std::reverse(turned.begin(), turned.end());
        CHECK(response(experiment, rate, 0, precision) == corner);
        CHECK(response(experiment, rate, 24, precision) == turned);
        CHECK(response(experiment, rate, 12, precision) == middle);
    }
}

void check_all(Stencil stencil, double rate, const Picture& middle, const std::array<Worked, 3>& cases) {
    for (const Worked& worked : cases) {
        INFO(worked.name);
        check(test::matrix(5, 5, worked.boundary, stencil), rate, worked.corner, middle);
    }
}

constexpr std::array<Worked, 3> nine_cases{Worked{"no flux", Boundary::no_flux, nine_no_flux},
                                           Worked{"wrap", Boundary::wrap, nine_wrap},
                                           Worked{"absorbing", Boundary::absorbing, nine_absorbing}};
constexpr std::array<Worked, 3> moore_cases{Worked{"no flux", Boundary::no_flux, moore_no_flux},
                                            Worked{"wrap", Boundary::wrap, moore_wrap},
                                            Worked{"absorbing", Boundary::absorbing, moore_absorbing}};
constexpr std::array<Worked, 3> five_cases{Worked{"no flux", Boundary::no_flux, five_no_flux},
                                           Worked{"wrap", Boundary::wrap, five_wrap},
                                           Worked{"absorbing", Boundary::absorbing, five_absorbing}};

}  // namespace

TEST_CASE("the nine-point stencil on 5 x 5") { check_all(Stencil::nine_point, 6.0, nine_middle, nine_cases); }
TEST_CASE("the stencil of Sims on 5 x 5") { check_all(Stencil::sims, 20.0, nine_middle, nine_cases); }
TEST_CASE("the Moore stencil on 5 x 5") { check_all(Stencil::moore, 1.0, moore_middle, moore_cases); }
TEST_CASE("the five-point stencil on 5 x 5") { check_all(Stencil::five_point, 1.0, five_middle, five_cases); }

TEST_CASE("the published square grid on 5 x 5") {
    check(test::grid(5, 5, false), 1.0, moore_absent, moore_middle);
    check(test::grid(5, 5, true), 1.0, moore_wrap, moore_middle);
}

TEST_CASE("rates of their own give the same weights inside as a uniform rate") {
    for (const Stencil stencil : {Stencil::nine_point, Stencil::sims, Stencil::moore, Stencil::five_point}) {
        for (const Boundary boundary : {Boundary::wrap, Boundary::absorbing}) {
            const Experiment uniform = test::matrix(5, 5, boundary, stencil);
            Experiment own = uniform;  // a rule that never acts makes rates each cell's own
            own.rules = {test::rule(Change{Target::rate, 0, test::number(1.0), 0.0})};
            own.rules[0].from = 1000;

            for (const std::size_t cell : {0u, 4u, 12u, 24u}) {
                const Picture a = response(uniform, 0.5, cell, Precision::double_);
                const Picture b = response(own, 0.5, cell, Precision::double_);
                for (std::size_t i = 0; i < 25; ++i) CHECK(a[i] == Approx(b[i]).margin(1e-15));
            }
        }
    }
}

TEST_CASE("neighbours are counted from the first iteration on") {
    const auto counts = [](const Experiment& experiment) {
        const Snapshot before = test::blank(experiment);
        CHECK(before.neighbours == std::vector<std::int32_t>(6, 0));
        return test::after(1, experiment, before).neighbours;
    };
    using Counts = std::vector<std::int32_t>;

    CHECK(counts(test::grid(3, 2, false)) == Counts{3, 5, 3, 3, 5, 3});
    CHECK(counts(test::grid(3, 2, true)) == Counts(6, 8));
    CHECK(counts(test::matrix(3, 2, Boundary::no_flux)) == Counts{3, 5, 3, 3, 5, 3});
    CHECK(counts(test::matrix(3, 2, Boundary::wrap)) == Counts(6, 8));
    CHECK(counts(test::matrix(3, 2, Boundary::absorbing)) == Counts(6, 8));
    CHECK(counts(test::matrix(3, 2, Boundary::absorbing, Stencil::five_point)) == Counts(6, 4));
    CHECK(counts(test::matrix(3, 2, Boundary::no_flux, Stencil::five_point)) == Counts{2, 3, 2, 2, 3, 2});
}
