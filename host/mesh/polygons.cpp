// See polygons.hpp.
#include "mesh/polygons.hpp"

#include <fmt/format.h>

#include <cmath>

namespace pelage {

std::string add_polygon(Mesh& mesh, const std::vector<std::uint32_t>& corners) {
    if (corners.size() < 3) return fmt::format("a face of {} corners; at least 3 are needed", corners.size());
    if (corners.size() > largest_polygon)
        return fmt::format("a face of {} corners; at most {} are allowed", corners.size(), largest_polygon);
    if (mesh.triangles.size() + corners.size() - 2 > largest_triangle_count)
        return fmt::format("more than {} triangles", largest_triangle_count);
    for (std::size_t i = 2; i < corners.size(); ++i) mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
    return {};
}

std::string coordinate_fault(double value) {
    if (std::abs(value) <= largest_coordinate) return {};
    return fmt::format("the coordinate {}; allowed are numbers from -{} to {}", value, largest_coordinate,
                       largest_coordinate);
}

}  // namespace pelage
