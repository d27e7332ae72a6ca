// See result_plan.hpp.
#include "io/result_plan.hpp"

#include "io/exr.hpp"
#include "io/mesh_results.hpp"
#include "io/npy.hpp"
#include "io/parallel.hpp"
#include "io/picture.hpp"
#include "io/projection.hpp"
#include "io/texture.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <thread>

namespace pelage {
namespace {

constexpr std::size_t cells_worth_threads = std::size_t{1} << 16;  // cells

// A chemical's name as part of a file's.
std::string file_word(const std::string& name) {
    std::string word = name;
    for (char& c : word) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_') c = '_';
    }
    return word;
}

bool of_colours(const Output& output) { return output.drawing == Drawing::colours; }

}  // namespace

ResultPlan::ResultPlan(const std::filesystem::path& folder, std::string stem, const Snapshot& snapshot,
                       const Experiment& experiment, const ResultOptions& options)
    : folder_(folder),
      stem_(std::move(stem)),
      snapshot_(snapshot),
      experiment_(experiment),
      options_(options),
      attributes_(options.attributes),
      outputs_(experiment.outputs) {
    attributes_["iteration"] = std::to_string(snapshot.iteration);
    attributes_["time"] = fmt::format("{}", experiment.time_at(snapshot.iteration));
    std::string& names = attributes_[exr_chemicals];
    for (const auto& chemical : experiment.chemicals) names += (names.empty() ? "" : " ") + chemical.name;
    main_ = first_of_colours(outputs_);
    if (main_ == outputs_.size()) outputs_.emplace_back();
}

std::vector<std::string> ResultPlan::write() {
    for (const FormatRow& row : format_table()) {
        if (wanted(row.format)) plan(row);
    }
    if (experiment_.texture && (wanted(Format::exr) || wanted(Format::png)))
        plan_texture((*experiment_.texture)[0], (*experiment_.texture)[1]);
    if (options_.before) options_.before(files_);
    const bool large = snapshot_.cells() >= cells_worth_threads || experiment_.texture;
    run_together(work_, large ? std::thread::hardware_concurrency() : 1);
    return files_;
}

bool ResultPlan::wanted(Format format) const {
    return std::find(options_.formats.begin(), options_.formats.end(), format) != options_.formats.end();
}

template <class Write>
void ResultPlan::add(const std::string& file, Write write) {
    names_.push_back(file);
    files_.push_back(file);
    work_.emplace_back([this, file, write] {
        if (options_.begins) {
            const std::lock_guard guard(telling_);
            options_.begins(file);
        }
        write(folder_ / file);
    });
}

template <class Write>
void ResultPlan::add_picture(std::size_t output, const std::string& file, Write write) {
    if (!options_.ranged_only || shared_range(output)) return add(file, write);
    names_.push_back(file);
}

// STEM.NAME.png, or STEM.NAME-2.png when that is taken.
std::string ResultPlan::free_name(const std::string& stem, const std::string& name, const std::string& ending) const {
    const auto word = file_word(name);
    auto file = fmt::format("{}.{}{}", stem, word, ending);
    for (int n = 2; std::find(names_.begin(), names_.end(), file) != names_.end(); ++n) {
        file = fmt::format("{}.{}-{}{}", stem, word, n, ending);
    }
    return file;
}

std::string ResultPlan::picture_name(const std::string& stem, const Output& output, bool first) const {
    const std::string name = output_name(experiment_, output);
    if (output.drawing == Drawing::height) return free_name(stem, name, ".height.png");
    if (output.drawing == Drawing::normal) return free_name(stem, name, ".normal.png");
    return first ? stem + ".png" : free_name(stem, name, ".png");
}

