// See reel.hpp. The file: the run's identity; then for each state iteration, columns, rows, cells (uint64), the
// lattice's centre (two doubles), the arrays and the values of outputs that are computed, as floats.
#include "app/reel.hpp"

#include "core/columns.hpp"
#include "core/error.hpp"
#include "io/drawn.hpp"
#include "io/file_bytes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <set>

namespace pelage::app {

namespace {

namespace fs = std::filesystem;

bool shared(const Output& output) {
    return !output.range && !output.own_range && output.drawing != Drawing::normal && !output.rgb();
}

// The state's arrays that pictures need, in the file's order: places, polarity, and the outputs' chemicals.
template <class State>
auto columns_of(State& state, const Experiment& experiment) {
    std::vector<decltype(&state.x)> columns;
    if (!state.on_grid() || experiment.texture) columns = {&state.x, &state.y};
    if (!state.on_grid()) columns.insert(columns.end(), {&state.polarity_x, &state.polarity_y});
    std::set<std::size_t> chemicals;
    for (const Output& output : experiment.outputs) {
        if (shared(output) && output.expressions.empty() && chemicals.insert(output.chemical).second)
            columns.push_back(&state.conc[output.chemical]);
    }
    return columns;
}

template <class T>
bool read_values(std::FILE* file, std::vector<T>& values) {
    return std::fread(values.data(), sizeof(T), values.size(), file) == values.size();
}

bool write_values(std::FILE* file, const std::vector<double>& column) {
    std::vector<float> values(column.size());
    std::ranges::transform(column, values.begin(), [](double value) { return static_cast<float>(value); });
    return std::fwrite(values.data(), sizeof(float), values.size(), file) == values.size();
}

}  // namespace

Reel::Reel(fs::path folder, const Experiment& experiment, std::string identity, std::optional<std::uint64_t> resumed_at)
    : path_(std::move(folder) / reel_name), experiment_(experiment), identity_(std::move(identity)) {
    for (const Output& output : experiment.outputs)
        ranges_.push_back(shared(output) ? std::optional<ValueRange>(ValueRange{}) : std::nullopt);
    if (resumed_at && shares()) take_up(*resumed_at);
}

bool Reel::shares() const {
    return std::any_of(ranges_.begin(), ranges_.end(), [](const auto& range) { return range.has_value(); });
}

void Reel::fail() const { throw Error(fmt::format("cannot write '{}': {}", path_.string(), system_reason(errno))); }

void Reel::open(bool anew) {
    file_.reset(std::fopen(path_.c_str(), anew ? "w+b" : "r+b"));
    if (!file_ && anew) fail();
    if (anew && std::fwrite(identity_.data(), 1, identity_.size(), file_.get()) != identity_.size()) fail();
}

void Reel::take_up(std::uint64_t resumed_at) {
    open(false);
    if (!file_) return;
    std::vector<char> identity(identity_.size());
    long end = 0;
    if (read_values(file_.get(), identity) && std::equal(identity.begin(), identity.end(), identity_.begin())) {
        end = std::ftell(file_.get());
        while (const auto state = read_record()) {
            if (state->state.iteration > resumed_at) break;
            widen(state->state, state->values);
            records_.push_back({state->state.iteration, end, ranges_});
            end = std::ftell(file_.get());
        }
    }
    std::error_code failure;
    file_.reset();
    if (end != 0) fs::resize_file(path_, static_cast<std::uintmax_t>(end), failure);
    if (end == 0 || failure) records_.clear();
    if (!records_.empty()) open(false);
}

std::optional<Reel::Frame> Reel::read_record() {
    std::array<std::uint64_t, 5> shape{};
    std::array<double, 2> centre{};
    if (std::fread(shape.data(), sizeof shape, 1, file_.get()) != 1) return std::nullopt;
    if (std::fread(centre.data(), sizeof centre, 1, file_.get()) != 1 || shape[4] > largest_cell_count)
        return std::nullopt;
    Snapshot state;
    state.iteration = shape[0];
    state.columns = shape[1];
    state.rows = shape[2];
    state.layers = shape[3];
    state.origin_x = centre[0];
    state.origin_y = centre[1];
    const auto cells = static_cast<std::size_t>(shape[4]);
    for (auto* list : {&state.conc, &state.diff}) list->resize(experiment_.chemicals.size());
    state.mappings.resize(experiment_.mappings.size());
    each_cell_column([&](const char*, auto& column) { column.assign(cells, {}); }, state);
    std::vector<float> values(cells);
    for (auto* column : columns_of(state, experiment_)) {
        if (!read_values(file_.get(), values)) return std::nullopt;
        column->assign(values.begin(), values.end());
    }
    OutputValues computed(experiment_.outputs.size());
    for (std::size_t i = 0; i < computed.size(); ++i) {
        if (!computes(i)) continue;
        if (!read_values(file_.get(), values)) return std::nullopt;
        computed[i].emplace(values.begin(), values.end());
    }
    return Frame{std::move(state), std::move(computed)};
}

bool Reel::computes(std::size_t output) const {
    return shared(experiment_.outputs[output]) && !experiment_.outputs[output].expressions.empty();
}

OutputValues Reel::computed(const Snapshot& state) const {
    OutputValues values(experiment_.outputs.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!computes(i)) continue;
        const Drawn drawn(experiment_, experiment_.outputs[i], i, state);
        values[i].emplace(drawn.values().begin(), drawn.values().end());
    }
    return values;
}

void Reel::write_record(const Snapshot& state, const OutputValues& computed) {
    const std::array<std::uint64_t, 5> shape{state.iteration, state.columns, state.rows, state.layers, state.cells()};
    const std::array<double, 2> centre{state.origin_x, state.origin_y};
    if (std::fseek(file_.get(), 0, SEEK_END) != 0) fail();
    records_.push_back({state.iteration, std::ftell(file_.get()), ranges_});
    if (std::fwrite(shape.data(), sizeof shape, 1, file_.get()) != 1) fail();
    if (std::fwrite(centre.data(), sizeof centre, 1, file_.get()) != 1) fail();
    for (const auto* column : columns_of(state, experiment_)) {
        if (!write_values(file_.get(), *column)) fail();
    }
    for (const auto& column : computed) {
        if (column && !write_values(file_.get(), *column)) fail();
    }
    if (std::fflush(file_.get()) != 0) fail();
}

void Reel::widen(const Snapshot& state, const OutputValues& computed) {
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
        if (!ranges_[i]) continue;
        ranges_[i]->widen(range_of(computed[i] ? *computed[i] : state.conc[experiment_.outputs[i].chemical]));
    }
}

SharedRanges Reel::keep(const Snapshot& state) {
    if (!shares()) return ranges_;
    const OutputValues values = computed(state);
    widen(state, values);
    if (!file_) open(true);
    write_record(state, values);
    return ranges_;
}

void Reel::redraw(const Draw& draw) {
    for (Record& record : records_) {
        if (record.drawn == ranges_) continue;
        std::optional<Frame> state;
        if (std::fseek(file_.get(), record.begin, SEEK_SET) == 0) state = read_record();
        if (!state) throw Error(fmt::format("cannot read '{}' again", path_.string()));
        draw(state->state, ranges_, state->values);
        record.drawn = ranges_;
    }
}

bool Reel::can_redraw(std::uint64_t iteration) const {
    return !shares() || std::ranges::any_of(records_, [&](const Record& one) { return one.iteration == iteration; });
}

void Reel::discard() {
    file_.reset();
    std::error_code ignored;
    fs::remove(path_, ignored);
}

}  // namespace pelage::app
