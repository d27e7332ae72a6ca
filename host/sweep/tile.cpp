// See tile.hpp.
#include "sweep/tile.hpp"

#include "core/error.hpp"
#include "core/space.hpp"
#include "io/drawn.hpp"
#include "io/sha256.hpp"
#include "io/texture.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace pelage::sweep {

namespace {

// Iterations at which a tile is looked at: parts of the whole run, and of its last tenth.
std::set<std::uint64_t> moments(std::uint64_t last, std::uint64_t parts) {
    std::set<std::uint64_t> all;
    for (std::uint64_t i = 1; i <= parts; ++i) all.insert(last * i / parts);
    return all;
}

bool finite(const std::vector<double>& values) {
    return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

// Sees the states of a tile and says at which iteration it wants the next one.
class Watch {
public:
    Watch(const Experiment& experiment, const TileOptions& options)
        : experiment_(experiment), options_(options), checks_(moments(options.last, options.steady ? 100 : 20)) {
        for (std::uint64_t i = 0; i < 8; ++i) ends_.insert(options.last - options.last * i / 80);
    }

    void look(Snapshot state) {
        state_ = std::move(state);
        strange_ = now() > 0 && !std::ranges::all_of(state_.conc, finite);
        if (strange_) return;
        std::vector<double> values = shown(experiment_, state_);
        strange_ = !finite(values);
        if (strange_) return;
        values.resize(state_.cells());  // of `rgb` the reds
        for (const double value : values) largest_ = std::max(largest_, std::fabs(value));
        if (checks_.contains(now()) || now() == 0) compare(values);
        if (ends_.contains(now()) || steady_) {
            if (followed_ != values.size()) course_ = {};
            followed_ = values.size();
            course_.show(grid(values));
        }
    }

    bool ended() const { return now() >= options_.last || steady_ || (strange_ && now() > 0); }

    std::uint64_t next() const {
        std::uint64_t stop = options_.last;
        for (const auto* all : {&checks_, &ends_}) {
            const auto at = all->upper_bound(now());
            if (at != all->end()) stop = std::min(stop, *at);
        }
        return stop;
    }

    // The watch has nothing to see any more.
    TileResult result() {
        TileResult result = strange_ ? broken() : finished();
        result.iterations = now();
        result.hash = hash_of(state_);
        result.state = std::move(state_);
        return result;
    }

private:
    stats::Grid grid(const std::vector<double>& values) const {
        return {values, state_.columns, state_.rows, wraps(experiment_)};
    }

    std::uint64_t now() const { return state_.iteration; }

    void compare(const std::vector<double>& values) {
        const double changed = before_.size() == values.size() ? stats::change(grid(before_), grid(values)) : 1.0;
        if (changed > 1e-3) settled_.reset();
        if (changed <= 1e-3 && !settled_ && now() > 0) settled_ = before_at_;
        if (options_.steady && now() > 0 && changed <= *options_.steady) steady_ = true;
        before_ = values;
        before_at_ = now();
    }

    TileResult finished() {
        TileResult result;
        result.settled = settled_;
        std::vector<double> values = shown(experiment_, state_);
        values.resize(state_.cells());
        result.statistics = stats::statistics_of(grid(values));
        const bool flat = stats::uniform(*result.statistics) ||
                          result.statistics->maximum - result.statistics->minimum <= 1e-6 * largest_;
        if (course_.states() > 1)
            result.verdict = course_.verdict(largest_);
        else
            result.verdict = flat      ? stats::Verdict::uniform
                             : steady_ ? stats::Verdict::stationary
                                       : stats::Verdict::undecided;
        return result;
    }

    TileResult broken() const {
        TileResult result;
        result.verdict = stats::Verdict::not_a_number;
        return result;
    }

    const Experiment& experiment_;
    const TileOptions& options_;
    std::set<std::uint64_t> checks_, ends_;
    Snapshot state_;
    std::vector<double> before_;
    std::uint64_t before_at_ = 0;
    std::optional<std::uint64_t> settled_;
    stats::Course course_;
    std::size_t followed_ = 0;
    bool steady_ = false;
    bool strange_ = false;  // the state, or what is shown of it, has NaNs or infinities
    double largest_ = 0.0;  // of all values seen
};

}  // namespace

std::vector<double> shown(const Experiment& experiment, const Snapshot& state) {
    const std::size_t output = first_of_colours(experiment.outputs);
    const Drawn drawn(experiment, experiment.outputs.at(output), output, state);
    std::vector<double> values;
    for (const std::span<const double> column : drawn.columns())
        values.insert(values.end(), column.begin(), column.end());
    return values;
}

std::string measured(const Experiment& experiment) {
    const Output& output = experiment.outputs.at(first_of_colours(experiment.outputs));
    if (output.rgb()) return "red";
    return output.expressions.empty() ? experiment.chemicals[output.chemical].name : "formula";
}

std::string hash_of(const Snapshot& state) {
    std::string bytes;
    for (const std::vector<double>& column : state.conc) {
        for (const double value : column) {
            const auto word = std::bit_cast<std::uint64_t>(value);
            for (unsigned i = 0; i < 8; ++i) bytes += static_cast<char>(word >> (8 * i) & 0xffu);
        }
    }
    return sha256(bytes).substr(0, 16);
}

std::optional<TileResult> run_tile(Tissue& tissue, const Experiment& experiment, const TileOptions& options) {
    Watch watch(experiment, options);
    watch.look(tissue.read());
    while (!watch.ended()) {
        if (options.interrupted()) return std::nullopt;
        tissue.advance(watch.next() - tissue.iteration());
        watch.look(tissue.read());
    }
    return watch.result();
}

bool run_tiles(Batch& batch, const std::vector<const Experiment*>& experiments, const TileOptions& options,
               const std::function<void(std::size_t member, TileResult)>& finished) {
    std::map<std::size_t, Watch> watches;
    for (std::size_t member = 0; member < experiments.size(); ++member)
        watches.try_emplace(member, *experiments[member], options);
    for (;;) {
        for (auto at = watches.begin(); at != watches.end();) {
            Watch& watch = at->second;
            watch.look(batch.read(at->first));
            if (!watch.ended()) {
                ++at;
                continue;
            }
            batch.end(at->first);
            finished(at->first, watch.result());
            at = watches.erase(at);
        }
        if (watches.empty()) return true;
        if (options.interrupted()) return false;
        batch.advance(watches.begin()->second.next() - batch.iteration());
    }
}

void check_measurable(const Experiment& experiment) {
    const Space space = space_of(experiment);
    if (std::holds_alternative<Lattice>(space)) return;
    if (std::holds_alternative<MeshCells>(space))
        throw Error(experiment.source + ": a sweep measures planes; a mesh has no rows and columns");
    if (keeps_places(space)) throw Error(experiment.source + ": a sweep measures planes; a volume has layers, too");
    throw Error(experiment.source + ": a sweep measures lattices; free cells have no rows and columns");
}

}  // namespace pelage::sweep
