// VTK's surfaces; see mesh_file.hpp.
#include "io/mesh_file.hpp"
#include "io/vtk_xml.hpp"

#include <fmt/format.h>

namespace pelage {

namespace {

template <class T>
void write_surface(AtomicFile& file, const Mesh& mesh, const std::vector<VertexValues>& values) {
    file.write("<Points>\n");
    write_array<T>(file, "place", 3, 3 * mesh.vertices.size(),
                   [&](std::size_t i) { return mesh.vertices[i / 3][i % 3]; });
    file.write("</Points>\n<Polys>\n");
    write_array<std::int64_t>(file, "connectivity", 1, 3 * mesh.triangles.size(),
                              [&](std::size_t i) { return mesh.triangles[i / 3][i % 3]; });
    write_array<std::int64_t>(file, "offsets", 1, mesh.triangles.size(), [](std::size_t i) { return 3 * (i + 1); });
    const std::string first = values.empty() ? "" : values[0].name;
    file.write(fmt::format("</Polys>\n<PointData Scalars=\"{}\">\n", xml_escaped(first)));
    for (const VertexValues& one : values)
        write_array<T>(file, one.name, 1, one.values.size(), [&](std::size_t i) { return one.values[i]; });
    file.write("</PointData>\n");
}

}  // namespace

void write_mesh_vtp(const std::filesystem::path& path, const Mesh& mesh, const std::vector<VertexValues>& values,
                    double time, std::uint64_t iteration, Precision precision) {
    AtomicFile file(path);
    open_vtk(file, "PolyData", time, iteration);
    file.write(
        fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
                    "NumberOfPolys=\"{}\">\n",
                    mesh.vertices.size(), mesh.triangles.size()));
    if (precision == Precision::double_) {
        write_surface<double>(file, mesh, values);
    } else {
        write_surface<float>(file, mesh, values);
    }
    file.write("</Piece>\n");
    close_vtk(file, "PolyData");
    file.commit();
}

}  // namespace pelage
