// See cells.hpp.
#include "opencl/cells.hpp"

#include "core/error.hpp"
#include "opencl/cells_mirrors.hpp"
#include "opencl/cells_programs.hpp"
#include "opencl/cells_state.hpp"
#include "opencl/cl_error.hpp"
#include "opencl/neighbours_launch.hpp"
#include "opencl/program.hpp"
#include "opencl/spatial_sorting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

namespace pelage {

namespace {

constexpr std::size_t most_divide_rules = 32;  // each has a bit of a word

struct Progress {  // struct pelage_progress of kernels/cells_state.cl
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
    source.file("prelude.cl").file("scan.cl").file("cells_state.cl");
    source.file("cells_gather.cl").file("cells_divide.cl").file("cells_mirror.cl").file("cells_check.cl");
    return source.str();
}

// Half of a packed domain's side, in the precision of the run.
template <class T>
double packed_half(std::size_t cells, double area) {
    const T side = std::sqrt(static_cast<T>(cells) * static_cast<T>(area)) - T(2);
    return static_cast<double>(side / T(2));
}

class OpenclCells final : public Tissue {
public:
    OpenclCells(std::shared_ptr<const Session> session, std::shared_ptr<const Experiment> shared,
                const Snapshot& initial, const CellsOptions& options);

    std::optional<SearchStatistics> search_statistics() const override;

private:
    std::size_t do_cells() const override { return static_cast<std::size_t>(state_.cells()); }
    void do_advance(std::uint64_t first, std::uint64_t count) override;
    void do_expand(const Insertion&) override {
        throw Error("only a lattice can be expanded; this tissue has free cells");
    }
    void do_set_rate(std::size_t chemical, double rate) override { state_.fill_rate(chemical, rate); }
    Snapshot do_read() const override;
    void do_write(const Snapshot& snapshot) override;
    std::optional<NonFinite> do_non_finite() const override;

    bool approximate() const { return options_.search == NeighbourSearch::spatial_sorting; }
    void take(const Snapshot&);
    std::uint64_t batch(std::uint64_t first, std::uint64_t most);
    void enqueue(CellsStep&, std::uint64_t first, std::size_t steps);
    cl_uint bind(cl::Kernel&, const CellsWritten&, bool back);
    void conclude(const CellsStep&, std::uint64_t first, std::size_t done, const Progress& last);
    void divide(const CellsWritten&, std::uint64_t iteration, std::size_t children);
    void build_lists();
    void find_lists();
    void make_longer_lists();
    double longest_way() const;

