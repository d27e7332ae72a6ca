// See tissue.hpp.
#include "opencl/cells/tissue.hpp"

#include "core/error.hpp"
#include "core/searching.hpp"
#include "core/subnormal.hpp"
#include "opencl/cells/divide.hpp"
#include "opencl/cells/lists.hpp"
#include "opencl/cells/mirror.hpp"
#include "opencl/cells/non_finite.hpp"
#include "opencl/cells/programs.hpp"
#include "opencl/cells/state.hpp"
#include "opencl/cells/together.hpp"
#include "opencl/device/cl_error.hpp"
#include "opencl/device/launch.hpp"
#include "opencl/device/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

namespace pelage {

namespace {

constexpr std::size_t most_divide_rules = 32;  // each has a bit of a word

struct Progress {  // struct pelage_progress of kernels/cells/state.cl
    cl_int moved;
    cl_int children;
    cl_int skipped;
    cl_int unused;
};

std::size_t divide_rules(const Experiment& experiment) {
    return static_cast<std::size_t>(std::ranges::count_if(
        experiment.rules, [](const Rule& rule) { return std::holds_alternative<Divide>(rule.action); }));
}

std::string service_source() {
    Source source;
    source.file("common/prelude.cl").file("common/scan.cl").file("cells/state.cl");
    source.file("cells/lists.cl").file("cells/divide.cl").file("cells/mirror.cl").file("cells/non_finite.cl");
    return source.str();
}

// Half of a packed domain's side, in the precision of the run.
template <class T>
double packed_half(std::size_t cells, double area) {
    const T side = std::sqrt(static_cast<T>(cells) * in_precision<T>(area)) - T(2);
    return static_cast<double>(side / T(2));
}

class OpenclCells final : public Tissue, public Searching {
public:
    OpenclCells(std::shared_ptr<const Session> session, std::shared_ptr<const Experiment> shared,
                const Snapshot& initial, const CellsOptions& options);

    std::optional<SearchStatistics> search_statistics() const override;
    std::optional<ProgramCounts> programs() const override { return session_->program_counts(); }

private:
    std::size_t do_cells() const override { return static_cast<std::size_t>(state_.cells()); }
    void do_advance(std::uint64_t first, std::uint64_t count) override;
    void do_set_rate(std::size_t chemical, double rate) override {
        with_device(session_->info().name, [&] { state_.fill_rate(chemical, rate); });
    }
    Snapshot do_read() const override;
    void do_write(const Snapshot& snapshot) override;
    std::optional<NonFinite> do_non_finite() const override;

    void take(const Snapshot&);
    std::uint64_t some(std::uint64_t first, std::uint64_t most);
    std::uint64_t batch(std::uint64_t first, std::uint64_t most);
    std::uint64_t leap(std::uint64_t first, std::uint64_t most);
    void lengthen();
    void flip(const CellsWritten&);
    void enqueue(CellsStep&, std::uint64_t first, std::size_t steps);
    std::size_t group_for(std::size_t items) const;
    cl_uint bind(cl::Kernel&, const CellsWritten&, bool back);
    void conclude(const CellsStep&, std::uint64_t first, std::size_t done, const Progress& last);