void ResultPlan::plan(const FormatRow& row) {
    if (row.format == Format::exr && snapshot_.lattice())
        plan_layers(stem_ + ".exr", snapshot_.columns, snapshot_.rows, {snapshot_.conc.begin(), snapshot_.conc.end()});
    if (row.format == Format::exr && snapshot_.volume())
        add(stem_ + ".exr", [this](const auto& path) { write_stack(path); });
    if (row.format == Format::png) plan_pictures();
    if (row.format == Format::npy) plan_arrays();
    if (row.format == Format::ply && surface_of(experiment_) != nullptr) plan_ply();
    const StateFile& file = snapshot_.on_grid()                  ? row.lattice
                            : surface_of(experiment_) != nullptr ? row.mesh
                                                                 : row.cells;
    if (file.write == nullptr) return;
    add(stem_ + file.ending,
        [this, write = file.write](const auto& path) { write(path, snapshot_, experiment_, options_.precision); });
}

void ResultPlan::plan_layers(const std::string& file, std::size_t columns, std::size_t rows, const Layers& layers) {
    add(file, [this, columns, rows, layers](const auto& path) { write_layers(path, columns, rows, layers); });
}

// Y is what other programs show of a picture without R, G and B. There 16 bits will do.
void ResultPlan::write_layers(const std::filesystem::path& path, std::size_t columns, std::size_t rows,
                              const Layers& layers) const {
    std::vector<ExrChannel> channels;
    bool taken = false;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        channels.push_back({experiment_.chemicals[i].name, layers[i], options_.exr_type});
        taken = taken || channels.back().name == "Y";
    }
    if (!taken) channels.push_back({"Y", layers[outputs_[main_].chemical], ExrType::half});
    write_exr(path, columns, rows, channels, attributes_);
}

void ResultPlan::plan_pictures() {
    plan_picture(main_);
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
        const bool possible = snapshot_.on_grid() || of_colours(outputs_[i]);
        if (i != main_ && possible) plan_picture(i);
    }
}

void ResultPlan::plan_picture(std::size_t output) {
    add_picture(output, picture_name(stem_, outputs_[output], output == main_),
                [this, output](const auto& path) { write_picture(path, output); });
}

// Its colours are those of the main picture.
void ResultPlan::plan_ply() {
    add_picture(main_, stem_ + ".ply", [this](const auto& path) {
        const Output& output = outputs_[main_];
        const Drawn drawn = this->drawn(main_);
        const Brush brush(output, drawn.columns(), drawn_range(output, drawn.values(), shared_range(main_)));
        write_coloured_mesh(path, *surface_of(experiment_), brush, options_.precision);
    });
}

std::optional<ValueRange> ResultPlan::shared_range(std::size_t output) const {
    return output < options_.ranges.size() ? options_.ranges[output] : std::nullopt;
}

Drawn ResultPlan::drawn(std::size_t output) const {
    if (output < options_.values.size() && options_.values[output]) return Drawn(*options_.values[output]);
    return Drawn(experiment_, outputs_[output], output, snapshot_);
}

void ResultPlan::write_picture(const std::filesystem::path& path, std::size_t index) const {
    if (snapshot_.volume()) return write_projection(path, index);
    const Output& output = outputs_[index];
    const Drawn drawn = this->drawn(index);
    if (snapshot_.lattice()) {
        Surface surface{drawn.columns(), snapshot_.columns, snapshot_.rows};
        surface.wrap = wraps(experiment_);
        surface.factor =
            options_.enlargement != 0 ? options_.enlargement : enlargement(snapshot_.columns, snapshot_.rows);
        return write_output(path, surface, output, shared_range(index), options_.deep_png);
    }
    const Brush brush(output, drawn.columns(), drawn_range(output, drawn.values(), shared_range(index)));
    const MeshSurface* surface = surface_of(experiment_);
    const auto picture =
        surface != nullptr ? mesh_view(*surface, output, brush) : draw_cells(snapshot_, brush, options_.drawing);
    if (options_.deep_png) return write_png(path, deepened(picture));
    write_png(path, picture);
}

