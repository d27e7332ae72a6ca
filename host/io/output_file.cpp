// See output_file.hpp.
#include "io/output_file.hpp"

#include "io/picture.hpp"
#include "io/relief.hpp"

namespace pelage {
namespace {

void write_colours(const std::filesystem::path& path, const Surface& surface, const Colours& colours, bool deep) {
    const auto [values, columns, rows, width, height, wrap, factor] = surface;
    if (deep) return write_png(path, enlarged(render_deep(values, columns, rows, colours), factor));
    write_png(path, enlarged(render(values, columns, rows, colours), factor));
}

void write_normals(const std::filesystem::path& path, const Surface& surface, double strength, bool deep) {
    const auto [values, columns, rows, width, height, wrap, factor] = surface;
    const Slopes slopes{strength, width, height, wrap};
    if (deep) return write_png(path, normal_map_deep(values, columns, rows, slopes));
    write_png(path, normal_map(values, columns, rows, slopes));
}

}  // namespace

ValueRange drawn_range(const Output& output, std::span<const double> values, const std::optional<ValueRange>& shared) {
    if (output.range) return {(*output.range)[0], (*output.range)[1]};
    return shared ? *shared : range_of(values);
}

void write_output(const std::filesystem::path& path, const Surface& surface, const Output& output,
                  const std::optional<ValueRange>& shared, bool deep) {
    switch (output.drawing) {
        case Drawing::colours:
            return write_colours(path, surface, Colours(output, drawn_range(output, surface.values, shared)), deep);
        case Drawing::height:
            return write_png(path, height_map(surface.values, surface.columns, surface.rows,
                                              drawn_range(output, surface.values, shared)));
        case Drawing::normal:
            return write_normals(path, surface, output.strength, deep);
    }
}

}  // namespace pelage
