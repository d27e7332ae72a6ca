// Tissues on meshes: what exchange along edges must do, and that both backends do it.
#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "core/space.hpp"
#include "core/stability.hpp"
#include "core/surface.hpp"
#include "io/mesh_results.hpp"
#include "language/parse.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/shapes.hpp"
#include "mesh/surface.hpp"
#include "opencl/backend.hpp"
#include "reference/backend.hpp"
#include "verify/equal_runs.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>

using namespace pelage;

namespace {

Experiment read(const std::string& text) { return parse_experiment(text, "mesh.pex", "."); }

Snapshot after(const Experiment& experiment, std::uint64_t iterations, Precision precision = Precision::single_) {
    const auto tissue = reference_backend(precision)->make_tissue(experiment);
    tissue->advance(iterations);
    return tissue->read();
}

const std::string turing =
    "define chemical U\ndefine chemical V\ndefine time_step 0.05\n"
    "use chemical U conc 4 dev 1 diff 0.8 dev 0.3\nuse chemical V conc 4 dev 1 diff 0.2\n";
const std::string reaction = "rule always react U V turing alpha 16 beta 12\n";

// The mesh of that experiment replaced by a flat one whose neighbours are those of a lattice.
Experiment on_flat_mesh(Experiment experiment, std::size_t columns, std::size_t rows) {
    Lattice lattice;
    lattice.columns = columns;
    lattice.rows = rows;
    lattice.stencil = Stencil::five_point;
    MeshSurface surface = *make_surface(sheet(columns, rows), MeshWeights::uniform);
    surface.adjacency = lattice_adjacency(lattice);
    for (Statement& statement : experiment.prepattern) {
        if (auto* mesh = std::get_if<CreateMesh>(&statement))
            mesh->surface = std::make_shared<const MeshSurface>(std::move(surface));
    }
    return experiment;
}

// How much of `mode` is in the values, by least squares.
double amplitude(const std::vector<double>& values, const std::vector<double>& mode) {
    double both = 0.0, square = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        both += values[i] * mode[i];
        square += mode[i] * mode[i];
    }
    return both / square;
}

struct Decay {
    double eigenvalue = 0.0;  // of minus the Laplacian on a sphere of radius 1
    double rest = 0.0;        // the largest deviation from the mode, of its largest value
};

// Of what begins as that function of X, Y and Z.
Decay decay_of(std::size_t subdivisions, const std::string& mode) {
    const double vertices = 10 * std::pow(4, subdivisions) + 2;
    const double square = vertices / (4 * 3.14159265358979323846);  // of the radius
    const Experiment experiment =
        read("define chemical U floor none\ndefine time_step 0.05\nuse chemical U conc (" + mode +
             ") diff 1\ncreate icosphere " + std::to_string(subdivisions) + " weights cotangent\n");
    const Snapshot first = initial_state(experiment, Precision::double_);
    constexpr std::uint64_t steps = 400;
    const Snapshot last = after(experiment, steps, Precision::double_);
    Decay decay;
    const double left = amplitude(last.conc[0], first.conc[0]);
    decay.eigenvalue = (1 - std::pow(left, 1.0 / steps)) / 0.05 * square;
    double largest = 0.0;
    for (std::size_t i = 0; i < first.cells(); ++i) {
        largest = std::max(largest, std::abs(first.conc[0][i]));
        decay.rest = std::max(decay.rest, std::abs(last.conc[0][i] / left - first.conc[0][i]));
    }
    decay.rest /= largest;
    return decay;
}

}  // namespace

TEST_CASE("on a flat mesh with a lattice's neighbours a run has the lattice's bits") {
    // Where rates differ from cell to cell a lattice goes from neighbour to neighbour, too.
    const std::string uneven = turing + "set cells 3 to 90 chemical V diff 0.25\n";
    const auto matrix = [&](const std::string& start, const std::string& create) {
        return read("define stencil five-point\n" + start.substr(0, start.find("set")) + create +
                    (start.find("set") == std::string::npos ? "" : start.substr(start.find("set"))) + reaction);
    };
    const auto mesh = [&](const std::string& start) {
        std::string text = start;
        text.insert(std::min(text.find("set"), text.size()), "create torus 23 17\n");
        return on_flat_mesh(read(text + reaction), 23, 17);
    };
    for (const Precision precision : {Precision::single_, Precision::double_}) {
        const Snapshot expected = after(matrix(uneven, "create matrix 23 17\n"), 30, precision);
        const bool same = after(mesh(uneven), 30, precision).conc == expected.conc;
        CHECK(same);
    }
}

