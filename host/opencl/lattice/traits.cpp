// See traits.hpp.
#include "opencl/lattice/traits.hpp"

#include "core/adjacency.hpp"
#include "opencl/lattice/emit_lattice.hpp"

#include <fmt/format.h>

namespace pelage {

LatticeTraits::LatticeTraits(const Experiment& experiment, const LatticePlan& plan, const RuleUse& use)
    : experiment_(experiment), plan_(plan), use_(use) {}

bool LatticeTraits::directed(std::size_t i) const {
    return per_cell(i) && plan_.polarity && experiment_.chemicals[i].anisotropic;
}

bool LatticeTraits::rolled(std::size_t i) const {
    return plan_.rates[i] == RateKind::uniform && plan_.arithmetic == Arithmetic::fused;
}

bool LatticeTraits::idle(std::size_t i) const {
    return plan_.rates[i] == RateKind::none && !use_.concentrations_written.contains(i) && !followed(i) &&
           !looked_around(i);
}

bool LatticeTraits::maps(std::size_t mapping) const {
    return use_.mappings_read.contains(mapping) || use_.mappings_written.contains(mapping);
}

bool LatticeTraits::polarity() const {
    for (std::size_t i = 0; i < plan_.rates.size(); ++i) {
        if (directed(i)) return true;
    }
    return turns();
}

bool LatticeTraits::visits() const {
    for (std::size_t i = 0; i < plan_.rates.size(); ++i) {
        if (visited(i)) return true;
    }
    return turns() || !use_.laplacians.empty() || !use_.gradients.empty();
}

std::string LatticeTraits::look() const {
    std::string before, each;
    for (const std::size_t i : use_.laplacians) {
        before += fmt::format("real lap{} = R(0);\n", i);
        each += fmt::format("LOOK_LAPLACIAN({})\n", i);
    }
    for (const std::size_t i : use_.gradients) {
        before += fmt::format("real slope_x{0} = R(0);\nreal slope_y{0} = R(0);\n", i);
        if (plan_.volume()) before += fmt::format("real slope_z{} = R(0);\n", i);
        each += fmt::format("LOOK_GRADIENT({})\n", i);
    }
    return each.empty() ? "" : before + around(each);
}

std::string LatticeTraits::around(const std::string& each) const { return neighbours_text(each, plan_.volume()); }

std::string LatticeTraits::visit(bool means) const {
    std::string text;
    for (std::size_t i = 0; i < plan_.rates.size(); ++i) {
        if (!visited(i)) continue;
        if (means && per_cell(i)) {
            const std::string felt = fmt::format("pelage_directed(r{}, px, py, dx, dy, diagonal)", i);
            text += fmt::format("EXCHANGE_MEANT({0}, {1})\n", i, directed(i) ? felt : fmt::format("r{}", i));
            continue;
        }
        const char* how = directed(i) ? "DIRECTED" : per_cell(i) ? "PER_CELL" : "UNIFORM";
        text += fmt::format("EXCHANGE_{}({})\n", how, i);
    }
    for (const std::size_t i : use_.polarizes) text += fmt::format("GRADIENT({})\n", i);
    return text;
}

std::string LatticeTraits::turn(Precision precision) const {
    std::string any = "ALL_FALSE", gx = "R(0)", gy = "R(0)";
    for (const std::size_t i : use_.polarizes) {
        any = fmt::format("{} | g{}", any, i);
        gx = fmt::format("SELECT(g{0}, gx{0}, {1})", i, gx);
        gy = fmt::format("SELECT(g{0}, gy{0}, {1})", i, gy);
    }
    return fmt::format(
        "const real gx = {};\nconst real gy = {};\nconst real slope = sqrt(gx * gx + gy * gy);\n"
        "const mask steep = ({}) & (slope > {});\n"
        "const real turned_x = SELECT(steep, gx / slope, px);\nconst real turned_y = SELECT(steep, gy / slope, py);\n",
        gx, gy, any, emit_number(0.0001, precision));
}

std::string LatticeTraits::shares(Precision precision) const {
    if (plan_.volume()) {
        const auto of = [&](Direction to) { return emit_number(neighbour_share(plan_.as_volume(), to), precision); };
        return fmt::format("#define FACE_SHARE {}\n#define EDGE_SHARE {}\n#define CORNER_SHARE {}\n",
                           of(direction(1, 0, 0)), of(direction(1, 1, 0)), of(direction(1, 1, 1)));
    }
    const auto share = [&](Direction to) { return emit_number(neighbour_share(plan_, to), precision); };
    if (plan_.stencil != Stencil::own)
        return fmt::format("#define EDGE_SHARE {}\n#define DIAGONAL_SHARE {}\n", share(direction(1, 0)),
                           share(direction(1, 1)));
    std::string text = "#define OWN_SHARES {";
    const int reach = plan_.reach();
    for (int up = reach; up >= -reach; --up) {
        for (int right = -reach; right <= reach; ++right)
            text += share(direction(right, up)) + (up == -reach && right == reach ? "}\n" : ", ");
    }
    return text;
}

}  // namespace pelage
