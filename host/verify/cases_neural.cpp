// See cases.hpp: reactions that a network computes.
#include "verify/cases.hpp"
#include "verify/dice.hpp"
#include "verify/lab.hpp"

#include <fmt/format.h>

#include <memory>

namespace pelage::verify {

namespace {

// The last chemicals come first, so that a network's place and a chemical's are not the same.
Neural asked(Lab& lab, std::size_t chemicals, std::size_t hidden) {
    Neural neural;
    neural.network = drawn_network(chemicals, hidden, chemicals + hidden);
    for (std::size_t i = 0; i < chemicals; ++i) {
        const std::size_t place = lab.chemical(fmt::format("h{}x{}", hidden, i), {0.0, 0.5}, {0.0, 0.0}, unbounded);
        neural.species.insert(neural.species.begin(), place);
    }
    return neural;
}

// One for all cells; one that other chemicals and the place speed up; one in some cells, without diffusion.
Experiment networks(Lab lab) {
    Neural plain = asked(lab, 4, 5);
    const auto fast = lab.chemical("fast", {0.5, 0.25}, {0.125, 0.0}, unbounded);
    Neural held = asked(lab, 8, 24);
    held.rate = quantity(Quantity::concentration, fast);
    held.diffusion = quantity(Quantity::random);
    lab.rule(plain);
    lab.rule(held);
    plain.diffusion = number(0.0);
    plain.rate = number(-0.5);
    lab.rule(plain, compare(quantity(Quantity::concentration, fast), Comparison::greater, number(0.5))).every = 2;
    lab.rule(change(fast, number(0.0625)));
    return lab.time_step(0.125).done();
}

// As large as those that were published.
Experiment texture(Lab lab) {
    lab.rule(asked(lab, 32, 128));
    return lab.time_step(0.25).done();
}

}  // namespace

std::shared_ptr<const Network> drawn_network(std::size_t chemicals, std::size_t hidden, std::uint64_t seed) {
    Dice dice(seed);
    const auto drawn = [&](std::size_t count, double size) {
        std::vector<double> values(count);
        for (double& value : values) value = dice.real(-size, size);
        return values;
    };
    const auto first = drawn(chemicals * hidden, 0.75);
    auto bias = drawn(hidden, 1.0);
    auto second = drawn(hidden * chemicals, 0.125);
    // Two hidden values lie where e^-x would be too large or too small a number, and add little.
    for (const std::size_t far : {std::size_t{1}, std::size_t{2}}) {
        bias[far] = far == 1 ? 30.0 : -30.0;
        for (std::size_t i = 0; i < chemicals; ++i) second[far * chemicals + i] /= 32;
    }
    return std::make_shared<const Network>(make_network(chemicals, hidden, first, bias, second, "drawn"));
}

std::vector<Case> neural_cases() {
    const auto matrix = [](auto make, Boundary boundary, Stencil stencil) {
        return [=](Size size) { return make(Lab::matrix(size.columns, size.rows, boundary, stencil)); };
    };
    const std::vector<Size> sizes{{1, 1}, {3, 2}, {20, 9}, {37, 11}};
    return {
        {"neural/wrap", matrix(networks, Boundary::wrap, Stencil::nine_point), sizes, 12, {}},
        {"neural/no-flux", matrix(networks, Boundary::no_flux, Stencil::own), sizes, 12, {}},
        {"neural/absorbing", matrix(networks, Boundary::absorbing, Stencil::five_point), sizes, 12, {}},
        {"neural/texture", matrix(texture, Boundary::wrap, Stencil::own), {{18, 5}}, 4, {}},
    };
}

}  // namespace pelage::verify
