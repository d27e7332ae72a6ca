// Free cells for VTK programs; see vtk.hpp.
#include "io/shape.hpp"
#include "io/vtk.hpp"
#include "io/vtk_xml.hpp"

#include <fmt/format.h>

namespace pelage {
namespace {

// (x, y, 0) of each cell.
template <class T>
void write_vectors(AtomicFile& file, std::string_view name, const std::vector<double>& x,
                   const std::vector<double>& y) {
    write_array<T>(file, name, 3, 3 * x.size(), [&](std::size_t i) {
        return i % 3 == 0 ? x[i / 3] : i % 3 == 1 ? y[i / 3] : 0.0;
    });
}

template <class T, class Values>
void write_values(AtomicFile& file, std::string_view name, const Values& values) {
    write_array<T>(file, name, 1, values.size(), [&](std::size_t i) { return values[i]; });
}

template <class T>
void write_piece(AtomicFile& file, const Snapshot& cells, const Experiment& experiment) {
    const auto identity = [](std::size_t i) { return i; };
    file.write("<Points>\n");
    write_vectors<T>(file, "centre", cells.x, cells.y);
    file.write("</Points>\n<Verts>\n");
    write_array<std::int64_t>(file, "connectivity", 1, cells.cells(), identity);
    write_array<std::int64_t>(file, "offsets", 1, cells.cells(), [](std::size_t i) { return i + 1; });
    const auto first = experiment.chemicals.empty() ? "" : "conc " + experiment.chemicals[0].name;
    file.write(fmt::format("</Verts>\n<PointData Scalars=\"{}\" Vectors=\"polarity\">\n", xml_escaped(first)));
    write_array<std::int64_t>(file, "id", 1, cells.cells(), identity);
    write_values<std::int64_t>(file, "birth", cells.birth);
    write_values<std::int32_t>(file, "neighbours", cells.neighbours);
    write_values<std::uint8_t>(file, "fixed", cells.fixed);
    write_vectors<T>(file, "polarity", cells.polarity_x, cells.polarity_y);
    for (std::size_t i = 0; i < experiment.chemicals.size(); ++i) {
        write_values<T>(file, "conc " + experiment.chemicals[i].name, cells.conc[i]);
        write_values<T>(file, "diff " + experiment.chemicals[i].name, cells.diff[i]);
    }
    file.write("</PointData>\n");
}

}  // namespace

void write_vtp(const std::filesystem::path& path, const Snapshot& snapshot, const Experiment& experiment,
               Precision precision) {
    check_shape(snapshot, experiment);
    AtomicFile file(path);
    open_vtk(file, "PolyData", experiment.time_at(snapshot.iteration), snapshot.iteration);
    file.write(
        fmt::format("<Piece NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
                    "NumberOfPolys=\"0\">\n",
                    snapshot.cells()));
    if (precision == Precision::double_) {
        write_piece<double>(file, snapshot, experiment);
    } else {
        write_piece<float>(file, snapshot, experiment);
    }
    file.write("</Piece>\n");
    close_vtk(file, "PolyData");
    file.commit();
}

}  // namespace pelage
