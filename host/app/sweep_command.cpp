// `pelage sweep FILE`: an experiment at many values of its parameters.
#include "app/commands.hpp"
#include "app/settings.hpp"
#include "app/sweeper.hpp"
#include "app/validators.hpp"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <limits>
#include <memory>

namespace pelage::app {

namespace {

void add_design(CLI::App& command, SweepOptions& options) {
    command
        .add_option(
            "--vary", options.vary,
            "Values of a parameter: NAME=LOW:HIGH:COUNT, NAME=log:LOW:HIGH:COUNT or NAME=A,B,C; may be given for "
            "several. With --samples NAME=LOW:HIGH")
        ->type_name("NAME=VALUES")
        ->allow_extra_args(false);
    command.add_option("--samples", options.samples, "Draw N points within the ranges instead of taking their grid")
        ->type_name("N")
        ->transform(whole_number(1, sweep::largest_tile_count));
    command.add_flag("--latin", options.latin, "Draw samples as a Latin hypercube");
    command.add_option("--points", options.points, "A table (CSV) of parameter sets instead of --vary")
        ->type_name("FILE");
    command
        .add_option("--replicates", options.replicates,
                    "Repeat every point with N seeds, one after another. Default: 1")
        ->type_name("N")
        ->transform(whole_number(1, sweep::largest_tile_count));
    add_settings(command, options.run.settings);
}

void add_course(CLI::App& command, SweepOptions& options) {
    command
        .add_option("--iterations", options.run.iterations,
                    "End each tile at iteration N instead of where the experiment says")
        ->type_name("N")
        ->transform(whole_number(1, largest_iteration));
    command
        .add_option("--until", options.until,
                    "End a tile as soon as a hundredth of its iterations changes less than this share of its range")
        ->type_name("steady TOLERANCE")
        ->expected(2);
    command.add_option("--seed", options.run.seed, "Seed of all tiles, and of samples. Default: the experiment's")
        ->type_name("N")
        ->transform(whole_number(std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()));
    command.add_flag("--force", options.run.force, "Run tiles whose time step is known to be unstable, too");
}

void add_machine(CLI::App& command, SweepOptions& options) {
    command
        .add_option("--backend", options.run.backend,
                    "What computes: reference or opencl. Default: opencl where it can")
        ->type_name("reference|opencl")
        ->check(one_of({"reference", "opencl"}));
    command
        .add_option("--device", options.run.device, "OpenCL device, as in `pelage run`; all: every device takes tiles")
        ->type_name("INDEX|NAME|all");
    command
        .add_option_function<std::string>(
            "--precision",
            [&options](const std::string& word) {
                options.run.precision = word == "double" ? Precision::double_ : Precision::single_;
            },
            "Numbers: float or double. Default: float")
        ->type_name("float|double")
        ->check(one_of({"float", "double"}));
    command
        .add_option(
            "--jobs", options.jobs,
            "Tiles at one time, each on one processor. Default: as many as there are processors, for small tiles "
            "on a processor; else 1")
        ->type_name("N")
        ->transform(whole_number(1, 256));
    command
        .add_option("--batch", options.batch,
                    "Tiles of one structure that run together, in the same launches. Default: on a GPU as many as fill "
                    "it, else 1")
        ->type_name("N")
        ->transform(whole_number(1, sweep::largest_tile_count));
    command.add_flag("--no-self-test", options.run.no_self_test, "Leave out the test in small that comes before");
}

void add_results(CLI::App& command, SweepOptions& options) {
    command
        .add_option("-o,--out", options.run.out,
                    "Folder for the results, made if need be. Default: out/NAME of the experiment")
        ->type_name("DIR");
    command
        .add_option("--format", options.run.formats,
                    "Files of each tile, in DIR/tiles: png, npy, exr, ... Default: none")
        ->type_name("LIST");
    command.add_option("--sheet", options.sheet, "The contact sheet's kind of file. Default: png")
        ->type_name("png|svg|pdf")
        ->check(one_of({"png", "svg", "pdf"}));
    command
        .add_option("--across", options.across,
                    "Points or samples side by side in the sheet. Default: about as many as one upon another")
        ->type_name("N")
        ->transform(whole_number(1, sweep::largest_tile_count));
    command.add_flag("--quiet", options.run.quiet, "Say nothing but errors");
}

}  // namespace

void add_sweep(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<SweepOptions>();
    CLI::App* command =
        app.add_subcommand("sweep", "Run an experiment at many values of its parameters, and measure each");
    command->add_option("FILE", options->run.file, "Experiment (.pex)")->required()->type_name("");
    add_design(*command, *options);
    add_course(*command, *options);
    add_machine(*command, *options);
    add_results(*command, *options);
    command->callback([options, &app, &exit_code] {
        options->run.command = app.get_name();
        exit_code = run_sweep(*options);
    });
}

}  // namespace pelage::app
