// `pelage tune FILE`: tries every way to carry out a lattice on a device, and remembers the fastest that is right.
#include "app/commands.hpp"
#include "app/machine.hpp"
#include "app/memory.hpp"
#include "app/named_files.hpp"
#include "app/prepare.hpp"
#include "app/read_experiment.hpp"
#include "app/say.hpp"
#include "app/settings.hpp"
#include "app/tune_table.hpp"
#include "app/tuning.hpp"
#include "app/validators.hpp"
#include "core/allowance.hpp"
#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "opencl/device/cache.hpp"

#include <fmt/format.h>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>

namespace pelage::app {

namespace {

struct TuneOptions {
    RunOptions run;  // file, device, precision, seed, fast, no_cache, quiet
    bool quick = false;
    bool forget = false;
    bool worker = false;
    double limit = 20;
    std::uint64_t from = 0;
    std::optional<std::uint64_t> until;
    std::filesystem::path json;
};

TuningJob job_of(const TuneOptions& options) {
    Prepared prepared = prepare(options.run);
    const Experiment& experiment = prepared.experiment;
    tune::lattice_size(experiment);  // throws for free cells
    const std::uint64_t last = options.until.value_or(prepared.last);
    const Footprint needed = footprint(experiment, prepared.last, options.run.precision, false);
    check_cells(experiment, needed);
    const Machine machine = choose_machine(options.run, experiment, needed);
    check_host_memory(experiment, needed, worked(machine), usable_memory());
    return {options.run.file, std::move(prepared.experiment), *machine.opencl, machine.info, options.from, last};
}

Tuning carried_out(const TuningJob& job, const TuneOptions& options) {
    tune::Budget budget = options.quick ? tune::quick_budget : tune::Budget{};
    budget.candidate = options.limit;
    const tune::Effort effort = options.quick ? tune::Effort::quick : tune::Effort::exhaustive;
    return tuned(job, effort, budget, options.run.quiet ? Shown::nothing : Shown::on_terminals);
}

int tune_experiment(TuneOptions options) {
    if (options.run.file == standard_input) {
        throw Error("`tune` starts processes that read the experiment again: give a file, not standard input");
    }
    options.run.backend = "opencl";
    prepare_json(options.json);
    const TuningJob job = job_of(options);
    keep_inputs("--json", options.json, files_read(options.run.file, job.experiment), "what the run reads");
    if (options.worker) return answer_candidates(job);
    if (options.forget) forget_record(cache_folder(), key_of(job));
    const Tuning tuning = carried_out(job, options);
    if (!options.run.quiet) say("{}", tuning_table(tuning, job.device));
    if (!options.json.empty()) {
        const auto replace = nlohmann::ordered_json::error_handler_t::replace;  // a driver may not speak UTF-8
        write_file(options.json, to_json(tuning.record).dump(2, ' ', false, replace) + "\n");
    }
    const bool faulty = std::ranges::any_of(tuning.record.trials, [](const tune::Trial& trial) {
        return struck_out(trial.verdict) && trial.verdict != tune::Verdict::refused;
    });
    return faulty ? failed_check : success;
}

void add_options(CLI::App& command, TuneOptions& options) {
    command.add_option("FILE", options.run.file, "Experiment (.pex) of a lattice")->required()->type_name("");
    command.add_option("--device", options.run.device, "Index, type or part of the name; see `pelage devices`")
        ->type_name("INDEX|NAME");
    command
        .add_option_function<std::string>(
            "--precision",
            [&options](const std::string& word) {
                options.run.precision = word == "double" ? Precision::double_ : Precision::single_;
            },
            "float or double. Default: float")
        ->type_name("float|double")
        ->check(one_of({"float", "double"}));
    command.add_option("--seed", options.run.seed, "Seed of all random numbers, instead of the experiment's")
        ->type_name("N")
        ->transform(whole_number(std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()));
    add_settings(command, options.run.settings);
    command.add_flag("--fast", options.run.fast, "For runs with --fast");
    command.add_flag("--quick", options.quick, "The short search that comes before a long run: 5 seconds");
    command.add_option("--limit", options.limit, "What one candidate may take (default: 20)")
        ->type_name("SECONDS")
        ->check(number(0.1, 86'400));
    command.add_flag("--forget", options.forget, "Try all anew, what was struck out too");
    command.add_flag("--no-cache", options.run.no_cache, "Remember nothing");
    command.add_option("--json", options.json, "Write all trials to this file")->type_name("FILE");
    command.add_flag("--quiet", options.run.quiet, "Say nothing but errors");
    command.add_flag("--worker", options.worker)->group("");
    command.add_option("--from", options.from)->group("");
    command.add_option("--until", options.until)->group("");
}

}  // namespace

void add_tune(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<TuneOptions>();
    CLI::App* command = app.add_subcommand(
        "tune", "Try all ways to carry out an experiment's lattice on a device; later runs take the fastest");
    add_options(*command, *options);
    command->callback([options, &exit_code] { exit_code = tune_experiment(*options); });
}

}  // namespace pelage::app