    std::shared_ptr<const Session> session_;
    CellsOptions options_;
    NeighbourTuning tuning_;
    CellsState state_;
    NeighbourBins bins_;
    std::optional<DeviceMatrix> matrix_;
    DeviceLists lists_;
    std::optional<CellsPrograms> programs_;
    CellMirrors mirrors_;
    mutable cl::Kernel gather_, count_children_, append_, check_;
    cl::Buffer progress_, sums_, found_;
    bool fresh_ = false;  // the lists hold for the state
    std::size_t batch_ = 1;
};

OpenclCells::OpenclCells(std::shared_ptr<const Session> session, std::shared_ptr<const Experiment> shared,
                         const Snapshot& initial, const CellsOptions& options)
    : Tissue(std::move(shared), initial),
      session_(std::move(session)),
      options_(options),
      tuning_(options.tuning.value_or(NeighbourTuning::of(*session_))),
      state_(*session_, experiment().chemicals.size(), experiment().mappings.size(), divide_rules(experiment())),
      bins_(*session_, tuning_),
      mirrors_(*session_) {
    if (initial.lattice()) throw Error("a lattice has no free cells; it is stepped as a lattice");
    const std::string reason = why_not_cells(experiment());
    if (!reason.empty()) throw Error(experiment().source + ": " + reason);
    if (!(options_.skin >= 0)) throw Error(fmt::format("a skin of {}; it must not be negative", options_.skin));
    options_.batch = approximate() ? 1 : std::max<std::size_t>(1, options_.batch);
    if (approximate()) matrix_.emplace(*session_, options_.sorting);
    const cl::Program program = session_->build(service_source());
    gather_ = cl::Kernel(program, "pelage_cells_gather");
    count_children_ = cl::Kernel(program, "pelage_cells_count_children");
    append_ = cl::Kernel(program, "pelage_cells_append_children");
    check_ = cl::Kernel(program, "pelage_cells_check");
    mirrors_.build(program);
    progress_ = session_->buffer((options_.batch + 1) * sizeof(Progress), "progress of a batch");
    sums_ = session_->buffer(tuning_.chunks * sizeof(cl_int), "sums of children");
    found_ = session_->buffer(sizeof(cl_int), "mark of a value that is not finite");
    take(initial);
}

void OpenclCells::take(const Snapshot& snapshot) {
    state_.upload(snapshot);
    mirrors_.take(snapshot.mirrors);
    programs_.emplace(*session_, experiment(), cells_plan(experiment(), snapshot, approximate()));
    if (matrix_) matrix_->forget();
    fresh_ = false;
    batch_ = 1;
}

Snapshot OpenclCells::do_read() const {
    return with_device(session_->info().name, [&] {
        Snapshot snapshot = state_.download();
        snapshot.mirrors = mirrors_.pairs();
        return snapshot;
    });
}

void OpenclCells::do_write(const Snapshot& snapshot) {
    with_device(session_->info().name, [&] { take(snapshot); });
}

void OpenclCells::do_advance(std::uint64_t first, std::uint64_t count) {
    with_device(session_->info().name, [&] {
        for (std::uint64_t done = 0; done < count;) done += batch(first + done, count - done);
    });
}

// Enqueues some steps, waits for them and returns how many of them were carried out.
std::uint64_t OpenclCells::batch(std::uint64_t first, std::uint64_t most) {
    std::uint64_t until = forever;
    CellsStep& step = programs_->at(first, until);
    const std::size_t steps =
        static_cast<std::size_t>(std::min<std::uint64_t>({batch_, options_.batch, most, until - first}));
    session_->queue().enqueueFillBuffer(progress_, cl_int{0}, 0, (steps + 1) * sizeof(Progress));
    if (!fresh_) build_lists();
    enqueue(step, first, steps);
    std::vector<Progress> progress(steps + 1);
    session_->queue().enqueueReadBuffer(progress_, CL_TRUE, 0, progress.size() * sizeof(Progress), progress.data());
    std::size_t done = 0;
    while (done < steps && progress[done + 1].skipped == 0) ++done;
    if (done == 0) {
        make_longer_lists();
    } else {
        conclude(step, first, done, progress[done]);
    }
    return done;
}

void OpenclCells::enqueue(CellsStep& step, std::uint64_t first, std::size_t steps) {
    const cl_uint next = bind(step.there, step.written, false);
    if (steps > 1) bind(step.back, step.written, true);
    const std::size_t items = (do_cells() + programs_->width() - 1) / programs_->width();
    const std::size_t group = programs_->width() > 1 ? (items > 3000 ? 64 : 16) : tuning_.group;
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
    arguments.add(state_.built(), lists_.lengths, lists_.entries, lists_.capacity, lists_.longest, Scalar{half_width},
                  Scalar{half_height}, state_.divides(), state_.degrees(), Scalar{longest_way()}, progress_);
    return arguments.next();
}

// Squared half of the skin, less what rounding may hide.
double OpenclCells::longest_way() const { return options_.skin * options_.skin * 0.2495; }

void OpenclCells::conclude(const CellsStep& step, std::uint64_t first, std::size_t done, const Progress& last) {
    if (done % 2 == 1) {
        for (std::size_t i = 0; i < cell_array_count; ++i) {
            if (changes(step.written, static_cast<CellArray>(i))) state_.swap(static_cast<CellArray>(i));
        }
    }
    if (last.children > 0) divide(step.written, first + done - 1, static_cast<std::size_t>(last.children));
    // An approximate search goes on sorting even where nothing moves.
    fresh_ = !approximate() && last.children == 0 && last.moved == 0;
    batch_ = fresh_ ? std::min(options_.batch, 2 * batch_) : std::clamp<std::size_t>(done + 1, 1, batch_);
}

// The state before the step is still in the arrays that the step has left.
void OpenclCells::divide(const CellsWritten& written, std::uint64_t iteration, std::size_t children) {
    const std::size_t cells = do_cells();
    try {
        state_.grow(cells + children);
    } catch (const Error& error) {
        throw Error(fmt::format("growth at iteration {}: {}", iteration, error.what()));
    }
    const auto chunks = static_cast<cl_int>(std::clamp<std::size_t>(cells / tuning_.per_chunk, 1, tuning_.chunks));
    Arguments(*session_, count_children_).add(state_.divides(), state_.cells(), chunks, sums_);
    if (chunks > 1) launch(*session_, count_children_, static_cast<std::size_t>(chunks));
    Arguments arguments(*session_, append_);
    arguments.add(state_.divides(), state_.degrees(), state_.cells(), state_.pitch(), chunks, sums_, state_.chemicals(),
                  state_.mappings(), static_cast<cl_int>(iteration + 1), state_.place_of());
    for (std::size_t i = 0; i < cell_array_count; ++i) {
        const auto array = static_cast<CellArray>(i);
        arguments.add(changes(written, array) ? state_.spare(array) : state_.now(array));
    }
    state_.add_now(arguments);
    launch(*session_, append_, static_cast<std::size_t>(chunks));
    state_.append(children);
}

void OpenclCells::build_lists() {
    lists_.reserve(*session_, static_cast<std::size_t>(state_.pitch()), std::max(16, options_.list_capacity));
    if (approximate()) {
        matrix_->update(state_.now(CellArray::position), state_.pitch(), state_.cells());
    } else {
        const double reach = (interaction_range + options_.skin) * (1 + 1e-5);  // wider than any rounding of positions
        bins_.reserve(static_cast<std::size_t>(state_.pitch()));
        bins_.sort(state_.now(CellArray::position), state_.pitch(), state_.cells(), reach);
        const auto items = static_cast<cl_int>(
            std::clamp<std::size_t>(do_cells() / 1024, 1, tuning_.width > 1 ? tuning_.chunks : do_cells()));
        Arguments arguments(*session_, gather_);
        arguments.add(state_.cells(), state_.pitch(), items, state_.chemicals(), state_.mappings(), bins_.order());
        state_.add_now(arguments);
        state_.add_spare(arguments);
        arguments.add(state_.built(), state_.place_of());
        launch(*session_, gather_, static_cast<std::size_t>(items));
        state_.swap_all();
    }
    find_lists();
}

void OpenclCells::find_lists() {
    session_->queue().enqueueFillBuffer(lists_.longest, cl_int{0}, 0, sizeof(cl_int));
    if (approximate()) {
        matrix_->find(state_.now(CellArray::id), lists_);
    } else {
        const double reach = (interaction_range + options_.skin) * (1 + 1e-5);
        bins_.find(state_.now(CellArray::position), state_.pitch(), state_.now(CellArray::id), state_.cells(), reach,
                   lists_);
    }
    fresh_ = true;
}

// After a batch in which nothing was done: some list did not fit.
void OpenclCells::make_longer_lists() {
    cl_int longest = 0;
    session_->queue().enqueueReadBuffer(lists_.longest, CL_TRUE, 0, sizeof longest, &longest);
    if (longest <= lists_.capacity) {
        throw Error(fmt::format("device '{}' did not carry out a step, without a reason", session_->info().name));
    }
    lists_.reserve(*session_, static_cast<std::size_t>(state_.pitch()), (longest + longest / 4 + 15) / 16 * 16);
    find_lists();
}

std::optional<SearchStatistics> OpenclCells::search_statistics() const {
    if (!approximate()) return std::nullopt;
    return with_device(session_->info().name, [&] { return matrix_->statistics(state_.now(CellArray::id), lists_); });
}

std::optional<NonFinite> OpenclCells::do_non_finite() const {
    return with_device(session_->info().name, [&]() -> std::optional<NonFinite> {
        session_->queue().enqueueFillBuffer(found_, cl_int{0}, 0, sizeof(cl_int));
        Arguments(*session_, check_)
            .add(state_.now(CellArray::conc), state_.cells(), state_.pitch(), state_.chemicals(), found_);
        launch(*session_, check_, do_cells(), tuning_.group);
        cl_int found = 0;
        session_->queue().enqueueReadBuffer(found_, CL_TRUE, 0, sizeof found, &found);
        if (found == 0) return std::nullopt;
        const Snapshot snapshot = state_.download();
        for (std::size_t chemical = 0; chemical < snapshot.conc.size(); ++chemical) {
            for (std::size_t cell = 0; cell < snapshot.cells(); ++cell) {
                if (!std::isfinite(snapshot.conc[chemical][cell])) return NonFinite{chemical, cell};
            }
        }
        return std::nullopt;
    });
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
