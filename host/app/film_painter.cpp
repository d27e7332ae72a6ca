// See film_painter.hpp.
#include "app/film_painter.hpp"

#include "io/brush.hpp"
#include "io/frame_loops.hpp"
#include "io/mesh_results.hpp"
#include "io/output_file.hpp"
#include "io/projection.hpp"
#include "io/relief.hpp"
#include "io/shade.hpp"
#include "io/texture.hpp"

#include <algorithm>
#include <cstdint>
#include <variant>

namespace pelage::app {

namespace {

constexpr std::size_t growing_side = 800;  // pixels: as pictures of free cells have

bool divides(const Experiment& experiment) {
    return std::ranges::any_of(experiment.rules,
                               [](const Rule& rule) { return std::holds_alternative<Divide>(rule.action); });
}

Picture of_greys(const GreyPicture& map) {
    Picture picture(map.columns, map.rows);
    std::ranges::transform(map.pixels, picture.pixels.begin(), [](const auto& pixel) {
        Rgb shade;
        shade.fill(static_cast<std::uint8_t>(pixel[0] >> 8));
        return shade;
    });
    return picture;
}

// As write_output(), in 8 bits.
Picture of_surface(const Surface& surface, const Output& output, const ValueRange& range) {
    const std::span<const double> values = surface.values.front();
    if (output.drawing == Drawing::normal) {
        return normal_map(values, surface.columns, surface.rows,
                          Slopes{output.strength, surface.width, surface.height, surface.wrap});
    }
    if (output.drawing == Drawing::height) {
        return of_greys(height_map(values, surface.columns, surface.rows, range));
    }
    return render(Brush(output, surface.values, range), surface.columns, surface.rows);
}

QuickColours::Word rgb_word(const Rgb& rgb) {
    return QuickColours::Word{rgb[0]} << 16 | QuickColours::Word{rgb[1]} << 8 | rgb[2];
}

Rgb rgb_of(QuickColours::Word word) {
    return {static_cast<std::uint8_t>(word >> 16), static_cast<std::uint8_t>(word >> 8),
            static_cast<std::uint8_t>(word)};
}

void widen_box(CellBox& box, const CellBox& other) {
    for (std::size_t k = 0; k < 2; ++k) {
        box.low[k] = std::min(box.low[k], other.low[k]);
        box.high[k] = std::max(box.high[k], other.high[k]);
    }
}

}  // namespace

void Shot::take(const FilmPlan& plan, const Tissue& tissue) {
    if (!plan.plain) {
        state = tissue.read();
        return;
    }
    columns = tissue.columns();
    rows = tissue.rows();
    tissue.read_conc(plan.output.chemical, values);
}

double Shot::bytes(const FilmPlan& plan, const Experiment& experiment, double cells) {
    if (plan.plain) return cells * sizeof(float);
    const auto columns = static_cast<double>(2 * experiment.chemicals.size() + experiment.mappings.size() + 4);
    return cells * (columns * sizeof(double) + 9);
}

FilmPainter::FilmPainter(const FilmPlan& plan, const Experiment& experiment, const CellDrawing& drawing,
                         const Shot& first)
    : plan_(plan), experiment_(experiment), drawing_(drawing) {
    if (plan.frame) {
        frame_ = *plan.frame;
    } else if (surface_of(experiment) != nullptr) {
        frame_ = {view_side, view_side};
    } else if (divides(experiment)) {
        frame_ = {growing_side, growing_side};
    } else {
        const Drawn drawn(experiment, plan.output, plan.place, first.state);
        const Picture picture = draw_cells(first.state, Brush(plan.output, drawn.columns(), {}), drawing);
        frame_ = {picture.columns + picture.columns % 2, picture.rows + picture.rows % 2};
    }
}

void FilmPainter::paint(const Shot& shot, std::string& to) {
    const bool coloured = plan_.plain && plan_.output.drawing == Drawing::colours;
    const auto times_frame = [&](std::size_t n) {
        return shot.columns == n * frame_.columns && shot.rows == n * frame_.rows;
    };
    if (coloured && !plan_.rgb() && (times_frame(1) || times_frame(2))) {
        const Colours colours(plan_.output, seen(std::span(shot.values)));
        return times_frame(1) ? lattice(shot, colours, to) : halved(shot, colours, to);
    }
    const Picture picture = in_frame(picture_of(shot));
    if (!plan_.rgb()) return write_yuv420(picture, to);
    to.assign(reinterpret_cast<const char*>(picture.pixels.data()), picture.pixels.size() * sizeof(Rgb));
}

Picture FilmPainter::in_frame(Picture picture) const {
    if (picture.columns == frame_.columns && picture.rows == frame_.rows) return picture;
    Scale scale;
    if (plan_.scale) {
        scale = *plan_.scale;
    } else if (picture.columns > frame_.columns || picture.rows > frame_.rows) {
        scale = fitting_scale(picture.columns, picture.rows, frame_.columns, frame_.rows);
    }
    return framed(picture, scale, frame_.columns, frame_.rows);
}

const QuickColours& FilmPainter::quick(bool yuv) {
    std::optional<QuickColours>& found = yuv ? yuv_ : rgb_;
    if (!found) found.emplace(plan_.output, yuv ? yuv_word : rgb_word);
    return *found;
}

const QuickColours& FilmPainter::quick_parts() {
    if (!parts_) parts_.emplace(plan_.output, parts_word);
    return *parts_;
}

Picture FilmPainter::picture_of(const Shot& shot) {
    if (!plan_.plain) return of_state(shot.state);
    if (plan_.output.drawing != Drawing::colours) return map(shot);
    return lattice(shot, Colours(plan_.output, seen(std::span(shot.values))));
}

template <class Value>
ValueRange FilmPainter::seen(std::span<const Value> now) {
    if (plan_.output.range) return {(*plan_.output.range)[0], (*plan_.output.range)[1]};
    if (plan_.output.own_range) return range_of(now);
    range_.widen(range_of(now));
    return range_;
}

void FilmPainter::lattice(const Shot& shot, const Colours& colours, std::string& to) {
    const std::size_t columns = shot.columns;
    std::vector<QuickColours::Word> words(2 * columns);
    Yuv420 planes(columns, shot.rows, to);
    for (std::size_t line = 0; line < shot.rows; line += 2) {  // the values' bottom row comes first
        const float* below = shot.values.data() + (shot.rows - 2 - line) * columns;
        quick(true).draw(colours, below, 2 * columns, words.data());
        planes.put(line, words.data() + columns, words.data());
    }
}

void FilmPainter::halved(const Shot& shot, const Colours& colours, std::string& to) {
    const std::size_t columns = frame_.columns;
    std::vector<QuickColours::Word> words(4 * columns), lines(2 * columns);
    Yuv420 planes(columns, frame_.rows, to);
    for (std::size_t line = 0; line < frame_.rows; ++line) {
        const float* two_rows = shot.values.data() + 2 * (frame_.rows - 1 - line) * shot.columns;
        quick_parts().draw(colours, two_rows, 4 * columns, words.data());
        QuickColours::Word* means = lines.data() + line % 2 * columns;
        mean_words(words.data(), words.data() + 2 * columns, columns, means);
        to_yuv(means, columns, means);
        if (line % 2 == 1) planes.put(line - 1, lines.data(), lines.data() + columns);
    }
}

Picture FilmPainter::lattice(const Shot& shot, const Colours& colours) {
    Picture picture(shot.columns, shot.rows);
    std::vector<QuickColours::Word> words(shot.columns);
    for (std::size_t row = 0; row < shot.rows; ++row) {
        quick(false).draw(colours, shot.values.data() + row * shot.columns, shot.columns, words.data());
        std::ranges::transform(words, &picture.at(0, shot.rows - 1 - row), [](auto word) { return rgb_of(word); });
    }
    return picture;
}

Picture FilmPainter::map(const Shot& shot) {
    const std::vector<double> values(shot.values.begin(), shot.values.end());
    Surface surface{{values}, shot.columns, shot.rows};
    surface.wrap = wraps(experiment_);
    return of_surface(surface, plan_.output, seen(std::span(shot.values)));
}

Picture FilmPainter::of_state(const Snapshot& state) {
    const Drawn drawn(experiment_, plan_.output, plan_.place, state);
    if (plan_.texture) return texture(state, drawn);
    const ValueRange range = seen(drawn.values());
    if (state.volume()) return projection(state, drawn, range);
    if (const MeshSurface* surface = surface_of(experiment_))
        return mesh_view(*surface, plan_.output, Brush(plan_.output, drawn.columns(), range),
                         std::min({frame_.columns, frame_.rows, largest_view}));
    if (!state.lattice()) return cells(state, Brush(plan_.output, drawn.columns(), range));
    Surface surface{drawn.columns(), state.columns, state.rows};
    surface.wrap = wraps(experiment_);
    return of_surface(surface, plan_.output, range);
}

Picture FilmPainter::projection(const Snapshot& state, const Drawn& drawn, const ValueRange& found) {
    const Projection how = projection_of(plan_.output);
    const ValueRange range = drawn_range(plan_.output, drawn.values(), found);
    if (how.kind == Projection::Kind::transparent) {
        const Brush brush(plan_.output, drawn.columns(), range);
        return shallow(transparent_picture(state, brush, drawn.values(), range));
    }
    const Projected shown = projected(how, state, drawn.columns());
    Surface surface{shown.spans(), shown.columns, shown.rows};
    surface.wrap = wraps(experiment_);
    return of_surface(surface, plan_.output, range);
}

Picture FilmPainter::texture(const Snapshot& state, const Drawn& drawn) {
    const auto [columns, rows] = *experiment_.texture;
    std::vector<std::vector<double>> values;
    for (const std::span<const double> column : drawn.columns()) values.emplace_back(column.begin(), column.end());
    const std::vector<Field> fields = interpolate(state, values, columns, rows, wraps(experiment_));
    const auto [width, height] = texel_size(state, columns, rows);
    // A cell is two radii wide.
    Surface surface{{}, columns, rows, width / 2, height / 2, wraps(experiment_), 1};
    for (const Field& field : fields) surface.values.emplace_back(field.values);
    return of_surface(surface, plan_.output, seen(surface.values.front()));
}

// As large as the frame lets it be.
Picture FilmPainter::cells(const Snapshot& state, const Brush& brush) {
    const CellBox box = box_around(state);
    if (!drawing_.box) drawing_.box = box;
    widen_box(*drawing_.box, box);
    const double margin = 2 * margin_of(drawing_.shape);
    const double width = drawing_.box->high[0] - drawing_.box->low[0] + margin;
    const double height = drawing_.box->high[1] - drawing_.box->low[1] + margin;
    const double scale =
        std::min(static_cast<double>(frame_.columns) / width, static_cast<double>(frame_.rows) / height);
    constexpr double rounding = 1e-6;
    drawing_.size = static_cast<std::size_t>(std::max(1.0, scale * std::max(width, height) + rounding));
    return draw_cells(state, brush, drawing_);
}

}  // namespace pelage::app
