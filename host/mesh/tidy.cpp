// See tidy.hpp.
#include "mesh/tidy.hpp"

#include "core/error.hpp"
#include "mesh/edges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace pelage {

namespace {

std::vector<std::uint32_t> counted(std::size_t count) {
    std::vector<std::uint32_t> ids(count);
    std::iota(ids.begin(), ids.end(), 0u);
    return ids;
}

// For each vertex the first at its place. -0 and 0 are the same place.
std::vector<std::uint32_t> firsts(const std::vector<Point>& vertices) {
    std::vector<std::uint32_t> order = counted(vertices.size()), first(vertices.size());
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
        return vertices[a] != vertices[b] ? vertices[a] < vertices[b] : a < b;
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
        first[order[i]] = same ? first[order[i - 1]] : order[i];
    }
    return first;
}

std::size_t join_vertices(Mesh& mesh) {
    const std::vector<std::uint32_t> first = firsts(mesh.vertices);
    for (Triangle& triangle : mesh.triangles) {
        for (std::uint32_t& corner : triangle) corner = first[corner];
    }
    std::size_t joined = 0;
    for (std::size_t i = 0; i < first.size(); ++i) joined += first[i] != i ? 1 : 0;
    return joined;
}

Triangle sorted(Triangle triangle) {
    std::ranges::sort(triangle);
    return triangle;
}

std::size_t leave_out_flat(Mesh& mesh) {
    return std::erase_if(mesh.triangles,
                         [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
}

std::size_t leave_out_doubles(Mesh& mesh) {
    std::vector<std::pair<Triangle, std::uint32_t>> all;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) all.emplace_back(sorted(mesh.triangles[i]), i);
    std::ranges::sort(all);
    std::vector<std::uint8_t> again(all.size(), 0);
    for (std::size_t i = 1; i < all.size(); ++i) again[all[i].second] = all[i].first == all[i - 1].first ? 1 : 0;
    std::size_t place = 0;
    return std::erase_if(mesh.triangles, [&](const Triangle&) { return again[place++] != 0; });
}

std::size_t leave_out_loose(Mesh& mesh) {
    constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> place(mesh.vertices.size(), nowhere);
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle) place[corner] = 0;
    }
    std::uint32_t kept = 0;
    for (std::size_t i = 0; i < place.size(); ++i) {
        if (place[i] == nowhere) continue;
        mesh.vertices[kept] = mesh.vertices[i];
        place[i] = kept++;
    }
    const std::size_t left_out = mesh.vertices.size() - kept;
    mesh.vertices.resize(kept);
    for (Triangle& triangle : mesh.triangles) {
        for (std::uint32_t& corner : triangle) corner = place[corner];
    }
    return left_out;
}

}  // namespace

std::vector<std::string> tidy(Mesh& mesh) {
    std::vector<std::string> notes;
    const auto note = [&](std::size_t count, const char* one, const char* many, const char* what) {
        if (count != 0) notes.push_back(fmt::format("{} {} {}", count, count == 1 ? one : many, what));
    };
    const std::size_t joined = join_vertices(mesh);
    note(joined, "vertex", "vertices", "at the very place of another: joined");
    note(leave_out_flat(mesh), "triangle", "triangles", "with two corners in one place: left out");
    note(leave_out_doubles(mesh), "triangle", "triangles", "on the corners of another: left out");
    if (mesh.triangles.empty()) throw Error("no triangle with three corners in three places is left");
    note(leave_out_loose(mesh) - joined, "vertex", "vertices", "that no triangle names: left out");
    const std::vector<Edge> edges = edges_of(mesh);
    note(static_cast<std::size_t>(std::ranges::count_if(edges, [](const Edge& e) { return e.triangles > 2; })), "edge",
         "edges", "of more than two triangles: kept");
    return notes;
}

}  // namespace pelage
