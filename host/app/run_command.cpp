// `pelage run FILE`: its options.
#include "app/commands.hpp"
#include "app/film_plan.hpp"
#include "app/run_options.hpp"
#include "app/runner.hpp"
#include "app/settings.hpp"
#include "app/validators.hpp"
#include "core/error.hpp"
#include "io/results.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <sstream>
#include <string>

namespace pelage::app {

namespace {

CLI::Validator count_from(std::int64_t smallest) { return whole_number(smallest, largest_iteration); }

// A list as parse_formats() reads it; a mistyped word is answered with the nearest one.
CLI::Validator formats() {
    const auto look = [](std::string& list) -> std::string {
        std::istringstream words(list);
        for (std::string word; std::getline(words, word, ',');) {
            try {
                (void)parse_formats(word);
            } catch (const Error& error) {
                return error.what() + meant(word, format_words());
            }
        }
        return list.empty() || list.back() == ',' ? "a format is missing in '" + list + "'" : "";
    };
    return {look, ""};
}

CLI::Validator frame_size() {
    const auto look = [](std::string& word) -> std::string {
        try {
            (void)parse_frame_size(word);
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    };
    return {look, ""};
}

void add_backend_options(CLI::App& command, RunOptions& options) {
    command
        .add_option("--backend", options.backend,
                    "What computes: reference (plain C++, slow) or opencl. "
                    "Default: opencl where a device is usable, else reference")
        ->type_name("reference|opencl")
        ->check(one_of({"reference", "opencl"}));
    command
        .add_option("--device", options.device,
                    "OpenCL device: its index in `pelage devices`, its type (gpu, cpu) or part of its name "
                    "or its platform's. "
                    "Default: the first usable GPU, else CPU")
        ->type_name("INDEX|NAME");
    command
        .add_option_function<std::string>(
            "--precision",
            [&options](const std::string& word) {
                options.precision = word == "double" ? Precision::double_ : Precision::single_;
            },
            "Numbers of 32 bits (float) or 64 bits (double). Default: float")
        ->type_name("float|double")
        ->check(one_of({"float", "double"}));
}

void add_search_options(CLI::App& command, RunOptions& options) {
    command
        .add_option("--neighbours", options.neighbours,
                    "Search of free cells: bins or kd-tree (both exact), or spatial-sorting (the published program's, "
                    "which misses some; the manifest says how many). Default: bins")
        ->type_name("bins|kd-tree|spatial-sorting")
        ->check(one_of({"bins", "kd-tree", "spatial-sorting"}));
    command
        .add_option("--window", options.sorting.window,
                    "Places around a cell that spatial-sorting looks at: 8, 24, 48, 80 or 120. Default: 48")
        ->type_name("8|24|48|80|120")
        ->check(one_of({"8", "24", "48", "80", "120"}));
}

void add_kernel_options(CLI::App& command, RunOptions& options) {
    command.add_flag("--fast", options.fast,
                     "Let the OpenCL compiler reorder arithmetic: faster, but no longer the reference's bits");
    command.add_flag("--no-self-test", options.no_self_test,
                     "Run even on a device that fails, or without asking it, the test in small before a run");
    command.add_flag("--no-tune", options.no_tune,
                     "Take the usual kernel of a lattice as it is; without this a long run first looks for a faster "
                     "one, in 5 seconds, or remembers it");
    command.add_flag("--no-cache", options.no_cache,
                     "Compile device programs anew, keep none on disk and remember nothing");
}

void add_course_options(CLI::App& command, RunOptions& options) {
    add_settings(command, options.settings);
    command
        .add_option(
            "--random", options.random,
            "Draw every parameter that has a range, within it: the same N draws the same. The experiment drawn is "
            "DIR/drawn.pex")
        ->type_name("N")
        ->transform(count_from(0));
    command
        .add_option("--iterations", options.iterations,
                    "Iterations to end at, counted from 0, resumed runs too. Default: as the experiment says")
        ->type_name("N")
        ->transform(count_from(0));
    command
        .add_option("--seed", options.seed,
                    "Seed of all random numbers, instead of the experiment's; 0: from the clock")
        ->type_name("N")
        ->transform(whole_number(std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()));
    command
        .add_option("--checkpoint-every", options.checkpoint_every,
                    "Save DIR/checkpoint.pelage every N iterations. Default: only when interrupted")
        ->type_name("N")
        ->transform(count_from(1));
    command
        .add_option("--resume", options.resume,
                    "Go on from a checkpoint of the same experiment, precision and seed, to the same bits")
        ->type_name("CHECKPOINT");
    command.add_flag("--force", options.force, "Run even where the time step is known to be unstable");
}

void add_result_options(CLI::App& command, RunOptions& options) {
    command
        .add_option("-o,--out", options.out,
                    "Folder for the results, made if need be. Default: out/NAME of the experiment")
        ->type_name("DIR");
    command
        .add_option(
            "--format", options.formats,
            fmt::format(
                "Files to write, separated by commas: {}. Default: exr,png,ply, of which each space has its own",
                fmt::join(format_words(), ", ")))
        ->type_name("LIST")
        ->check(formats());
    command
        .add_option("--exr-type", options.exr_type, "Numbers of 32 bits (float) or 16 (half) in EXR. Default: float")
        ->type_name("float|half")
        ->check(one_of({"float", "half"}));
    command.add_option("--png-bits", options.png_bits, "Bits a channel of PNG pictures: 8 or 16. Default: 8")
        ->type_name("8|16")
        ->check(one_of({"8", "16"}));
    command
        .add_option("--snap-every", options.snap_every,
                    "Write ITERATION.* every N iterations from 0 on, beside the experiment's own snapshots")
        ->type_name("N")
        ->transform(count_from(1));
    command
        .add_option("--cells", options.cells,
                    "Shape of free cells in pictures: circle, hexagon or voronoi. Default: circle")
        ->type_name("circle|hexagon|voronoi")
        ->check(one_of({"circle", "hexagon", "voronoi"}));
    command.add_flag("--polarity-marks", options.polarity_marks, "Draw a line along each free cell's polarity");
    command.add_option("--json", options.json, "Write the manifest to this file too")->type_name("FILE");
    command.add_flag("--explain", options.explain,
                     "Say in the end how the iterations of a lattice were carried out, and why");
    command.add_flag("--quiet", options.quiet, "Say nothing but errors");
}

void add_video_options(CLI::App& command, VideoOptions& video) {
    CLI::Option* file =
        command.add_option("--video", video.file, "Make a film of the run, too: an .mp4, .webm or .gif; needs ffmpeg")
            ->type_name("FILE");
    command
        .add_option("--video-of", video.of,
                    "The output that is filmed, named as in final.NAME.png, or texture. Default: the one in final.png")
        ->type_name("NAME")
        ->needs(file);
    command
        .add_option("--every", video.every,
                    "A frame every N iterations, and one of the first and the last state. Default: as fit 20 seconds")
        ->type_name("N")
        ->transform(count_from(1))
        ->needs(file);
    command.add_option("--fps", video.fps, "Frames that are shown in a second. Default: 30")
        ->type_name("N")
        ->transform(whole_number(1, 240))
        ->needs(file);
    command
        .add_option("--size", video.size,
                    "Pixels of a frame; the picture is brought to it without a change of its proportions. "
                    "Default: as large as the pictures of the run, up to 2048 pixels")
        ->type_name("WIDTHxHEIGHT")
        ->check(frame_size())
        ->needs(file);
}

// Every option the command has, so that the manifest can never miss one.
std::vector<OptionGiven> options_given(const CLI::App& command) {
    std::vector<OptionGiven> all;
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_single_name() == "help") continue;
        OptionGiven one{option->get_single_name(), option->get_items_expected_max() == 0, std::nullopt};
        if (option->count() > 0) one.value = fmt::format("{}", fmt::join(option->results(), ","));
        all.push_back(std::move(one));
    }
    return all;
}

}  // namespace

void add_run(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<RunOptions>();
    CLI::App* command = app.add_subcommand("run", "Run an experiment and write pictures, data and a manifest");
    command->add_option("FILE", options->file, "Experiment (.pex); - reads standard input")->required()->type_name("");
    add_backend_options(*command, *options);
    add_search_options(*command, *options);
    add_kernel_options(*command, *options);
    add_course_options(*command, *options);
    add_result_options(*command, *options);
    add_video_options(*command, options->video);
    command->callback([options, command, &app, &exit_code] {
        options->command = app.get_name();
        options->given = options_given(*command);
        exit_code = run_experiment(*options);
    });
}

}  // namespace pelage::app
