// The first half of a random experiment: settings, chemicals, cells, and what single cells start with.
#include "core/error.hpp"
#include "core/stability.hpp"
#include "verify/random_cells.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pelage::verify {

namespace {

void draw_kind(Draft& draft) {
    const RandomLimits& limits = draft.limits;
    const auto weight = [](bool allowed, unsigned of_hundred) { return allowed ? of_hundred : 0u; };
    const std::initializer_list<unsigned> weights{weight(limits.matrix, 40),     weight(limits.sqr_grid, 15),
                                                  weight(limits.free_cells, 20), weight(limits.volume, 12),
                                                  weight(limits.mesh, 8),        weight(limits.charges, 5)};
    if (std::max(weights) == 0) throw Error("a random experiment needs a kind of tissue that is allowed");
    draft.kind = static_cast<TissueKind>(draft.dice.weighted(weights));
    draft.stiffness = draft.kind == TissueKind::sqr_grid ? stiffness(Stencil::moore) : 9.0;
}

void draw_time_step(Draft& draft) {
    draft.time_step = draft.dice.pick({0.002, 0.01, 0.01, 0.02, 0.03125, 0.05, 0.1, 0.25});
    if (draft.dice.chance(6)) {
        draft.time_step = 1.0;  // the default
        return;
    }
    draft.line("define time_step " + draft.dice.number(draft.time_step));
}

// Weights that differ in all directions; exact in binary.
void draw_weights(Draft& draft) {
    constexpr double unit = 64.0;
    Lattice lattice;
    lattice.stencil = Stencil::own;
    draft.wide = draft.dice.chance(40);
    lattice.weights.resize(draft.wide ? 25 : 9);
    const std::size_t middle = lattice.weights.size() / 2;
    double sum = 0.0;
    for (std::size_t i = 0; i < lattice.weights.size(); ++i) {
        if (i == middle) continue;
        lattice.weights[i] = static_cast<double>(1 + draft.dice.below(20)) / unit;
        sum += lattice.weights[i];
    }
    lattice.weights[middle] = -sum;
    draft.line(fmt::format("define stencil {} {}", draft.wide ? "5x5" : "3x3", fmt::join(lattice.weights, " ")));
    draft.stiffness = stiffness(lattice);
}

// Sums of cells around, which rules name.
void define_stencils(Draft& draft) {
    while (draft.stencils.size() < 2 && draft.dice.chance(15)) {
        const std::size_t side = draft.dice.pick({3u, 5u, 7u});
        std::vector<double> weights(side * side);
        for (double& weight : weights)
            weight = draft.dice.chance(40) ? 0.0 : (static_cast<double>(draft.dice.below(33)) - 16.0) / 64.0;
        const std::string name = fmt::format("around_{}", draft.stencils.size());
        draft.line(fmt::format("define stencil {0} {1}x{1} {2}", name, side, fmt::join(weights, " ")));
        draft.stencils.push_back(name);
    }
}

void draw_stencil(Draft& draft) {
    if (draft.dice.chance(15)) return draw_weights(draft);
    struct Named {
        Stencil stencil;
        const char* word;
    };
    Named chosen{Stencil::nine_point, "nine-point"};
    if (draft.dice.chance(75)) {
        chosen = draft.dice.pick({Named{Stencil::moore, "moore"}, Named{Stencil::five_point, "five-point"},
                                  Named{Stencil::sims, "sims"}, chosen});
        draft.line(fmt::format("define stencil {}", chosen.word));
    }
    draft.stiffness = stiffness(chosen.stencil);
}

void draw_domain(Draft& draft) {
    Dice& dice = draft.dice;
    if (dice.chance(40)) draft.line(fmt::format("define division_limit {}", dice.from_to(0, 9)));
    switch (dice.weighted({25, 45, 10, 20})) {
        case 1:
            draft.line(words({"define domain", dice.number(3.0, 40.0), dice.number(3.0, 40.0)}));
            break;
        case 2:
            draft.line("define domain packed");
            break;
        case 3:
            draft.line("define domain packed area " + dice.number(1.5, 5.0));
            break;
        default:
            break;
    }
}

// ---- chemicals

// Of values within the chemical's bounds, which stay where they are.
std::string picture_option(Draft& draft, const RandomPicture& picture, ChemicalDraft& chemical) {
    chemical.pinned = true;
    const double low = std::max(chemical.floor, 0.0);
    const double high = std::min(chemical.limit, chemical.conc + 2.0 * chemical.spread);
    const bool plain = low == 0.0 && high >= 1.0;  // 0 to 1 as the picture has it will do
    std::string text = fmt::format("conc \"{}\"", picture.file);
    std::vector<std::string> more;
    if (!picture.channels.empty() && draft.dice.chance(70)) {
        more.push_back("channel " + picture.channels[draft.dice.below(picture.channels.size())]);
    }
    if (draft.dice.chance(70) || !plain) {
        more.push_back(
            words({"from", draft.dice.number(low, chemical.conc), "to", draft.dice.number(chemical.conc, high)}));
    }
    return words({text, draft.shuffled(more)});
}

void define_chemical(Draft& draft, const std::string& name, const RandomPicture* picture) {
    Dice& dice = draft.dice;
    ChemicalDraft chemical;
    chemical.name = name;
    chemical.conc = dice.real(0.25, 5.0);
    chemical.spread = chemical.conc * dice.real(0.02, 0.75);
    std::vector<std::string> options;
    if (dice.chance(72)) {
        chemical.limit = chemical.conc + chemical.spread * dice.real(0.25, 3.0);
        options.push_back(fmt::format("limit {}", dice.number(chemical.limit)));
    } else if (dice.chance(40)) {
        options.emplace_back("limit none");
    }
    if (dice.chance(25)) {
        chemical.floor = chemical.conc - chemical.spread * dice.real(0.25, 2.0);
        options.push_back(fmt::format("floor {}", dice.number(chemical.floor)));
    } else if (dice.chance(25)) {
        chemical.floor = -std::numeric_limits<double>::infinity();
        options.emplace_back("floor none");
    }
    if (dice.chance(18) && draft.plane() && !draft.wide) options.emplace_back("anisotropic");
    if (picture != nullptr && dice.chance(60)) options.push_back(picture_option(draft, *picture, chemical));
    draft.line(words({"define chemical", chemical.name, draft.shuffled(options)}));
    draft.chemicals.push_back(chemical);
}

void define_chemicals(Draft& draft, const RandomPicture* picture) {
    const char* const names[] = {"U", "V", "W", "x", "beta_2", "Turing-pair", "_", "a1", "Rate"};
    const std::size_t most = std::clamp<std::size_t>(draft.limits.chemicals, 1, std::size(names));
    // Two is what most experiments have.
    const std::size_t count = draft.dice.chance(45) ? std::min<std::size_t>(2, most) : draft.dice.from_to(1, most);
    const std::size_t first = draft.dice.below(std::size(names));
    for (std::size_t i = 0; i < count; ++i) {
        define_chemical(draft, names[(first + i) % std::size(names)], picture);
    }
}

void define_fields(Draft& draft, const RandomPicture* picture) {
    Dice& dice = draft.dice;
    while (draft.fields.size() < 3 && dice.chance(25)) {
        const std::string name = fmt::format("field_{}", draft.fields.size());
        if (picture != nullptr && dice.chance(40)) {
            std::vector<std::string> more;
            if (dice.chance(60)) more.push_back(words({"fit", dice.pick({"stretch", "tile", "centre"})}));
            if (dice.chance(60)) more.push_back(words({"from", dice.number(0.0, 1.0), "to", dice.number(1.0, 2.0)}));
            if (!picture->channels.empty()) more.push_back("channel " + picture->channels.front());
            draft.line(words({"define field", name, "\"" + picture->file + "\"", draft.shuffled(more)}));
        } else {
            draft.line(words({"define field", name, draw_expression(draft, ExpressionScope::field, 0.0, 2.0)}));
        }
        draft.fields.push_back(name);
    }
}

// ---- a lattice

void draw_size(Draft& draft) {
    Dice& dice = draft.dice;
    const std::size_t most = std::max<std::size_t>(draft.limits.cells, 1);
    std::size_t columns = 1;
    switch (dice.weighted({1, 1, 2, 4, 4})) {
        case 0:
            break;
        case 1:
            columns = dice.from_to(1, std::min<std::size_t>(most, 300));
            break;
        case 2:
            columns = dice.from_to(1, 4);
            break;
        case 3:  // beside the widths of vectors and groups
            columns = dice.pick<std::size_t>({7, 8, 9, 15, 16, 17, 31, 32, 33, 47, 63, 64, 65, 97, 127, 128, 130});
            break;
        default:
            columns = dice.from_to(2, static_cast<std::size_t>(2.0 * std::sqrt(static_cast<double>(most))) + 1);
    }
    draft.columns = std::min(columns, most);
    draft.rows = dice.from_to(1, std::min<std::size_t>(most / draft.columns, draft.columns == 1 ? 60 : most));
}

void create_lattice(Draft& draft) {
    Dice& dice = draft.dice;
    const bool matrix = draft.kind == TissueKind::matrix;
    std::vector<std::string> options;
    if (matrix && dice.chance(85)) options.emplace_back(dice.pick({"no-flux", "wrap", "wrap", "absorbing"}));
    if (!matrix && dice.chance(50)) options.emplace_back("wrap");
    if (!matrix && dice.chance(20)) options.emplace_back("fixed");
    if (dice.chance(25)) options.push_back(words({"at", dice.number(-9.0, 9.0), dice.number(-9.0, 9.0)}));
    const std::string what = fmt::format("create {} {} {}", matrix ? "matrix" : "sqr_grid", draft.columns, draft.rows);
    draft.line(words({what, draft.shuffled(options)}));
    draft.cells = draft.columns * draft.rows;
}

}  // namespace

