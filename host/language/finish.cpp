// The end of the file: defaults, and the checks that only the whole experiment allows.
#include "core/fields.hpp"
#include "core/space.hpp"
#include "language/script.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage::language {

namespace {

// Iterations before `stop` at which the rule acts.
std::uint64_t occasions(const Rule& rule, std::uint64_t stop) {
    if (stop == 0) return 0;
    const std::uint64_t last = std::min(rule.until, stop - 1);
    const std::uint64_t start = rule.origin + rule.offset;
    std::uint64_t first = std::max(rule.from, start);
    const std::uint64_t past = (first - start) % rule.every;
    if (past != 0) first += rule.every - past;
    return first > last ? 0 : (last - first) / rule.every + 1;
}

}  // namespace

Experiment Script::finish() {
    if (!in_phase()) {
        before_.rates.assign(experiment.chemicals.size(), std::nullopt);
        experiment.phases.push_back(before_);
        phase_end_ = 10000;
    }
    experiment.stop_at = stop.value_or(phase_end_);
    auto& snaps = experiment.snap_at;
    std::sort(snaps.begin(), snaps.end());
    snaps.erase(std::unique(snaps.begin(), snaps.end()), snaps.end());
    check_settings();
    check_contents();
    finish_previous();
    check_arrangement();
    check_pictures();
    check_maps();
    check_growth();
    check_starts();
    finish_outputs();
    validate(experiment);
    compute_places_once(experiment);
    set_in_text();
    return std::move(experiment);
}

void Script::check_contents() const {
    const Place end{std::max<std::size_t>(line_, 1), 1};
    if (experiment.chemicals.empty()) {
        throw error_at(experiment, end, "the file ends without a chemical; write 'define chemical NAME'");
    }
    if (cells_ == 0) throw error_at(experiment, end, "the file ends without cells; write 'create ...'");
}

void Script::check_arrangement() const {
    const auto refuse = [&](const Demand& demand, std::string_view text) {
        throw error_at(experiment, demand.place, fmt::format("'{}' {}", demand.statement, text));
    };
    if (volume_) {
        for (const auto& demand : {needs_plane_, needs_matrix_, refuses_matrix_})
            if (demand) refuse(*demand, "belongs to a plane; 'create volume' makes a volume");
    }
    if (mesh_) {
        for (const auto& demand : {needs_plane_, needs_matrix_, refuses_matrix_, needs_lattice_})
            if (demand) refuse(*demand, "belongs to a plane; this experiment creates a mesh");
    }
    if (needs_mesh_ && !mesh_) refuse(*needs_mesh_, "belongs to a mesh; write 'create mesh \"FILE.obj\"'");
    if (needs_depth_ && !volume_ && !mesh_)
        refuse(*needs_depth_, "belongs to a volume or a mesh; write 'create volume COLUMNS ROWS LAYERS'");
    if (needs_volume_ && !volume_)
        refuse(*needs_volume_, "belongs to a volume; write 'create volume COLUMNS ROWS LAYERS'");
    if (needs_matrix_ && !matrix_) refuse(*needs_matrix_, "needs a matrix; write 'create matrix COLUMNS ROWS'");
    if (refuses_matrix_ && matrix_)
        refuse(*refuses_matrix_, "needs free cells; the elements of a matrix stay in place");
    const auto refuse_free_cells = [&](const std::optional<Demand>& demand, const char* others) {
        if (!demand || keeps_places(space_of(experiment))) return;
        refuse(*demand,
               fmt::format("needs a lattice (a matrix, or a single sqr_grid without 'divide' and 'move'){}; free cells "
                           "have X and Y",
                           others));
    };
    refuse_free_cells(needs_lattice_, " or a volume");
    refuse_free_cells(needs_places_, ", a volume or a mesh");
}

void Script::check_pictures() const {
    if (pictures_.empty()) return;
    const Space space = space_of(experiment);
    const auto* lattice = std::get_if<Lattice>(&space);
    for (const Picture& picture : pictures_) {
        const Field& field = *experiment.chemicals[picture.chemical].initial;
        if (lattice != nullptr && field.columns == lattice->columns && field.rows == lattice->rows) continue;
        const std::string wanted = lattice == nullptr
                                       ? "only lattices start from pictures"
                                       : fmt::format("the lattice is {} x {}", lattice->columns, lattice->rows);
        throw error_at(experiment, picture.place,
                       fmt::format("the picture is {} x {}; {}", field.columns, field.rows, wanted));
    }
}

void Script::check_maps() const {
    if (!draws_map_ || experiment.texture || on_grid(space_of(experiment))) return;
    if (mesh_)
        throw error_at(experiment, draws_map_->place, "a mesh makes no height or normal map; it makes .ply files");
    throw error_at(experiment, draws_map_->place,
                   "free cells make no height or normal map by themselves; add 'texture size WIDTH HEIGHT'");
}

void Script::check_growth() const {
    if (expansions_.empty()) return;
    const auto matrix = std::get<Lattice>(space_of(experiment));
    std::uint64_t columns = matrix.columns;
    std::uint64_t rows = matrix.rows;
    auto place = expansions_.begin();
    for (const Rule& rule : experiment.rules) {
        const auto* expand = std::get_if<Expand>(&rule.action);
        if (expand == nullptr) continue;
        const std::uint64_t times = occasions(rule, experiment.last_iteration());
        columns += times * expand->columns;
        rows += times * expand->rows;
        if (columns > largest_cell_count || rows > largest_cell_count / columns) {
            throw error_at(experiment, *place,
                           fmt::format("the matrix grows to {} x {} elements; at most {} cells are allowed", columns,
                                       rows, largest_cell_count));
        }
        ++place;
    }
}

Place Script::place_of(const StartFault& fault) const {
    if (fault.statement) {
        const StartPlace& place = starts_[*fault.statement];
        return fault.rate ? place.diff : place.conc;
    }
    const auto of_chemical = [&](const Picture& picture) { return picture.chemical == fault.picture; };
    return std::ranges::find_if(pictures_, of_chemical)->place;
}

void Script::check_starts() const {
    for (const StartFault& fault : start_faults(experiment)) {
        if (fault.refused) throw error_at(experiment, place_of(fault), fault.text);
    }
}

Colormap Script::colormap(const ColormapChoice& choice) const {
    Colormap map{choice.name, choice.stops};
    if (choice.name != "striped" && choice.name != "gradient") return map;
    for (std::size_t slot = 0; slot < slots.size(); ++slot) {
        if (slots[slot]) map.stops.push_back({static_cast<double>(slot) / 99.0, *slots[slot]});
    }
    if (map.stops.empty()) map.stops = {{0.0, {0, 0, 0}}, {1.0, {255, 255, 255}}};
    return map;
}

void Script::finish_outputs() {
    for (PendingOutput& pending : outputs) {
        pending.output.colormap = colormap(pending.colormap.value_or(selected));
        experiment.outputs.push_back(pending.output);
    }
    const auto& all = experiment.outputs;
    if (std::any_of(all.begin(), all.end(), [](const Output& one) { return one.drawing == Drawing::colours; })) return;
    experiment.outputs.insert(experiment.outputs.begin(), Output{0, colormap(selected), std::nullopt});
}

}  // namespace pelage::language
