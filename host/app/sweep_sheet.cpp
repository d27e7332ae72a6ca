// See sweep_sheet.hpp.
#include "app/sweep_sheet.hpp"

#include "app/draw_report.hpp"
#include "io/atomic_file.hpp"
#include "io/drawn.hpp"
#include "io/locked.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace pelage::app {

namespace {

using nlohmann::ordered_json;

// Four digits: labels must be short.
std::string label(const std::string& value) { return fmt::format("{:.4g}", std::stod(value)); }

// Values along the upward axis: of the second parameter, or of all further ones and the replicates.
ordered_json upward(const std::vector<sweep::Axis>& axes, std::size_t replicates) {
    std::vector<std::string> labels{""};
    std::string name;
    for (std::size_t i = 1; i < axes.size(); ++i) {
        std::vector<std::string> more;
        for (const std::string& value : axes[i].values) {
            for (const std::string& before : labels)
                more.push_back((before.empty() ? "" : before + ", ") + label(value));
        }
        labels = std::move(more);
        name += (name.empty() ? "" : ", ") + axes[i].name;
    }
    if (replicates > 1) {
        std::vector<std::string> more;
        for (std::size_t n = 0; n < replicates; ++n) {
            for (const std::string& before : labels)
                more.push_back(before.empty() ? std::to_string(n) : fmt::format("{}, {}", before, n));
        }
        labels = std::move(more);
        name += name.empty() ? "replicate" : ", replicate";
    }
    return {{"name", name}, {"values", labels}};
}

ordered_json colours_of(const Output& output, const ValueRange& range) {
    ordered_json colours = ordered_json::array();
    const Colours colour(output, range);
    constexpr int steps = 100;
    for (int i = 0; i <= steps; ++i) {
        const Rgb rgb = colour(range.low + (range.high - range.low) * i / steps);
        colours.push_back({rgb[0], rgb[1], rgb[2]});
    }
    return colours;
}

constexpr std::size_t largest_sheet = 32'000;  // what cairo draws, less room for labels

bool too_large(const Picture& picture) { return std::max(picture.columns, picture.rows) > largest_sheet; }

}  // namespace

std::string draw_sheet(const std::filesystem::path& folder, const Experiment& experiment,
                       const std::vector<sweep::Axis>& axes, std::size_t replicates,
                       const std::vector<sweep::TilePicture>& tiles, std::size_t across, const std::string& ending,
                       const std::string& title) {
    constexpr std::size_t least = 96;  // pixels of a tile's longer side
    const Output& output = experiment.outputs.at(first_of_colours(experiment.outputs));
    const sweep::Layout layout = sweep::layout(axes, tiles.size(), across);
    sweep::Mosaic mosaic = sweep::mosaic(tiles, layout, output, least);
    if (too_large(mosaic.picture)) mosaic = sweep::mosaic(tiles, layout, output, 1);
    if (mosaic.picture.pixels.empty()) return "no tile could be drawn, so there is no contact sheet";
    if (too_large(mosaic.picture))
        return fmt::format(
            "a sheet of {} x {} pixels cannot be drawn, {} are the most; the table and --format have "
            "what the tiles are",
            mosaic.picture.columns, mosaic.picture.rows, largest_sheet);
    if (!plotter_is_there()) {
        write_png(folder / "sheet.png", mosaic.picture);
        return "sheet.png has no labels: pelage-plot, which writes them, is not built (it needs libcairo2-dev)";
    }
    const PrivateFolder work(std::filesystem::temp_directory_path(), "pelage-sheet-");
    write_png(work.path() / "mosaic.png", mosaic.picture);
    ordered_json sheet{{"title", title},
                       {"mosaic", (work.path() / "mosaic.png").string()},
                       {"tile", {mosaic.tile_columns, mosaic.tile_rows}},
                       {"gap", sweep::gap},
                       {"layout", {layout.across, layout.down}}};
    if (!axes.empty()) {
        std::vector<std::string> values;
        for (const std::string& value : axes.front().values) values.push_back(label(value));
        sheet["x"] = {{"name", axes.front().name}, {"values", values}};
        sheet["y"] = upward(axes, replicates);
    }
    if (!output.rgb()) {
        sheet["range"] = {mosaic.range.low, mosaic.range.high};
        sheet["colours"] = colours_of(output, mosaic.range);
    }
    write_file(work.path() / "sheet.json", sheet.dump() + "\n");
    draw_report(work.path() / "sheet.json", folder / ("sheet." + ending));
    return {};
}

}  // namespace pelage::app