void draw_world(Draft& draft) {
    draw_kind(draft);
    if (draft.kind == TissueKind::charges) return draw_charges(draft);
    const auto& pictures = draft.limits.pictures;
    const RandomPicture* picture = nullptr;
    if (draft.lattice() && !pictures.empty() && draft.dice.chance(50)) {
        picture = &pictures[draft.dice.below(pictures.size())];
    }
    std::string create;
    if (draft.kind == TissueKind::matrix) draw_stencil(draft);
    if (draft.kind == TissueKind::volume) create = draw_volume(draft);
    if (draft.kind == TissueKind::mesh) create = draw_mesh(draft);
    if (draft.lattice()) define_stencils(draft);
    draw_time_step(draft);
    if (draft.kind == TissueKind::free_cells) draw_domain(draft);
    define_chemicals(draft, picture);
    define_fields(draft, picture);
    if (draft.dice.chance(60)) draw_seed(draft);
    draw_uses(draft);
    if (draft.kind == TissueKind::free_cells) {
        create_cells(draft);
    } else if (!draft.lattice()) {
        draft.line(create);
    } else {
        draw_size(draft);
        if (picture != nullptr) {
            draft.columns = picture->columns;
            draft.rows = picture->rows;
        }
        create_lattice(draft);
    }
    if (draft.dice.chance(35)) set_cells(draft);
}

}  // namespace pelage::verify
