// See stability.hpp.
#include "core/stability.hpp"

#include "core/adjacency.hpp"
#include "core/digits.hpp"
#include "core/surface.hpp"
#include "core/visit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <complex>
#include <cstdint>
#include <limits>
#include <numbers>
#include <variant>

namespace pelage {

double stiffness(Stencil stencil) {
    switch (stencil) {
        case Stencil::moore:
            return 12.0;  // at wave vector (pi, 0): 8 - (2 - 2 - 4)
        case Stencil::nine_point:
            return 16.0 / 3;  // at (pi, pi): (20 + 16 - 4) / 6
        case Stencil::five_point:
            return 8.0;  // at (pi, pi)
        case Stencil::sims:
            return 1.6;  // at (pi, pi): 1 + 0.8 - 0.2
        case Stencil::seven_point:
            return 12.0;  // at (pi, pi, pi)
        case Stencil::twenty_seven_point:
            return 92.0 / 15;  // at (pi, pi, pi): (128 + 6 * 14 - 12 * 3 + 8) / 30
        case Stencil::own:
            break;
    }
    return 0.0;
}

double stiffness(const Lattice& lattice) {
    if (lattice.stencil != Stencil::own) return stiffness(lattice.stencil);
    // |1 + h l| <= 1 for the eigenvalue l of each wave: h <= -2 Re l / |l|^2.
    constexpr int waves = 64;
    const int reach = lattice.reach();
    double largest = 0.0;
    for (int kx = -waves + 1; kx <= waves; ++kx) {
        for (int ky = -waves + 1; ky <= waves; ++ky) {
            std::complex<double> eigenvalue = 0.0;
            for (int up = -reach; up <= reach; ++up) {
                for (int right = -reach; right <= reach; ++right) {
                    const double phase = std::numbers::pi * (kx * right + ky * up) / waves;
                    if (up != 0 || right != 0)
                        eigenvalue += neighbour_share(lattice, direction(right, up)) * (std::polar(1.0, phase) - 1.0);
                }
            }
            const double size = std::norm(eigenvalue);
            if (size < 1e-24) continue;
            if (eigenvalue.real() >= 0.0) return std::numeric_limits<double>::infinity();
            largest = std::max(largest, size / -eigenvalue.real());
        }
    }
    return largest;
}

namespace {

// A free cell of the published kind has about six neighbours; the hexagonal lattice's eigenvalue bounds its diffusion.
constexpr double hexagonal_stiffness = 9.0;

double stiffness(const Space& space) {
    return std::visit(Overloaded{[](const Lattice& lattice) { return stiffness(lattice); },
                                 [](const FreeCells&) { return hexagonal_stiffness; },
                                 [](const Volume& volume) { return stiffness(volume.stencil); },
                                 [](const MeshCells& mesh) { return stiffness(*mesh.surface); }},
                      space);
}

// What networks add to a chemical's rate.
struct NetworkShare {
    double rate = 0.0;
    std::size_t line = 0;  // of the rule that adds most
};

// Of the network that acts in every cell of this phase, if the rule has one.
double share_of(const Rule& rule, std::uint64_t begin, std::uint64_t end, std::size_t chemical) {
    const auto* neural = std::get_if<Neural>(&rule.action);
    if (neural == nullptr || !std::holds_alternative<Always>(rule.condition)) return 0.0;
    if (neural->diffusion.quantity != Quantity::number || rule.from >= end || rule.until < begin) return 0.0;
    const auto place = std::ranges::find(neural->species, chemical) - neural->species.begin();
    const auto count = neural->species.size();
    const auto at = static_cast<std::size_t>(place);
    return at == count ? 0.0 : group_rate(at, count) * neural->diffusion.value;
}

// Networks of every iteration add up; of those that pause, which may take turns, the fastest counts.
NetworkShare share_of_networks(const Experiment& experiment, std::size_t phase, std::size_t chemical) {
    const std::uint64_t begin = experiment.phases[phase].begin;
    const std::uint64_t end = phase + 1 < experiment.phases.size() ? experiment.phases[phase + 1].begin : forever;
    NetworkShare all;
    double most = 0.0, pausing = 0.0;
    for (const Rule& rule : experiment.rules) {
        const double share = share_of(rule, begin, end, chemical);
        if (rule.every == 1) all.rate += share;
        if (rule.every != 1) pausing = std::max(pausing, share);
        if (share > most) all.line = rule.line;
        most = std::max(most, share);
    }
    all.rate += pausing;
    return all;
}

}  // namespace

std::string Instability::rates() const {
    if (network == 0.0) return "a rate of " + digits(rate);
    if (rate == 0.0) return "a network's rate of " + digits(network);
    return fmt::format("a rate of {} and {} by a network", digits(rate), digits(network));
}

std::optional<Instability> find_instability(const Experiment& experiment, const Snapshot& initial) {
    const double stiff = stiffness(space_of(experiment));
    std::vector<double> largest;
    for (const std::vector<double>& rates : initial.diff) {
        largest.push_back(rates.empty() ? 0.0 : *std::max_element(rates.begin(), rates.end()));
    }
    for (std::size_t nth = 0; nth < experiment.phases.size(); ++nth) {
        const Phase& phase = experiment.phases[nth];
        for (std::size_t chemical = 0; chemical < largest.size(); ++chemical) {
            if (phase.rates[chemical]) largest[chemical] = *phase.rates[chemical];
            const double rate = largest[chemical];
            const NetworkShare network = share_of_networks(experiment, nth, chemical);
            const double all = rate + network.rate;
            // A hair of slack: an experiment may sit exactly on the limit.
            if (all > 0.0 && all * stiff * phase.time_step > 2.0 * (1 + 1e-6)) {
                return Instability{phase.name,
                                   experiment.chemicals[chemical].name,
                                   rate,
                                   network.rate,
                                   network.line,
                                   phase.time_step,
                                   2.0 / (all * stiff)};
            }
        }
    }
    return std::nullopt;
}

}  // namespace pelage