// Of a volume, in the range that all its cells have.
void ResultPlan::write_projection(const std::filesystem::path& path, std::size_t index) const {
    const Output& output = outputs_[index];
    const Drawn drawn = this->drawn(index);
    const ValueRange range = drawn_range(output, drawn.values(), shared_range(index));
    const Projection projection = projection_of(output);
    if (projection.kind == Projection::Kind::transparent) {
        const Brush brush(output, drawn.columns(), range);
        const DeepPicture picture = enlarged(transparent_picture(snapshot_, brush, drawn.values(), range),
                                             enlargement(snapshot_.columns, snapshot_.rows));
        return options_.deep_png ? write_png(path, picture) : write_png(path, shallow(picture));
    }
    const Projected shown = projected(projection, snapshot_, drawn.columns());
    Surface surface{shown.spans(), shown.columns, shown.rows};
    surface.wrap = wraps(experiment_);
    surface.factor = enlargement(shown.columns, shown.rows);
    write_output(path, surface, output, range, options_.deep_png);
}

// A channel for each chemical and layer, L0000.NAME, and in Y the middle layer.
void ResultPlan::write_stack(const std::filesystem::path& path) const {
    const std::size_t layer = snapshot_.columns * snapshot_.rows;
    const auto part = [&](std::size_t chemical, std::size_t nth) {
        return std::span<const double>(snapshot_.conc[chemical]).subspan(nth * layer, layer);
    };
    std::vector<ExrChannel> channels;
    for (std::size_t nth = 0; nth < snapshot_.layers; ++nth) {
        for (std::size_t i = 0; i < snapshot_.conc.size(); ++i)
            channels.push_back(
                {fmt::format("L{:04}.{}", nth, experiment_.chemicals[i].name), part(i, nth), options_.exr_type});
    }
    channels.push_back({"Y", part(outputs_[main_].chemical, snapshot_.layers / 2), ExrType::half});
    write_exr(path, snapshot_.columns, snapshot_.rows, channels, attributes_);
}

void ResultPlan::plan_arrays() {
    std::vector<std::size_t> shape{snapshot_.cells()};
    if (snapshot_.on_grid()) shape = {snapshot_.rows, snapshot_.columns};
    if (snapshot_.volume()) shape.insert(shape.begin(), snapshot_.layers);
    const auto type = options_.precision == Precision::double_ ? NpyType::float64 : NpyType::float32;
    for (std::size_t i = 0; i < experiment_.chemicals.size(); ++i) {
        add(free_name(stem_, experiment_.chemicals[i].name, ".npy"),
            [this, i, shape, type](const auto& path) { write_npy(path, shape, snapshot_.conc[i], type); });
    }
}

void ResultPlan::plan_texture(std::size_t columns, std::size_t rows) {
    std::vector<std::vector<double>> values = snapshot_.conc;
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
        if (outputs_[i].expressions.empty()) continue;
        const Drawn drawn = this->drawn(i);
        for (const std::span<const double> column : drawn.columns()) values.emplace_back(column.begin(), column.end());
    }
    textures_ = interpolate(snapshot_, values, columns, rows, wraps(experiment_));
    const std::string stem = stem_ == "final" ? "texture" : stem_ + ".texture";
    if (wanted(Format::exr)) {
        Layers layers;
        for (std::size_t i = 0; i < snapshot_.conc.size(); ++i) layers.emplace_back(textures_[i].values);
        plan_layers(stem + ".exr", columns, rows, layers);
    }
    if (wanted(Format::png)) plan_texture_pictures(stem, columns, rows);
}

void ResultPlan::plan_texture_pictures(const std::string& stem, std::size_t columns, std::size_t rows) {
    const auto [width, height] = texel_size(snapshot_, columns, rows);
    std::size_t next = snapshot_.conc.size();  // texture of an expression
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
        const Output& output = outputs_[i];
        Layers values;
        if (output.expressions.empty()) values.emplace_back(textures_[output.chemical].values);
        for (std::size_t n = 0; n < output.expressions.size(); ++n) values.emplace_back(textures_[next++].values);
        if (i != main_ && of_colours(output)) continue;
        // A cell is two radii wide.
        const Surface surface{values, columns, rows, width / 2, height / 2, wraps(experiment_), 1};
        add_picture(i, picture_name(stem, output, i == main_), [this, surface, i](const auto& path) {
            write_output(path, surface, outputs_[i], shared_range(i), options_.deep_png);
        });
    }
}

}  // namespace pelage
