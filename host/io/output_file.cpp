// See output_file.hpp.
#include "io/output_file.hpp"

#include "io/brush.hpp"
#include "io/picture.hpp"
#include "io/relief.hpp"

namespace pelage {
namespace {

void write_colours(const std::filesystem::path& path, const Surface& surface, const Brush& brush, bool deep) {
    if (deep) return write_png(path, enlarged(render_deep(brush, surface.columns, surface.rows), surface.factor));
    write_png(path, enlarged(render(brush, surface.columns, surface.rows), surface.factor));
}

void write_normals(const std::filesystem::path& path, const Surface& surface, double strength, bool deep) {
    const std::span<const double> values = surface.values.front();
    const Slopes slopes{strength, surface.width, surface.height, surface.wrap};
    if (deep) return write_png(path, normal_map_deep(values, surface.columns, surface.rows, slopes));
    write_png(path, normal_map(values, surface.columns, surface.rows, slopes));
}

}  // namespace

ValueRange drawn_range(const Output& output, std::span<const double> values, const std::optional<ValueRange>& shared) {
    if (output.range) return {(*output.range)[0], (*output.range)[1]};
    return shared ? *shared : range_of(values);
}

void write_output(const std::filesystem::path& path, const Surface& surface, const Output& output,
                  const std::optional<ValueRange>& shared, bool deep) {
    const std::span<const double> values = surface.values.front();
    switch (output.drawing) {
        case Drawing::colours:
            return write_colours(path, surface, Brush(output, surface.values, drawn_range(output, values, shared)),
                                 deep);
        case Drawing::height:
            return write_png(path,
                             height_map(values, surface.columns, surface.rows, drawn_range(output, values, shared)));
        case Drawing::normal:
            return write_normals(path, surface, output.strength, deep);
    }
}

}  // namespace pelage
