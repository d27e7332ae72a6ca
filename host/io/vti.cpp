// Lattices for VTK programs; see vtk.hpp.
#include "core/error.hpp"
#include "io/shape.hpp"
#include "io/vtk.hpp"
#include "io/vtk_xml.hpp"

#include <fmt/format.h>

namespace pelage {

void write_vti(const std::filesystem::path& path, const Snapshot& snapshot, const Experiment& experiment,
               Precision precision) {
    if (!snapshot.on_grid()) throw Error(fmt::format("'{}' cannot be written: free cells are no image", path.string()));
    check_shape(snapshot, experiment);
    AtomicFile file(path);
    const auto extent = fmt::format("0 {} 0 {} 0 {}", snapshot.columns, snapshot.rows, snapshot.layers);
    open_vtk(file, "ImageData", experiment.time_at(snapshot.iteration), snapshot.iteration,
             fmt::format(R"(WholeExtent="{}" Origin="{} {} {}" Spacing="1 1 1")", extent,
                         (snapshot.origin_x - static_cast<double>(snapshot.columns)) / 2,
                         (snapshot.origin_y - static_cast<double>(snapshot.rows)) / 2,
                         snapshot.layers == 0 ? 0.0 : static_cast<double>(snapshot.layers) / -2));
    const auto& first = experiment.chemicals.empty() ? "" : experiment.chemicals[0].name;
    file.write(fmt::format("<Piece Extent=\"{}\">\n<CellData Scalars=\"{}\">\n", extent, xml_escaped(first)));
    for (std::size_t i = 0; i < experiment.chemicals.size(); ++i) {
        const auto value = [&](std::size_t cell) { return snapshot.conc[i][cell]; };
        const auto& name = experiment.chemicals[i].name;
        if (precision == Precision::double_) {
            write_array<double>(file, name, 1, snapshot.cells(), value);
        } else {
            write_array<float>(file, name, 1, snapshot.cells(), value);
        }
    }
    file.write("</CellData>\n</Piece>\n");
    close_vtk(file, "ImageData");
    file.commit();
}

}  // namespace pelage
