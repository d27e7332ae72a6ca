// `pelage check FILE...`: reads experiments without running them.
#include "app/change_notes.hpp"
#include "app/commands.hpp"
#include "app/foresee.hpp"
#include "app/parameters.hpp"
#include "app/read_experiment.hpp"
#include "app/say.hpp"
#include "app/settings.hpp"
#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "core/space.hpp"
#include "language/previous.hpp"
#include "opencl/lattice/explain.hpp"

#include <fmt/format.h>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace pelage::app {

namespace {

struct CheckOptions {
    std::vector<std::string> files;
    std::vector<std::string> settings;
    bool explain = false;
    bool strict = false;
    bool parameters = false;
    bool json = false;
};

void explain_paths(const Experiment& experiment) {
    const Space space = space_of(experiment);
    const auto* lattice = std::get_if<Lattice>(&space);
    if (!on_grid(space) || (lattice != nullptr && lattice->charges)) return;
    const DeviceInfo processor = usual_processor();
    const Snapshot initial = initial_state(experiment);
    say("  on a processor of {}:\n", counted(processor.processors, "thread"));
    for (const std::string& line : explain_lattice(experiment, initial, Precision::single_, processor)) {
        say("  {}\n", line);
    }
}

Experiment read_checked(const std::string& file, const CheckOptions& options, Outline* outline) {
    return read_experiment(file, outline, StartPictures::read, settings_of(options.settings));
}

// Statements that begin so. An experiment may have more rules: previous() adds some.
std::size_t count(const Outline& outline, std::string_view words) {
    return static_cast<std::size_t>(std::ranges::count_if(
        outline.statements, [&](const Outline::Statement& one) { return one.what.starts_with(words); }));
}

// How many warnings there are.
std::size_t check_file(const std::string& file, const CheckOptions& options) {
    Outline outline;
    const Experiment experiment = read_checked(file, options, &outline);
    check_start(experiment);
    std::vector<Warning> warnings = lint(experiment, outline, experiment.last_iteration());
    if (const auto large = warn_of_size(experiment, outline)) warnings.push_back(*large);
    const auto chemicals = static_cast<std::size_t>(std::ranges::count_if(
        experiment.chemicals, [](const Chemical& one) { return !language::keeps_previous(one); }));
    say("{}: ok: {}, {}, {}, {}{}\n", experiment.source, counted(count_cells(experiment), "cell"),
        counted(chemicals, "chemical"), counted(count(outline, "rule"), "rule"),
        counted(experiment.last_iteration(), "iteration"),
        warnings.empty() ? "" : "; " + counted(warnings.size(), "warning"));
    send();  // the warnings come after the line of their file
    print_warnings(experiment, warnings);
    if (options.explain) {
        for (const std::string& note : change_notes(experiment)) say("  {}\n", note);
        explain_paths(experiment);
    }
    return warnings.size();
}

void list_parameters(const CheckOptions& options) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const std::string& file : options.files) {
        const Experiment experiment = read_checked(file, options, nullptr);
        all.push_back(parameters_json(experiment));
        if (!options.json) say("{}", parameters_text(experiment));
    }
    if (options.json) say("{}\n", (all.size() == 1 ? all.front() : all).dump(2));
}

int check(const CheckOptions& options) {
    if (options.json && !options.parameters)
        throw Error("--json belongs to --parameters: `pelage check --parameters --json FILE`");
    if (options.parameters) {
        list_parameters(options);
        return success;
    }
    int exit_code = success;
    std::size_t warnings = 0;
    for (const std::string& file : options.files) {
        try {
            warnings += check_file(file, options);
        } catch (const Error& error) {
            say(stderr, "pelage: {}\n", error.what());
            exit_code = bad_input;
        }
    }
    return exit_code == success && options.strict && warnings > 0 ? failed_check : exit_code;
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<CheckOptions>();
    CLI::App* command = app.add_subcommand("check", "Read experiments and say what is wrong with them; run nothing");
    command->add_option("FILE", options->files, "Experiments (.pex); - reads standard input")
        ->required()
        ->type_name("");
    command->add_flag("--strict", options->strict, "Exit code 1 where there are warnings");
    command->add_flag("--parameters", options->parameters, "List the parameters: value, default, range, meaning");
    command->add_flag("--json", options->json, "The list as JSON");
    add_settings(*command, options->settings);
    command->add_flag(
        "--explain", options->explain,
        "Say of lattices how a processor carries out their iterations, and why; and what `change` adds in a unit of "
        "time");
    command->callback([options, &exit_code] { exit_code = check(*options); });
}

}  // namespace pelage::app
