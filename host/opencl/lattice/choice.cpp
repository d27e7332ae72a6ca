// See choice.hpp.
#include "opencl/lattice/choice.hpp"

#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/forecast.hpp"
#include "opencl/lattice/fused_cut.hpp"
#include "opencl/lattice/traits.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage {

namespace {

struct Answer {
    Path path;
    std::string why;
};

// Whether so many bytes stay in the caches of the threads that work on them.
bool caches_hold(const DeviceInfo& device, double bytes) {
    constexpr double of_a_thread = 1'500'000;  // of its second level, much of it
    return bytes < of_a_thread * static_cast<double>(device.running_units());
}

// What sets the pace of these rules if it is not memory; empty: memory does.
std::string pace_setter(const RuleNeeds& needs) {
    if (needs.networks) return "networks";
    if (needs.draws) return "random draws";
    if (needs.polarizes) return "polarities that follow gradients";
    return needs.uneven_rates ? "diffusion rates that differ between cells" : "";
}

// Why a processor shall not stream; empty: it shall.
std::string why_not_streamed(const DeviceInfo& device, const RuleNeeds& needs, const Work& work) {
    constexpr double least_cells = 15'000;  // smaller ones are no faster streamed than with shared steps
    if (work.cells < least_cells) return "a lattice of so few cells would gain nothing";
    const std::string pace = pace_setter(needs);
    if (!pace.empty()) return pace + ", not memory, set its pace";
    if (work.compiled) return "";
    const bool cached = caches_hold(device, work.bytes_a_cell * work.cells);
    if (work.ahead.value_or(work.done) < (cached ? 5e9 : 2e9)) {
        return cached ? "caches hold the lattice, streaming would gain too little"
                      : "too little work lies ahead to pay for the compilation";
    }
    return work.done < streamed_after ? "the run has only begun" : "";
}

Answer best(const DeviceInfo& device, const RuleNeeds& needs, const Work& work) {
    if (needs.wide) return {device.processor() ? Path::shared : Path::step, "stencils are taken in single iterations"};
    if (needs.networks && !device.processor()) return {Path::step, "networks, not memory, set its pace"};
    const bool graphics = device.type == "gpu" && !device.software_rasteriser();
    if (graphics && device.own_local_memory) return {Path::tiled, "the device has local memory of its own"};
    if (!device.processor()) return {Path::step, "the device has no local memory of its own"};
    const std::string against = why_not_streamed(device, needs, work);
    if (against.empty()) return {Path::streamed, "the work ahead pays for the compilation"};
    return {Path::shared, "not streamed: " + against};
}

// What `path` becomes where it is not to be had.
Answer allowed(Answer answer, const DeviceInfo& device, const OpenclOptions& options) {
    if (answer.path != Path::shared) return answer;
    if (!device.processor()) return {Path::step, "steps are shared on processors alone"};
    if (options.work_group > 1) return {Path::step, "steps are shared by work-groups of one work-item alone"};
    return answer;
}

FusedShape single(const DeviceInfo& device, std::size_t group) {
    const std::size_t most = std::max<std::size_t>(1, device.max_work_group);
    FusedShape shape;
    shape.group = std::min(most, group != 0 ? group : device.processor() ? 1 : 64);
    return shape;
}

// Large tiles compute less margin, and smaller ones are more, so that all compute units have some: measured on an
// NVIDIA H200, where large ones are faster from some 1000 x 1000 cells on. Where arithmetic sets the pace, margins cost
// more than launches.
LatticeCut usual_tile(const DeviceInfo& device, const RuleNeeds& needs, double cells) {
    constexpr LatticeCut large{6, 52, 32, 256}, small{6, 20, 20, 128};
    constexpr double tiles_a_unit = 3;
    const double tiles = cells / static_cast<double>(large.columns * large.rows);
    LatticeCut usual = tiles < tiles_a_unit * static_cast<double>(device.running_units()) ? small : large;
    if (!pace_setter(needs).empty()) usual.depth = 4;
    return usual;
}

Cut cut_of(Path path, const DeviceInfo& device, const RuleNeeds& needs, const Work& work, const OpenclOptions& options,
           std::size_t width) {
    switch (path) {
        case Path::streamed:
            return stream_cut(device, options, needs.fields, width);
        case Path::tiled:
            return tile_cut(device, options, needs.fields, width, usual_tile(device, needs, work.cells));
        default:
            return {single(device, options.work_group), 0};
    }
}

std::string too_small(const DeviceInfo& device, const RuleNeeds& needs, const Cut& cut) {
    return fmt::format("fused iterations of {} values a cell need {} bytes of local memory; device '{}' has {}",
                       needs.fields.all, cut.bytes, device.name, device.local_memory);
}

// Of a volume: the same program does one step a launch or several, so nothing speaks against streaming on processors.
Choice choose_for_volume(const DeviceInfo& device, const OpenclOptions& options) {
    Choice choice;
    choice.width = lattice_width(device, options);
    choice.cut = single(device, options.work_group);
    const bool asked = options.path != Path::automatic;
    if (!device.processor() || choice.cut.group > 1 || options.path == Path::step) {
        choice.why = options.path == Path::step ? "as asked for" : "volumes are streamed on processors alone";
        return choice;
    }
    choice.path = Path::streamed;
    choice.why = options.path == Path::streamed ? "as asked for"
                 : asked                        ? "a volume is stepped or streamed"
                                                : "layers go through the caches";
    choice.cut.depth = options.cut.depth != 0 ? options.cut.depth : 8;
    choice.cut.rows = options.cut.rows;  // 0: what turns out fastest, see VolumeCuts
    return choice;
}

}  // namespace

