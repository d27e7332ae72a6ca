// See check.hpp: cells at the vertices of meshes, step by step against the reference. The quick form has generated
// ones.
#include "core/prepattern.hpp"
#include "core/surface.hpp"
#include "language/parse.hpp"
#include "mesh/shapes.hpp"
#include "mesh/surface.hpp"
#include "reference/backend.hpp"
#include "verify/bounded.hpp"
#include "verify/cases.hpp"
#include "verify/check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

namespace pelage::verify {

namespace {

constexpr std::uint64_t mesh_iterations = 24;

struct MeshCase {
    const char* name;
    const char* text;
};

const std::vector<MeshCase>& mesh_cases() {
    static const auto& cases = *new const std::vector<MeshCase>{
        {"mesh/uniform", R"(
define chemical A floor none
define chemical B limit 4.5
define time_step 0.02
use chemical A conc 4 dev 1 diff 0.8
use chemical B conc 4 dev 0.5 diff 0.2
create icosphere 2
rule always react A B turing alpha 16 beta 12
)"},
        {"mesh/cotangent", R"(
define chemical A floor none
define chemical B
define chemical C
use chemical A conc 0.5 dev 0.5 diff 0.12 dev 0.1
use chemical B conc 0.5 dev 0.5 diff 0.06
use chemical C conc 1 dev 0.5
create torus 19 11 weights cotangent scale 1.5
set cells 20 to 40 chemical A conc 0.5 diff 0
rule always react A B gray-scott f 0.037 k (0.06 + 0.0001 * Z)
rule if A conc > 0.5 change B diff 0.001 dev 0.0005
)"},
        {"mesh/rules", R"(
define chemical A limit 8 floor -2
define chemical B floor none
define time_step 0.25
define field bent (sin(X / 3) * Y + Z)
use seed 77
use chemical A conc (2 + RANDOM) diff 0.1
use chemical B conc (0.1 * Z) diff 0.15
create icosphere 2 weights cotangent
phase "first" 9
rule always map A conc 0 6 to M -1 1
rule if NEIGHBORS == 5 change A conc 0.5
rule probability 0.25 change B conc M dev 0.25
rule if Z > 1 set A conc (B + 0.125 * bent)
rule every 3 if AGE > 4 and
rule if X in -2 2 change B diff 0.0125
phase "second" 100
use chemical A diff 0.2
define chemical A limit 5 floor none
rule always react A by (0.1 * laplacian(B) - 0.01 * A * TIME) B by (RANDOM - 0.5)
rule if (ITERATION >= 15 and RANDOM < 0.5) set B conc 0.25
)"},
        {"mesh/still", R"(
define chemical A floor none
use chemical A conc 1 dev 1
create icosphere 0
rule always react A by (laplacian(A) * 0.125 + 0.001 * NEIGHBORS)
)"},
    };
    return cases;
}

// The experiment with this surface where it creates something else.
template <class Created>
Experiment on_surface(Experiment experiment, const Mesh& mesh, MeshWeights weights) {
    for (Statement& statement : experiment.prepattern) {
        if (std::holds_alternative<Created>(statement)) statement = CreateMesh{make_surface(mesh, weights)};
    }
    return experiment;
}

// The case of a lattice on a mesh of nearly as many cells.
Experiment on_mesh(const char* lattice_case_name) {
    return on_surface<CreateMatrix>(lattice_case(lattice_case_name).experiment({16, 8}), torus(16, 8),
                                    MeshWeights::cotangent);
}

// A vertex with more neighbours than 15 bits count.
Experiment on_a_fan() {
    constexpr std::size_t rim = 33'000;
    Mesh fan;
    fan.vertices.push_back({0, 0, 0});
    for (std::size_t i = 0; i < rim; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / rim;
        fan.vertices.push_back({10 * std::cos(angle), 10 * std::sin(angle), 0.5});
        const auto at = static_cast<std::uint32_t>(i);
        fan.triangles.push_back({0, at + 1, static_cast<std::uint32_t>((i + 1) % rim + 1)});
    }
    const char* const text =
        "define chemical A floor none\nuse chemical A conc 1 dev 1 diff 0.00001\ncreate icosphere 0\n";
    return on_surface<CreateMesh>(parse_experiment(text, "a fan", "."), fan, MeshWeights::uniform);
}

Outcome check_mesh(const Experiment& experiment, Place& place) {
    Outcome outcome;
    std::vector<Setting> settings{{}, {.work_group = 3, .width = 1}, {.variants = 1}};
    if (place.full())
        settings.insert(settings.end(), {{.width = 2}, {.width = 4}, {.width = 8}, {.width = 16}, {.guarded = false}});
    if (place.full() && place.device().fp64) {
        for (const std::size_t width : {std::size_t{0}, std::size_t{1}, std::size_t{4}})
            settings.push_back({.precision = Precision::double_, .width = width});
    }
    std::vector<Snapshot> states;
    for (const Setting& setting : settings) {
        const Snapshot initial = initial_state(experiment, setting.precision);
        const auto expected = reference_backend(setting.precision)->make_tissue(experiment, initial);
        const auto found = place.backend(setting).make_tissue(experiment, initial);
        const bool first = states.empty();
        if (first) states.push_back(initial);
        for (std::uint64_t i = 1; i <= mesh_iterations; ++i) {
            expected->advance(1);
            found->advance(1);
            const Snapshot there = expected->read();
            add(outcome.tally, there, found->read(), setting.precision,
                fmt::format("{} iteration {}", setting.text(), i));
            if (first) states.push_back(there);
        }
    }
    if (states.front().conc == states.back().conc)
        return {Verdict::mistrusted, {}, "the reference ends as it began", {}};
    conclude_bounded(outcome, experiment, states, place, {});
    return outcome;
}

}  // namespace

std::vector<Check> mesh_checks() {
    std::vector<Check> checks;
    for (const MeshCase& one : mesh_cases())
        checks.push_back({one.name, "mesh step", false, [&one](Place& place) {
                              return check_mesh(place.seeded(parse_experiment(one.text, one.name, ".")), place);
                          }});
    checks.push_back({"mesh/reactions", "mesh step", false,
                      [](Place& place) { return check_mesh(on_mesh("reaction/fused"), place); }});
    checks.push_back(
        {"mesh/neural", "mesh step", false, [](Place& place) { return check_mesh(on_mesh("neural/wrap"), place); }});
    checks.push_back({"mesh/fan", "mesh step", false, [](Place& place) {
                          if (place.small()) return Outcome{Verdict::skipped, {}, "left out with --small", {}};
                          return check_mesh(on_a_fan(), place);
                      }});
    return checks;
}

}  // namespace pelage::verify
