// `pelage bench`: how fast each backend is on this machine, against each other and against what the machine can do.
#include "app/commands.hpp"
#include "app/draw_report.hpp"
#include "app/named_files.hpp"
#include "app/prepare.hpp"
#include "app/say.hpp"
#include "app/validators.hpp"
#include "bench/guard.hpp"
#include "bench/measure.hpp"
#include "bench/options.hpp"
#include "bench/report.hpp"
#include "io/atomic_file.hpp"
#include "io/locked.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>

namespace pelage::app {

namespace {

struct BenchOptions {
    bench::Options what;
    std::filesystem::path json, plot, guard;
};

// A line that the next one replaces on a terminal; in a log nothing but the results is wanted.
void show(const std::string& text) {
    if (isatty(STDERR_FILENO) != 0) say(stderr, "\r\x1b[K{}", text);
}

void write_json(const std::filesystem::path& file, const BenchOptions& options, const bench::Report& report,
                bool complete) {
    const auto replace = nlohmann::ordered_json::error_handler_t::replace;  // a driver may not speak UTF-8
    write_file(file, bench::json_of(report, options.what, complete).dump(2, ' ', false, replace) + "\n");
}

void draw(const BenchOptions& options, const bench::Report& report) {
    const PrivateFolder folder(std::filesystem::temp_directory_path(), "pelage-plot-");
    write_json(folder.path() / "results.json", options, report, true);
    draw_report(folder.path() / "results.json", options.plot);
}

// The file is whole after each case, so that a run that is cut keeps what it measured. A pipe gets everything at the
// end.
void keep(const BenchOptions& options, const bench::Report& report) {
    if (options.json.empty() || std::filesystem::is_other(options.json)) return;
    write_json(options.json, options, report, false);
}

int finish(const BenchOptions& options, const bench::Report& report) {
    if (isatty(STDERR_FILENO) != 0) say(stderr, "\r\x1b[K");
    say("{}", bench::tables(report));
    if (!options.json.empty()) write_json(options.json, options, report, true);
    if (!options.plot.empty()) draw(options, report);
    const bool wrong = std::ranges::any_of(report.notes, [](const bench::Note& note) { return note.wrong; });
    return wrong ? failed_check : success;
}

int bench_all(const BenchOptions& options) {
    return finish(options,
                  bench::measure(options.what, show, [&](const bench::Report& report) { keep(options, report); }));
}

// The shares of several calls under the yardsticks of the first.
void join(bench::Report& all, bench::Report part) {
    if (all.yardsticks.empty()) {
        all.yardsticks = part.yardsticks;
        all.load = part.load;
    }
    all.results.insert(all.results.end(), part.results.begin(), part.results.end());
    all.notes.insert(all.notes.end(), part.notes.begin(), part.notes.end());
}

int bench_guard(const BenchOptions& options) {
    const bench::Guard guard = bench::read_guard(options.guard);
    bench::Report report;
    for (const bench::Options& part : bench::options_for(guard, options.what)) {
        const auto keep_all = [&](const bench::Report& so_far) {
            bench::Report all = report;
            join(all, so_far);
            keep(options, all);
        };
        join(report, bench::measure(part, show, keep_all));
    }
    const int exit_code = finish(options, report);
    const bench::Verdict verdict = bench::judge(guard, bench::ratios(report));
    say("\n{}", verdict.text);
    return verdict.kept ? exit_code : failed_check;
}

int run_bench(const BenchOptions& options) {
    check(options.what);
    if (!options.plot.empty()) require_plotter();
    for (const auto& file : {options.json, options.plot}) {
        if (!file.empty()) prepare_json(file);
        keep_inputs(file == options.json ? "--json" : "--plot", file, {options.guard}, "what --guard reads");
    }
    return options.guard.empty() ? bench_all(options) : bench_guard(options);
}

}  // namespace

void add_bench(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<BenchOptions>();
    CLI::App* command =
        app.add_subcommand("bench", "Measure how fast the backends are, after checking that they agree to the bit");
    const auto list = [&](const char* name, auto& value, const char* text, const char* type) {
        return command->add_option(name, value, text)->delimiter(',')->type_name(type)->transform(trimmed());
    };
    command
        ->add_option(
            "--suite", options->what.suite,
            "lattice, formula, cells, neighbours, growth, aggregate, volume, mesh, neural or all (default all)")
        ->type_name("lattice|cells|neighbours|growth|all");
    command->add_option("--device", options->what.device, "Index or name of an OpenCL device, or all")
        ->type_name("DEVICE");
    list("--against", options->what.against,
         "Backends beside opencl: reference, openmp, nanoflann, nanoflann-openmp, opencl-plain, opencl-step, "
         "opencl-fast, opencl-twin",
         "LIST");
    list("--sizes", options->what.sizes, "Sides of lattices; numbers of free cells and points", "LIST")
        ->check(whole_number(0, std::numeric_limits<std::int64_t>::max()));
    list("--cases", options->what.cases, "Only these cases of the suites; all: every one", "LIST");
    command->add_option("--runs", options->what.runs, "Runs of each backend, turn by turn (default 5)")
        ->type_name("N")
        ->transform(whole_number(0, 1'000'000));
    command->add_flag("--quick", options->what.quick, "Small sizes and short runs: to see that all works");
    command->add_option("--json", options->json, "Write results to this file too")->type_name("FILE");
    command->add_option("--plot", options->plot, "Draw FILE.roofline.png and FILE.scaling.png")->type_name("FILE");
    command
        ->add_option("--guard", options->guard,
                     "Measure what this table of ratios names; exit code 1 where one is lost")
        ->type_name("FILE");
    command->callback([options, &exit_code] { exit_code = run_bench(*options); });
}

}  // namespace pelage::app