    std::shared_ptr<const Session> session_;
    CellsOptions options_;
    NeighbourTuning tuning_;
    cl::Program service_;
    CellsState state_;
    CellsLists lists_;
    CellsDivision division_;
    CellMirrors mirrors_;
    CellsTogether together_;
    std::optional<CellsPrograms> programs_;
    mutable CellsNonFinite non_finite_;
    cl::Buffer progress_;
    bool fresh_ = false;  // the lists hold for the state
    std::size_t batch_ = 1;
};

OpenclCells::OpenclCells(std::shared_ptr<const Session> session, std::shared_ptr<const Experiment> shared,
                         const Snapshot& initial, const CellsOptions& options)
    : Tissue(std::move(shared), initial),
      session_(std::move(session)),
      options_(options),
      tuning_(options.tuning.value_or(NeighbourTuning::of(*session_))),
      service_(session_->build(service_source())),
      state_(*session_, experiment().chemicals.size(), experiment().mappings.size(), divide_rules(experiment())),
      lists_(*session_, options, service_),
      division_(*session_, tuning_, service_),
      mirrors_(*session_, service_),
      together_(*session_),
      non_finite_(*session_, service_, tuning_.group) {
    if (initial.lattice()) throw Error("a lattice has no free cells; it is stepped as a lattice");
    const std::string reason = why_not_cells(experiment());
    if (!reason.empty()) throw Error(experiment().source + ": " + reason);
    options_.batch = options.approximate() ? 1 : std::max<std::size_t>(1, options.batch);
    progress_ = session_->buffer((options_.batch + 1) * sizeof(Progress), "progress of a batch");
    take(initial);
}

void OpenclCells::take(const Snapshot& snapshot) {
    state_.upload(snapshot);
    mirrors_.take(snapshot.mirrors);
    CellsPlan plan = cells_plan(experiment(), snapshot, options_.approximate());
    if (!programs_ || programs_->plan() != plan) programs_.emplace(*session_, experiment(), std::move(plan));
    lists_.begin(snapshot.order);
    fresh_ = false;
    batch_ = 1;
}

Snapshot OpenclCells::do_read() const {
    return with_device(session_->info().name, [&] {
        Snapshot snapshot = state_.download();
        snapshot.mirrors = mirrors_.pairs();
        snapshot.order = lists_.order();
        return snapshot;
    });
}

void OpenclCells::do_write(const Snapshot& snapshot) {
    with_device(session_->info().name, [&] { take(snapshot); });
}

void OpenclCells::do_advance(std::uint64_t first, std::uint64_t count) {
    with_device(session_->info().name, [&] {
        for (std::uint64_t done = 0; done < count;) done += some(first + done, count - done);
    });
}

// Carries out some iterations, none where the lists had to be lengthened first; returns how many.
std::uint64_t OpenclCells::some(std::uint64_t first, std::uint64_t most) {
    const bool grows = state_.divide_rules() > 0;
    const Path path = session_->options().path;
    return cells_step_together(session_->info(), path, options_, do_cells(), grows) ? leap(first, most)
                                                                                    : batch(first, most);
}

// In one launch, which appends children and mends lists as it goes.
std::uint64_t OpenclCells::leap(std::uint64_t first, std::uint64_t most) {
    std::uint64_t until = forever;
    CellsStep& step = programs_->at(first, until, CellsForm::together);
    if (!fresh_) lists_.build(state_);
    state_.poison_spare([&](CellArray array) { return changes(step.written, array); });
    const CellsTogether::Way way = together_.run(step, programs_->parameters(), programs_->width(), state_, lists_,
                                                 mirrors_, experiment().domain, first, std::min(most, until - first));
    if (way.done == 0) {
        lengthen();
        return 0;
    }
    if (way.done % 2 == 1) flip(step.written);
    state_.append(way.cells - do_cells());
    if (way.children > 0) division_.append(state_, step.written, first + way.done - 1, way.children);
    fresh_ = !way.stale && way.children == 0;
    return way.done;
}

// After a launch that did nothing.
void OpenclCells::lengthen() {
    if (!lists_.lengthen(state_)) {
        throw Error(fmt::format("device '{}' did not carry out a step, without a reason", session_->info().name));
    }
    fresh_ = true;
}

// Enqueues some steps, waits for them and returns how many of them were carried out.
std::uint64_t OpenclCells::batch(std::uint64_t first, std::uint64_t most) {
    std::uint64_t until = forever;
    CellsStep& step = programs_->at(first, until, CellsForm::alone);
    const std::size_t steps =
        static_cast<std::size_t>(std::min<std::uint64_t>({batch_, options_.batch, most, until - first}));
    session_->queue().enqueueFillBuffer(progress_, cl_int{0}, 0, (steps + 1) * sizeof(Progress));
    if (!fresh_) lists_.build(state_);
    enqueue(step, first, steps);
    std::vector<Progress> progress(steps + 1);
    session_->queue().enqueueReadBuffer(progress_, CL_TRUE, 0, progress.size() * sizeof(Progress), progress.data());
    std::size_t done = 0;
    while (done < steps && progress[done + 1].skipped == 0) ++done;
    if (done > 0) {
        conclude(step, first, done, progress[done]);
    } else {
        lengthen();
    }
    return done;
}

// Work-items in a group: few enough for every thread of a small tissue to get some.
std::size_t OpenclCells::group_for(std::size_t items) const {
    const std::size_t most = std::max<std::size_t>(1, session_->info().max_work_group);
    if (session_->options().work_group != 0) return std::min(session_->options().work_group, most);
    return programs_->width() > 1 ? std::min<std::size_t>(items > 3000 ? 64 : 16, most) : tuning_.group;
}

void OpenclCells::enqueue(CellsStep& step, std::uint64_t first, std::size_t steps) {
    state_.poison_spare([&](CellArray array) { return changes(step.written, array); });
    const cl_uint next = bind(step.there, step.written, false);
    if (steps > 1) bind(step.back, step.written, true);
    const std::size_t items = (do_cells() + programs_->width() - 1) / programs_->width();
    const std::size_t group = group_for(items);
    for (std::size_t i = 0; i < steps; ++i) {
        cl::Kernel& kernel = i % 2 == 0 ? step.there : step.back;
        Arguments(*session_, kernel, next).add(static_cast<cl_int>(i + 1), static_cast<cl_uint>(first + i));
        launch(*session_, kernel, items, group);
        const bool into_spare = i % 2 == 0;
        mirrors_.enqueue(state_, progress_, static_cast<int>(i + 1), into_spare);
    }
}

// All arguments but the last two, which change from step to step; returns the place of the first of them.
cl_uint OpenclCells::bind(cl::Kernel& kernel, const CellsWritten& written, bool back) {
    const Domain& domain = experiment().domain;
    double half_width = domain.width / 2;
    double half_height = domain.height / 2;
    if (domain.packed) {
        half_width = session_->is_double() ? packed_half<double>(do_cells(), domain.area)
                                           : packed_half<float>(do_cells(), domain.area);
        half_height = half_width;
    }
    Arguments arguments(*session_, kernel);
    arguments.add(state_.cells(), state_.pitch());
    for (const bool second : {false, true}) {
        for (std::size_t i = 0; i < cell_array_count; ++i) {
            const auto array = static_cast<CellArray>(i);
            const bool spare = second != (back && changes(written, array));
            arguments.add(spare ? state_.spare(array) : state_.now(array));
        }
    }
    const DeviceLists& lists = lists_.lists();
    arguments.add(state_.built(), lists.lengths, lists.entries, lists.capacity, lists.longest, Scalar{half_width},
                  Scalar{half_height}, state_.divides(), state_.degrees(), Scalar{lists_.longest_way()},
                  programs_->parameters(), progress_);
    return arguments.next();
}

void OpenclCells::flip(const CellsWritten& written) {
    for (std::size_t i = 0; i < cell_array_count; ++i) {
        const auto array = static_cast<CellArray>(i);
        if (changes(written, array)) state_.flip(array);
    }
}

void OpenclCells::conclude(const CellsStep& step, std::uint64_t first, std::size_t done, const Progress& last) {
    if (done % 2 == 1) flip(step.written);
    if (last.children > 0)
        division_.append(state_, step.written, first + done - 1, static_cast<std::size_t>(last.children));
    // An approximate search goes on sorting even where nothing moves.
    fresh_ = !options_.approximate() && last.children == 0 && last.moved == 0;
    batch_ = fresh_ ? std::min(options_.batch, 2 * batch_) : std::clamp<std::size_t>(done + 1, 1, batch_);
}

std::optional<SearchStatistics> OpenclCells::search_statistics() const {
    return with_device(session_->info().name, [&] { return lists_.statistics(state_); });
}

std::optional<NonFinite> OpenclCells::do_non_finite() const {
    return with_device(session_->info().name, [&] { return non_finite_.first_in(state_); });
}

}  // namespace

std::string why_not_cells(const Experiment& experiment) {
    const std::size_t found = divide_rules(experiment);
    if (found <= most_divide_rules) return "";
    return fmt::format("{} divide rules; free cells on OpenCL devices allow at most {}", found, most_divide_rules);
}

std::unique_ptr<Tissue> make_opencl_cells(std::shared_ptr<const Session> session,
                                          std::shared_ptr<const Experiment> experiment, const Snapshot& initial,
                                          const CellsOptions& options) {
    const std::string device = session->info().name;
    return with_device(device, [&]() -> std::unique_ptr<Tissue> {
        return std::make_unique<OpenclCells>(std::move(session), std::move(experiment), initial, options);
    });
}

}  // namespace pelage
