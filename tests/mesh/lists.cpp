// Lists of neighbours in blocks, as the device reads them, and runs on meshes whose cells have unlike numbers of them.
#include "opencl/mesh/lists.hpp"
#include "core/experiment.hpp"
#include "language/parse.hpp"
#include "mesh/shapes.hpp"
#include "mesh/surface.hpp"
#include "opencl/backend.hpp"
#include "reference/backend.hpp"
#include "verify/equal_runs.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>

using namespace pelage;

namespace {

// A cone of so many triangles around its tip, and a row of triangles that hangs on to its edge.
Mesh cone(std::uint32_t around, std::uint32_t tail) {
    Mesh mesh;
    mesh.vertices.push_back({0, 0, 3});
    for (std::uint32_t i = 0; i < around; ++i) {
        const double angle = 2 * 3.14159265358979323846 * i / around;
        mesh.vertices.push_back({4 * std::cos(angle), 4 * std::sin(angle), 0});
        mesh.triangles.push_back({0, i + 1, (i + 1) % around + 1});
    }
    for (std::uint32_t i = 0; i < tail; ++i) {
        const auto last = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back({5.0 + i, i % 2 == 0 ? 1.0 : 0.0, 0.0});
        mesh.triangles.push_back({last - 2, last - 1, last});
    }
    return mesh;
}

// What stands in the blocks, cell by cell, held against the adjacency; the rest of each block must be filled up.
void check(const MeshSurface& surface) {
    const MeshLists lists = mesh_lists(surface);
    const std::size_t blocks = (surface.cells() + mesh_block - 1) / mesh_block;
    REQUIRE(lists.rows.size() == blocks + 1);
    REQUIRE(lists.lengths.size() == blocks * mesh_block);
    REQUIRE(lists.indices.size() == lists.rows.back() * mesh_block);
    REQUIRE(lists.weights.size() == lists.indices.size());
    bool listed = true, filled = true;
    for (std::size_t at = 0; at < blocks * mesh_block; ++at) {
        const bool cell = at < surface.cells();
        const std::size_t id = cell ? surface.order[at] : 0, count = cell ? surface.adjacency.count(id) : 0;
        listed = listed && lists.lengths[at] == static_cast<std::int32_t>(count);
        const std::uint32_t rows = lists.rows[at / mesh_block + 1] - lists.rows[at / mesh_block];
        for (std::size_t k = 0; k < rows; ++k) {
            const std::size_t entry = (lists.rows[at / mesh_block] + k) * mesh_block + at % mesh_block;
            const std::uint32_t there = lists.indices[entry];
            if (k >= count) {
                filled = filled && there == at && lists.weights[entry] == 0;
                continue;
            }
            const std::size_t place = surface.adjacency.offsets[id] + k;
            listed = listed && there < surface.cells() && surface.order[there] == surface.adjacency.indices[place] &&
                     lists.weights[entry] == surface.adjacency.weights[place];
        }
    }
    CHECK(listed);
    CHECK(filled);
}

}  // namespace

TEST_CASE("a mesh's lists hold each cell's neighbours in their order, and the cell itself past their end") {
    check(*make_surface(icosphere(2), MeshWeights::cotangent));
    check(*make_surface(torus(16, 8), MeshWeights::uniform));  // whole blocks
    check(*make_surface(cone(41, 30), MeshWeights::uniform));
    check(*make_surface(cone(3, 0), MeshWeights::uniform));  // less than a block
}

TEST_CASE("a mesh's block has as many rows as its longest list, no more") {
    const MeshLists lists = mesh_lists(*make_surface(cone(41, 30), MeshWeights::uniform));
    for (std::size_t block = 0; block + 1 < lists.rows.size(); ++block) {
        std::int32_t longest = 0;
        for (std::size_t lane = 0; lane < mesh_block; ++lane)
            longest = std::max(longest, lists.lengths[block * mesh_block + lane]);
        CHECK(lists.rows[block + 1] - lists.rows[block] == static_cast<std::uint32_t>(longest));
    }
}

TEST_CASE(
    "cells of a mesh with many and with few neighbours side by side end in the reference's bits, in every width") {
    for (const char* chemicals : {"U", "UV", "UVW"}) {  // a pair, one alone, both
        std::string text = "define time_step 0.0625\n";
        for (const char* c = chemicals; *c != '\0'; ++c)
            text +=
                fmt::format("define chemical {0} floor none\nuse chemical {0} conc 4 dev 1 diff 0.25 dev 0.125\n", *c);
        text +=
            "create icosphere 0\nrule always react U by (laplacian(U) * 0.0625 - 0.01 * U)\n"
            "rule if Z > 1 change U conc (0.25 * NEIGHBORS)\n";
        Experiment experiment = parse_experiment(text, "cone.pex", ".");
        for (Statement& statement : experiment.prepattern) {
            if (auto* mesh = std::get_if<CreateMesh>(&statement))
                mesh->surface = make_surface(cone(41, 30), MeshWeights::uniform);
        }
        experiment.stop_at = 12;
        for (const std::size_t width : {0u, 1u, 2u, 4u, 8u, 16u}) {
            INFO(chemicals << ", width " << width);
            OpenclOptions options;
            options.width = width;
            const verify::EqualRun run =
                verify::run_both(experiment, *reference_backend(Precision::single_), *opencl_backend(options), 5);
            CHECK(run.difference.empty());
            CHECK(run.finite);
        }
    }
}
