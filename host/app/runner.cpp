// See runner.hpp.
#include "app/runner.hpp"

#include "app/carry_out.hpp"
#include "app/commands.hpp"
#include "app/film.hpp"
#include "app/film_plan.hpp"
#include "app/last_will.hpp"
#include "app/machine.hpp"
#include "app/memory.hpp"
#include "app/named_files.hpp"
#include "app/prepare.hpp"
#include "app/read_experiment.hpp"
#include "app/say.hpp"
#include "app/self_check.hpp"
#include "app/tuning.hpp"
#include "core/allowance.hpp"
#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "io/locked.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <vector>

namespace pelage::app {

namespace {

void announce(const RunOptions& options, const Prepared& prepared, const Machine& machine, const Tissue& tissue) {
    if (options.quiet) return;
    say(stderr, "{}: {}, iterations {} to {}, seed {}\n", prepared.experiment.source, counted(tissue.cells(), "cell"),
        grouped(tissue.iteration()), grouped(prepared.last), prepared.experiment.run_seed());
    say(stderr, "backend: {} ({}), {}\n", machine.kind, machine.device,
        options.precision == Precision::double_ ? "double" : "float");
    if (!machine.why.empty()) say(stderr, "not opencl: {}\n", machine.why);
}

void warn(const RunOptions& options, const Prepared& prepared) {
    if (options.quiet) return;
    std::vector<Warning> warnings = prepared.warnings;
    // An unstable step ends the run with an error of its own.
    if (!options.force) std::erase_if(warnings, [](const Warning& one) { return one.lint == "unstable"; });
    print_warnings(prepared.experiment, warnings);
}

// Whether the device may be trusted with the run; says why not.
bool trusted(const RunOptions& options, const Prepared& prepared, const Machine& machine, const Snapshot& start) {
    if (!machine.opencl || options.no_self_test) return true;
    const auto [fault, note] = self_check(*machine.opencl, machine.info, prepared.experiment, start, prepared.last);
    if (!fault.empty()) say(stderr, "pelage: {}\n", fault);
    if (!note.empty() && !options.quiet) say(stderr, "note: {}\n", note);
    return fault.empty();
}

}  // namespace

int run_experiment(const RunOptions& options) {
    when_killed_say("pelage: stopped before the run began\n");
    Prepared prepared = prepare(options);
    warn(options, prepared);
    check_formats(options, prepared.experiment);
    check_named_files(options, prepared.experiment);
    Footprint needed = footprint(prepared.experiment, prepared.last, options.precision, prepared.resumed.has_value());
    check_cells(prepared.experiment, needed);
    const std::optional<FilmPlan> film = plan_film(options, prepared.experiment, prepared.last);
    if (film) needed.film = Film::bytes(*film, prepared.experiment, needed.cells);
    Machine machine = choose_machine(options, prepared.experiment, needed);
    check_host_memory(prepared.experiment, needed, worked(machine), usable_memory());
    Snapshot initial = initial_state(prepared.experiment, options.precision);
    if (!options.force) check_stability(prepared.experiment, initial);
    const Snapshot& start = prepared.resumed ? *prepared.resumed : initial;
    if (!trusted(options, prepared, machine, start)) return failed_check;
    prepare_folder(options.folder());
    const FolderLock lock(options.folder());
    prepare_json(options.json);
    if (film) prepare_folder(std::filesystem::absolute(film->file).parent_path());
    tune_machine(options, prepared, start, machine);
    const std::unique_ptr<Tissue> tissue = machine.backend->make_tissue(prepared.experiment, initial);
    if (prepared.resumed) tissue->write(*prepared.resumed);
    initial = {};  // large ones are half of what a run needs
    prepared.resumed.reset();
    announce(options, prepared, machine, *tissue);
    return carry_out(options, prepared, machine, film, *tissue);
}

}  // namespace pelage::app
