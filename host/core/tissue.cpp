// See tissue.hpp.
#include "core/tissue.hpp"

#include "core/columns.hpp"
#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "core/seed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

namespace pelage {

namespace {

void check_length(const char* what, std::size_t found, std::size_t wanted) {
    if (found != wanted)
        throw Error(fmt::format("the state's {} has {} entries; the experiment needs {}", what, found, wanted));
}

void check_shape(const Experiment& experiment, const Snapshot& snapshot) {
    const std::size_t cells = snapshot.cells();
    check_length("list of concentrations", snapshot.conc.size(), experiment.chemicals.size());
    check_length("list of rates", snapshot.diff.size(), experiment.chemicals.size());
    check_length("list of mappings", snapshot.mappings.size(), experiment.mappings.size());
    each_cell_column([&](const char* name, const auto& column) { check_length(name, column.size(), cells); }, snapshot);
    if (snapshot.lattice()) check_length("lattice", snapshot.columns * snapshot.rows, cells);
    if (snapshot.volume()) check_length("volume", snapshot.columns * snapshot.rows * snapshot.layers, cells);
    if (cells == 0) throw Error("the state has no cells");
}

// Of n cells each has its place: the first ones are all in it, and none of them twice.
void check_order(const Snapshot& snapshot) {
    std::vector<bool> found(snapshot.order.size());
    for (const std::uint32_t cell : snapshot.order) {
        const std::size_t most = std::min(found.size(), snapshot.cells());
        if (cell >= most || found[cell])
            throw Error(fmt::format("the state's order has cell {} {}; it has cells 0 to {}, each once", cell,
                                    cell >= most ? "in it" : "twice", most - 1));
        found[cell] = true;
    }
}

// What no run can come to, and what kernels could not count or find.
void check_values(const Experiment& experiment, const Snapshot& snapshot) {
    if (snapshot.iteration > largest_iteration) {
        throw Error(
            fmt::format("the state is at iteration {}; a run cannot pass {}", snapshot.iteration, largest_iteration));
    }
    const auto latest = std::ranges::max_element(snapshot.birth);
    if (*latest > snapshot.iteration) {
        throw Error(fmt::format("cell {} of the state is born at iteration {}, after the state's own, {}",
                                latest - snapshot.birth.begin(), *latest, snapshot.iteration));
    }
    for (const auto& [first, second] : snapshot.mirrors) {
        if (std::max(first, second) >= snapshot.cells()) {
            throw Error(fmt::format("the state has a mirror pair of cells {} and {}; cells 0 to {} exist", first,
                                    second, snapshot.cells() - 1));
        }
    }
    check_order(snapshot);
    for (std::size_t chemical = 0; snapshot.on_grid() && chemical < snapshot.diff.size(); ++chemical) {
        const auto& rates = snapshot.diff[chemical];
        const auto wrong = std::ranges::find_if(rates, [](double rate) { return rate < 0.0; });
        if (wrong == rates.end()) continue;
        throw Error(fmt::format("the state has the diffusion rate {} of '{}' in cell {}; {} none is below 0", *wrong,
                                experiment.chemicals[chemical].name, wrong - rates.begin(),
                                snapshot.volume() ? "in a volume" : "on a lattice"));
    }
}

void check_state(const Experiment& experiment, const Snapshot& snapshot) {
    check_shape(experiment, snapshot);
    check_values(experiment, snapshot);
}

}  // namespace

Tissue::Tissue(std::shared_ptr<const Experiment> experiment, const Snapshot& initial)
    : experiment_(std::move(experiment)),
      iteration_(initial.iteration),
      columns_(initial.columns),
      rows_(initial.rows),
      layers_(initial.layers) {
    check_state(*experiment_, initial);
}

void Tissue::advance(std::uint64_t iterations) {
    if (iterations > largest_iteration - std::min(iteration_, largest_iteration)) {
        throw Error(fmt::format("a run cannot pass iteration {}", largest_iteration));
    }
    check_whole();
    lost_ = true;
    const std::uint64_t end = iteration_ + iterations;
    while (iteration_ < end) {
        for (const Event& event : events_before(*experiment_, iteration_)) {
            std::visit([&](const auto& one) { take_place(one); }, event);
        }
        const std::uint64_t next = std::min(end, next_event(*experiment_, iteration_));
        do_advance(iteration_, next - iteration_);
        iteration_ = next;
    }
    lost_ = false;
}

void Tissue::check_whole() const {
    if (!lost_) return;
    throw Error("the tissue's state is lost, for an earlier call failed half-way; write() a state first");
}

void Tissue::take_place(const NewPhase& event) {
    const auto& rates = event.phase->rates;
    for (std::size_t chemical = 0; chemical < rates.size(); ++chemical) {
        if (rates[chemical]) do_set_rate(chemical, *rates[chemical]);
    }
}

void Tissue::take_place(const Expansion&) {
    throw Error(
        fmt::format("only a lattice can be expanded; this tissue {}", layers_ != 0 ? "is a volume" : "has free cells"));
}

void Tissue::reshape(std::size_t columns, std::size_t rows, const std::function<void()>& change) {
    if (rows > largest_cell_count / columns) {
        throw Error(fmt::format("growth past {} cells at iteration {}; no more can be addressed", largest_cell_count,
                                iteration_));
    }
    const bool within_advance = lost_;
    lost_ = true;
    change();
    lost_ = within_advance;
    columns_ = columns;
    rows_ = rows;
}

Snapshot Tissue::read() const {
    check_whole();
    Snapshot snapshot = do_read();
    snapshot.iteration = iteration_;
    return snapshot;
}

void Tissue::read_conc(std::size_t chemical, std::vector<float>& to) const {
    check_whole();
    if (chemical >= experiment_->chemicals.size()) {
        throw Error(fmt::format("chemical {} cannot be read; there are {}", chemical, experiment_->chemicals.size()));
    }
    do_read_conc(chemical, to);
}

void Tissue::do_read_conc(std::size_t chemical, std::vector<float>& to) const {
    const Snapshot state = do_read();
    to.resize(state.cells());
    std::ranges::transform(state.conc[chemical], to.begin(), [](double value) { return static_cast<float>(value); });
}

std::optional<NonFinite> Tissue::non_finite() const {
    check_whole();
    return do_non_finite();
}

void Tissue::write(const Snapshot& snapshot) {
    check_state(*experiment_, snapshot);
    if (snapshot.volume() != (layers_ != 0)) throw Error("a volume and another space cannot take each other's state");
    if (snapshot.on_grid() != (columns_ != 0)) throw Error("a lattice and free cells cannot take each other's state");
    lost_ = true;
    do_write(snapshot);
    lost_ = false;
    iteration_ = snapshot.iteration;
    columns_ = snapshot.columns;
    rows_ = snapshot.rows;
    layers_ = snapshot.layers;
}

std::unique_ptr<Tissue> Backend::make_tissue(const Experiment& experiment) {
    Experiment settled = experiment;
    settle_seed(settled);
    return make_tissue(settled, initial_state(settled, precision()));
}

}  // namespace pelage