TEST_CASE("on a flat mesh with equal rates a run has the lattice's numbers but for rounding") {
    const std::string even = "define chemical U\nuse chemical U conc 4 dev 3 diff 0.2\n";
    const Experiment lattice = read("define stencil five-point\n" + even + "create matrix 23 17\n");
    const Experiment mesh = on_flat_mesh(read(even + "create torus 23 17\n"), 23, 17);
    const Snapshot expected = after(lattice, 50), found = after(mesh, 50);
    for (std::size_t i = 0; i < found.cells(); ++i)
        CHECK(found.conc[0][i] == Approx(expected.conc[0][i]).epsilon(1e-5));
}

TEST_CASE("spherical harmonics decay as the Laplacian of the sphere has it, and stay what they are") {
    struct Mode {
        const char* text;
        double eigenvalue;
    };
    for (const Mode& mode : {Mode{"Z", 2}, Mode{"X * Y", 6}, Mode{"Z ^ 3 - 0.6 * 203.8 * Z", 12}}) {
        INFO(mode.text);
        if (mode.eigenvalue > 6) {  // the third one for the radius of four subdivisions
            CHECK(decay_of(4, mode.text).eigenvalue == Approx(12).epsilon(0.02));
            continue;
        }
        const Decay coarse = decay_of(3, mode.text), fine = decay_of(4, mode.text);
        CHECK(fine.eigenvalue == Approx(mode.eigenvalue).epsilon(0.01));
        const double error = std::abs(fine.eigenvalue - mode.eigenvalue);
        CHECK(error < std::max(1e-5, 0.4 * std::abs(coarse.eigenvalue - mode.eigenvalue)));
        CHECK(fine.rest < 0.01);  // no seam along the edges of the icosahedron, nothing at its corners
    }
}

TEST_CASE("what is the same everywhere on a mesh stays so, to the bit") {
    for (const char* weights : {"uniform", "cotangent"}) {
        const Snapshot state =
            after(read("define chemical U\nuse chemical U conc 0.7 diff 0.1\ncreate icosphere 3 weights " +
                       std::string(weights) + "\n"),
                  50);
        for (const double value : state.conc[0]) CHECK(value == state.conc[0][0]);
    }
}

TEST_CASE("exchange by cotangents keeps the amount times the area in a run") {
    const Experiment experiment =
        read("define chemical U\nuse chemical U conc 4 dev 3 diff 0.1\ncreate torus 31 12 weights cotangent\n");
    const std::vector<double> areas = vertex_areas(surface_of(experiment)->mesh);
    const auto amount = [&](const Snapshot& state) {
        double sum = 0.0;
        for (std::size_t i = 0; i < areas.size(); ++i) sum += areas[i] * state.conc[0][i];
        return sum;
    };
    const double before = amount(initial_state(experiment, Precision::double_));
    CHECK(amount(after(experiment, 200, Precision::double_)) == Approx(before).epsilon(1e-12));
}

TEST_CASE("both backends end in the same bits on meshes, states written and read again on the way") {
    const auto reference = reference_backend(Precision::single_);
    const auto device = opencl_backend({});
    for (const char* mesh : {"create icosphere 3\n", "create torus 21 9 weights cotangent\n"}) {
        Experiment experiment =
            read(turing + mesh + reaction +
                 "rule probability 0.1 change V conc 0 dev 0.25\nrule always map U conc 0 8 to M 0 1\n"
                 "rule if Z > 1 set V conc (M * RANDOM)\n");
        experiment.stop_at = 60;
        const verify::EqualRun run = verify::run_both(experiment, *reference, *device, 5);
        CHECK(run.difference.empty());
        CHECK(run.finite);
    }
}

TEST_CASE("the largest stable step of a mesh is near that of its spectrum") {
    Experiment experiment = on_flat_mesh(read(turing + "create torus 23 17\n" + reaction), 23, 17);
    const double found = stiffness(*surface_of(experiment));
    CHECK(found > 7.6);
    CHECK(found < 8.3);
    const std::string unstable = "define chemical U\nuse chemical U conc 1 diff 0.5\ncreate icosphere 2\n";
    CHECK(find_instability(read(unstable), initial_state(read(unstable))).has_value());
    const std::string stable = "define chemical U\nuse chemical U conc 1 diff 0.15\ncreate icosphere 2\n";
    CHECK_FALSE(find_instability(read(stable), initial_state(read(stable))).has_value());
}

TEST_CASE("a state of another number of cells is refused") {
    const Experiment small = read("define chemical U\ncreate icosphere 1\n");
    const Experiment large = read("define chemical U\ncreate icosphere 2\n");
    const auto device = opencl_backend({});
    const auto reference = reference_backend(Precision::single_);

    CHECK_THROWS_WITH(reference->make_tissue(small, initial_state(large)), Catch::Contains("42 vertices"));
    CHECK_THROWS_WITH(device->make_tissue(small, initial_state(large)), Catch::Contains("42 vertices"));
}
