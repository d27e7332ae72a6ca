// See random_draft.hpp: volumes, meshes, and charges.
#include "core/stability.hpp"
#include "mesh/shapes.hpp"
#include "mesh/surface.hpp"
#include "verify/random_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pelage::verify {

namespace {

// The largest number of cuts that leaves no more vertices than so many.
std::size_t cuts_of_sphere(std::size_t most) {
    std::size_t cuts = 0;
    while (10 * (std::size_t{4} << (2 * cuts)) + 2 <= most && cuts < 3) ++cuts;
    return cuts;
}

Mesh scaled(Mesh mesh, double scale) {
    for (Point& vertex : mesh.vertices) vertex = scale * vertex;
    return mesh;
}

// One seed in the middle, whatever the size, and others by chance.
std::string seeds(Draft& draft) {
    const std::string middle = "COLUMN == floor(COLUMNS / 2) and ROW == floor(ROWS / 2)";
    if (draft.dice.chance(50)) return middle;
    return middle + " or " + draft.dice.pick({"mod(COLUMN, 7) == 3 and mod(ROW, 5) == 2", "ROW == 0", "COLUMN == ROW"});
}

// The same for all sites: numbers, or what changes in time.
std::string of_all(Draft& draft, double low, double high) {
    Dice& dice = draft.dice;
    const std::string first = dice.number(low, high);
    if (dice.chance(70)) return first;
    const char* const clock = dice.pick({"ITERATION", "TIME"});
    return fmt::format("({} + {} / {})", first, clock, 64 << dice.below(3));
}

}  // namespace

std::string draw_volume(Draft& draft) {
    Dice& dice = draft.dice;
    const Stencil stencil = dice.chance(50) ? Stencil::seven_point : Stencil::twenty_seven_point;
    draft.stiffness = stiffness(stencil);
    const bool small = stencil == Stencil::seven_point;
    if (!small || dice.chance(50))
        draft.line(small ? "define stencil seven-point" : "define stencil twenty-seven-point");
    const std::size_t most = std::max<std::size_t>(draft.limits.cells, 1);
    const std::size_t wide = dice.pick<std::size_t>({1, 2, 5, 8, 15, 16, 17, 33, 65});
    draft.columns = std::min(wide, most);
    draft.rows = dice.from_to(1, std::min<std::size_t>(most / draft.columns, 12));
    draft.layers = dice.from_to(1, std::min<std::size_t>(most / (draft.columns * draft.rows), 14));
    draft.cells = draft.columns * draft.rows * draft.layers;
    const char* const boundary = dice.pick({"", "no-flux", "wrap", "wrap", "absorbing"});
    return words({fmt::format("create volume {} {} {}", draft.columns, draft.rows, draft.layers), boundary});
}

std::string draw_mesh(Draft& draft) {
    Dice& dice = draft.dice;
    const std::size_t most = std::max<std::size_t>(draft.limits.cells, 12);
    const bool sphere = most < 24 || dice.chance(50);
    const std::size_t across = dice.from_to(3, std::max<std::size_t>(3, std::min<std::size_t>(9, most / 12)));
    const std::size_t around = dice.from_to(across + 1, std::max(across + 1, most / (across + 3)));
    const std::size_t cuts = dice.from_to(0, cuts_of_sphere(most));
    const bool cotangent = dice.chance(60);
    const double scale = dice.chance(50) ? 1.0 : dice.real(0.75, 3.0);
    const auto surface = make_surface(scaled(sphere ? icosphere(cuts) : torus(around, across), scale),
                                      cotangent ? MeshWeights::cotangent : MeshWeights::uniform);
    draft.stiffness = std::ceil(16.25 * stiffness(*surface)) / 16;  // with no digits that machines differ in
    draft.cells = surface->cells();
    draft.radius = scale * std::sqrt(static_cast<double>(draft.cells));
    std::vector<std::string> options;
    if (cotangent || dice.chance(50)) options.push_back(cotangent ? "weights cotangent" : "weights uniform");
    if (scale != 1.0) options.push_back(fmt::format("scale {}", scale));
    const std::string what = sphere ? fmt::format("icosphere {}", cuts) : fmt::format("torus {} {}", around, across);
    return words({"create", what, draft.shuffled(options)});
}

void draw_charges(Draft& draft) {
    Dice& dice = draft.dice;
    draft.line("define time_step 0.25");
    draft.time_step = 0.25;
    for (const char* const name : {"order", "phi", "family", "mass"}) {
        if (draft.chemicals.size() > 1 && dice.chance(50)) continue;
        draft.line(fmt::format("define chemical {}", name));
        ChemicalDraft chemical;
        chemical.name = name;
        draft.chemicals.push_back(chemical);
    }
    if (dice.chance(60)) draw_seed(draft);
    draft.far_field = dice.chance(40);
    const std::size_t most = std::max<std::size_t>(draft.limits.cells, 1);
    draft.columns = dice.from_to(1, std::min<std::size_t>(most, 40));
    draft.rows = dice.from_to(1, std::min<std::size_t>(most / draft.columns, 40));
    draft.cells = draft.columns * draft.rows;
    const std::string seed = seeds(draft);
    std::vector<std::string> options;
    if (dice.chance(30)) options.push_back(words({"at", dice.number(-9.0, 9.0), dice.number(-9.0, 9.0)}));
    if (dice.chance(40))
        options.push_back(fmt::format("where ({} or {})", dice.pick({"RANDOM < 0.75", "mod(COLUMN, 5) != 2"}), seed));
    draft.line(words({fmt::format("create charges {} {}", draft.columns, draft.rows), draft.shuffled(options)}));
    draft.line(fmt::format("set cells where ({}) chemical order conc (1 + mod(COLUMN + ROW, 3))", seed));
}

std::string draw_particle(Draft& draft) {
    Dice& dice = draft.dice;
    const auto known = [&](const char* name) {
        return std::ranges::any_of(draft.chemicals, [&](const ChemicalDraft& one) { return one.name == name; });
    };
    std::vector<std::string> options;
    if (dice.chance(80)) options.push_back("eta " + of_all(draft, 0.0, 12.0));
    if (dice.chance(40)) options.push_back("radius " + of_all(draft, 0.5, 4.0));
    if (draft.far_field) {
        options.emplace_back("far-field");
    } else if (dice.chance(40)) {
        const std::string x = of_all(draft, -20.0, 20.0);
        const std::string y = of_all(draft, -20.0, 20.0);
        options.push_back(words({"towards", x, y, "strength", of_all(draft, 0.0, 5.0)}));
    }
    if (known("family")) options.emplace_back("seed family");
    if (known("mass")) {
        const std::string drawn = "(0.01 + 20 * RANDOM ^ 3)";
        options.push_back("size mass " + (dice.chance(50) ? drawn : of_all(draft, 0.125, 9.0)));
    }
    return words({"aggregate order phi", draft.shuffled(options)});
}

}  // namespace pelage::verify
