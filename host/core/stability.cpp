// See stability.hpp.
#include "core/stability.hpp"

#include "core/adjacency.hpp"
#include "core/surface.hpp"
#include "core/visit.hpp"

#include <algorithm>
#include <complex>
#include <limits>
#include <numbers>

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

}  // namespace

std::optional<Instability> find_instability(const Experiment& experiment, const Snapshot& initial) {
    const double stiff = stiffness(space_of(experiment));
    std::vector<double> largest;
    for (const std::vector<double>& rates : initial.diff) {
        largest.push_back(rates.empty() ? 0.0 : *std::max_element(rates.begin(), rates.end()));
    }
    for (const Phase& phase : experiment.phases) {
        for (std::size_t chemical = 0; chemical < largest.size(); ++chemical) {
            if (phase.rates[chemical]) largest[chemical] = *phase.rates[chemical];
            const double rate = largest[chemical];
            // A hair of slack: an experiment may sit exactly on the limit.
            if (rate > 0.0 && rate * stiff * phase.time_step > 2.0 * (1 + 1e-6)) {
                return Instability{phase.name, experiment.chemicals[chemical].name, rate, phase.time_step,
                                   2.0 / (rate * stiff)};
            }
        }
    }
    return std::nullopt;
}

}  // namespace pelage