RuleNeeds rule_needs(const Experiment& experiment, const LatticePlan& plan, const RuleUse& use) {
    RuleNeeds needs;
    needs.networks = use.neural;
    needs.draws = use.random;
    needs.polarizes = !use.polarizes.empty();
    needs.uneven_rates = std::ranges::find(plan.rates, RateKind::per_cell) != plan.rates.end();
    needs.wide = plan.reach() > 1 || !use.surrounds.empty();
    needs.volume = plan.volume();
    if (!needs.volume) needs.fields = fused_fields(experiment, plan, use);
    return needs;
}

double bytes_a_cell(const Experiment& experiment, const LatticePlan& plan, const RuleUse& every, Precision precision) {
    const LatticeTraits traits(experiment, plan, every);
    double changing = 0;
    for (std::size_t i = 0; i < plan.rates.size(); ++i) changing += traits.idle(i) ? 0 : 1;
    return (2 * changing + static_cast<double>(every.fields.size())) * (precision == Precision::double_ ? 8 : 4);
}

std::optional<double> work_ahead(const Experiment& experiment, const std::vector<bool>& active, std::uint64_t iteration,
                                 double cells) {
    const std::uint64_t last = experiment.last_iteration();
    if (iteration >= last) return {};
    const std::uint64_t end = std::min(last, end_of_set(experiment, active, iteration));
    return static_cast<double>(end - iteration) * cells;
}

Work foreseen_work(const Experiment& experiment, const std::vector<bool>& active, std::uint64_t iteration, double cells,
                   double bytes_a_cell) {
    const std::uint64_t end = std::min(experiment.last_iteration(), end_of_set(experiment, active, iteration));
    Work work;
    work.cells = std::max(final_cells(experiment, end), cells);
    work.bytes_a_cell = bytes_a_cell;
    work.ahead = work_ahead(experiment, active, iteration, work.cells);
    work.done = work.ahead.value_or(0);
    return work;
}

std::string Choice::text() const {
    std::string how;
    if (path == Path::streamed)
        how = fmt::format(", up to {} in one pass over memory", counted(cut.depth, "iteration"));
    if (path == Path::tiled) how = fmt::format(", up to {} of a tile in local memory", counted(cut.depth, "iteration"));
    if (path == Path::shared) how = ", each thread steps a strip of rows";
    if (path == Path::step) how = ", one launch an iteration";
    return word(path) + how + (why.empty() ? "" : "; ") + why;
}

Choice choose(const DeviceInfo& device, const RuleNeeds& needs, const Work& work, const OpenclOptions& options) {
    if (needs.volume) return choose_for_volume(device, options);
    const bool automatic = options.path == Path::automatic;
    Choice choice;
    choice.width = lattice_width(device, options);
    const bool fused = options.path == Path::streamed || options.path == Path::tiled;
    const bool free = automatic || (needs.wide && fused);
    const Answer wanted = free ? best(device, needs, work) : Answer{options.path, "as asked for"};
    Answer answer = allowed(wanted, device, options);
    Cut cut = cut_of(answer.path, device, needs, work, options, choice.width);
    if (cut.bytes > device.local_memory) {
        if (!automatic) throw Error(too_small(device, needs, cut));
        answer =
            allowed({device.processor() ? Path::shared : Path::step, too_small(device, needs, cut)}, device, options);
        cut = cut_of(answer.path, device, needs, work, options, choice.width);
    }
    choice.path = answer.path;
    choice.why = answer.why;
    choice.cut = cut.shape;
    return choice;
}

Choice choose_for_batch(const DeviceInfo& device, const RuleNeeds& needs, const Work& work,
                        const OpenclOptions& options) {
    OpenclOptions wanted = options;
    const auto of_a_batch = [](Path path) { return path == Path::step || path == Path::tiled; };
    if (wanted.path == Path::automatic) wanted.path = choose(device, needs, work, wanted).path;
    if (!of_a_batch(wanted.path)) wanted.path = Path::step;
    Choice choice = choose(device, needs, work, wanted);
    if (!of_a_batch(choice.path)) {  // what is wide is not tiled
        wanted.path = Path::step;
        choice = choose(device, needs, work, wanted);
    }
    choice.cut.batch = true;
    choice.why = "several lattices a launch";
    return choice;
}

std::size_t vector_lanes(const DeviceInfo& device, Precision precision) {
    const std::uint32_t lanes =
        precision == Precision::double_ ? device.vector_width_double : device.vector_width_float;
    std::size_t width = 1;
    while (width < 16 && 2 * width <= lanes) width *= 2;
    return width;
}

std::size_t lattice_width(const DeviceInfo& device, const OpenclOptions& options) {
    if (options.width != 0) return options.width;
    return device.processor() ? vector_lanes(device, options.precision) : 1;
}

}  // namespace pelage
