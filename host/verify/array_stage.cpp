// See array_text.hpp: sizes, what no text says, and the state that a case starts from.
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "mesh/shapes.hpp"
#include "mesh/surface.hpp"
#include "mesh/tidy.hpp"
#include "verify/array_text.hpp"
#include "verify/lab.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <variant>

namespace pelage::verify {

namespace {

Size taken_in_turn(const GeneratedWorld& made, std::initializer_list<Size> sizes) {
    return sizes.begin()[made.number % sizes.size()];
}

// One cell and lines; fewer layers than a wave has steps; as many as it needs, and rows for several strips; or more
// cells than 16 bits count.
std::vector<Size> volume_sizes_of(const GeneratedWorld& made) {
    const auto turn = [&](std::initializer_list<Size> sizes) { return taken_in_turn(made, sizes); };
    if (Values(Realm::volume, made.world).has("extent", "many"))
        return {{5, 4, 3}, turn({{37, 43, 47}, {65'541, 1, 1}, {1, 65'541, 1}, {1, 1, 65'541}})};
    return {turn({{1, 1, 9}, {9, 1, 1}, {1, 7, 2}, {1, 1, 1}}), turn({{7, 5, 3}, {33, 2, 9}, {16, 3, 4}, {2, 2, 2}}),
            turn({{33, 12, 7}, {18, 25, 8}, {41, 12, 9}, {9, 31, 7}})};
}

// Of an icosphere the columns say how often its triangles are cut.
std::vector<Size> mesh_sizes_of(const GeneratedWorld& made) {
    const auto turn = [&](std::initializer_list<Size> sizes) { return taken_in_turn(made, sizes); };
    if (Values(Realm::mesh, made.world).has("shape", "icosphere"))
        return {turn({{0, 0}, {1, 0}}), turn({{2, 0}, {3, 0}})};
    return {turn({{4, 3}, {5, 4}, {7, 3}}), turn({{19, 11}, {31, 5}, {23, 13}})};
}

// A sheet with a fin, so that edges have three triangles; a corner that is written twice, a triangle that is, one
// without area, and a vertex of none are taken out again as of a file.
Mesh odd_mesh(Size size) {
    Mesh mesh = sheet(size.columns, size.rows);
    for (Point& vertex : mesh.vertices) vertex[2] = 0.25 * std::sin(1.3 * vertex[0]) + 0.125 * vertex[1];
    const auto end = static_cast<std::uint32_t>(mesh.vertices.size());
    const Point lifted = mesh.vertices[1] + Point{-0.5, 0.25, 1.5};
    mesh.vertices.insert(mesh.vertices.end(), {lifted, mesh.vertices[1], Point{9, 9, 9}});
    const auto up = static_cast<std::uint32_t>(size.columns);
    mesh.triangles.insert(mesh.triangles.end(), {{0, 1, end}, {end + 1, up + 1, end}, {1, up + 1, end}, {0, end, 0}});
    tidy(mesh);
    return mesh;
}

void take_odd_mesh(Experiment& experiment, Size size) {
    for (Statement& statement : experiment.prepattern) {
        auto* const created = std::get_if<CreateMesh>(&statement);
        if (created != nullptr) created->surface = make_surface(odd_mesh(size), created->surface->weights);
    }
}

// One of the four chemicals that every experiment has, the last of them first.
Rule network_rule(const Experiment& experiment, const GeneratedCase& one) {
    Neural neural;
    neural.network = drawn_network(4, 10, one.made->number + 1);
    for (const char* const name : {"W", "Q", "B", "A"}) {
        const auto at = std::ranges::find(experiment.chemicals, std::string(name), &Chemical::name);
        neural.species.push_back(static_cast<std::size_t>(at - experiment.chemicals.begin()));
    }
    neural.rate = one.made->number % 2 == 0 ? number(0.75) : quantity(Quantity::random);
    neural.diffusion = one.made->number % 3 == 0 ? quantity(Quantity::concentration, neural.species[2]) : number(0.25);
    Rule rule;
    rule.condition = Probability{number(0.75)};
    rule.action = neural;
    return rule;
}

}  // namespace

Experiment generated_experiment(const GeneratedCase& one, const std::string& text) {
    Experiment experiment = parse_experiment(text, "generated experiment", ".");
    const Values world = one.world();
    if (world.has("shape", "odd")) take_odd_mesh(experiment, one.size);
    if (world.has("network", "drawn")) experiment.rules.push_back(network_rule(experiment, one));
    return experiment;
}

std::vector<Size> generated_sizes(const GeneratedWorld& made, Realm realm) {
    const Values world(realm, made.world);
    const auto turn = [&](std::initializer_list<Size> sizes) { return taken_in_turn(made, sizes); };
    if (realm == Realm::volume) return volume_sizes_of(made);
    if (realm == Realm::mesh) return mesh_sizes_of(made);
    if (realm == Realm::charges) return {charges_size(made)};
    if (realm == Realm::cells) {
        if (world["sizes"] == "tissue") return {{13, 11}};
        // One cell or two have no mirrors and no uneven rates: a program of their own.
        const bool plain = world["mirrors"] == "none" && world["rates"] == "uniform";
        const Size smallest = plain ? turn({{7, 0}, {1, 0}, {2, 0}}) : Size{7, 0};
        return {smallest, turn({{5, 3}, {4, 4}, {17, 1}, {11, 3}})};
    }
    // More cells than 16 bits count, or columns, or rows; where rows and columns go to and fro, in two of these ways,
    // and without a small lattice, whose tiles would be another program.
    if (world["sizes"] == "many") {
        const bool fro = world["path"] == "streamed" || world["path"] == "tiled";
        if (fro)
            return {made.alike % 2 == 0 ? Size{65'541, 1} : Size{1, 65'541},
                    turn({{311, 223}, {520, 131}, {223, 311}})};
        return {{9, 4}, turn({{65'541, 1}, {311, 223}, {1, 65'541}, {520, 131}})};
    }
    const std::initializer_list<Size> narrow{{1, 37}, {2, 3}, {41, 1}, {1, 1}};  // of each path all of them
    std::vector<Size> sizes{narrow.begin()[made.alike % narrow.size()],
                            turn({{15, 6}, {16, 7}, {17, 15}, {33, 2}, {7, 5}}), turn({{31, 9}, {65, 11}, {130, 3}}),
                            turn({{24, 33}, {67, 71}})};
    // Passes that are not cut small would go round these more than once, across and along.
    if (world["cut"] == "whole") sizes.insert(sizes.begin(), {{2, 9}, {9, 2}});
    return sizes;
}

// Phases begin three and six iterations after the start: there a pass may take several iterations.
std::vector<std::uint64_t> generated_strides(Size size, Realm realm) {
    if (realm == Realm::charges) return {1, 2, 60, 257};
    const std::size_t cells = size.cells();
    if (cells > 5000) return {1, 3};
    if (realm == Realm::volume && cells > 1000) return {1, 1, 3, 1, 8};
    if (cells > 1000) return {1, 1, 3, 1, 8, 26};
    return {1, 1, 3, 1, 2, 11};
}

void set_stage(const GeneratedCase& one, Snapshot& state) {
    const auto start = std::stoull(one.world()["start"]);
    if (one.realm == Realm::charges) {
        state.iteration = start;
        return;
    }
    const auto names = generated_chemicals(one);
    const auto idle = static_cast<std::size_t>(std::ranges::find(names, "G") - names.begin());
    state.iteration = start;
    for (double& value : state.conc[idle]) value = std::round(4 * value) / 4;
    for (std::size_t cell = 0; cell < state.cells(); ++cell) {
        const std::uint64_t ages[] = {0, 3, 7, 12, 65'530, 2'147'483'640, 4'294'967'200};
        state.birth[cell] = static_cast<std::uint32_t>(start - std::min<std::uint64_t>(ages[cell % 7], start));
        state.neighbours[cell] = static_cast<std::int32_t>(cell % 6);
        if (one.realm == Realm::lattice) state.fixed[cell] = cell % 3 == 0 ? 1 : 0;
        for (auto& plane : state.mappings) plane[cell] = static_cast<double>(cell % 11) * 0.125;
    }
    const auto last = static_cast<std::uint32_t>(state.cells() - 1);
    if (one.realm != Realm::cells || one.world()["mirrors"] == "none" || last < 3) return;
    state.mirrors = {{0, last}, {1, last / 2}, {last / 2, last - 1}, {last - 1, 0}};
}

}  // namespace pelage::verify
