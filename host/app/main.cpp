// The `pelage` command: picks the subcommand and turns every error into one sentence and an exit code.
#include "app/commands.hpp"
#include "app/last_will.hpp"
#include "app/say.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <exception>
#include <new>
#include <string>
#include <vector>

namespace {

int complain(const std::string& text) {
    pelage::app::say(stderr, "pelage: {}\n", text);
    return pelage::app::bad_input;
}

int parse(CLI::App& app, int argc, char** argv) {
    const std::string first = argc > 1 ? argv[1] : "-";
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    if (first[0] != '-' && std::find(names.begin(), names.end(), first) == names.end()) {
        return complain(fmt::format("there is no command '{}'; there are: {}", first, fmt::join(names, ", ")));
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
        return complain(std::string(error.what()) + " (see `pelage --help`)");
    }
    return pelage::app::success;
}

int run(int argc, char** argv) {
    int exit_code = pelage::app::success;
    CLI::App app("Grows animal skin patterns by reaction and diffusion, on any OpenCL device or on a plain reference.");
    app.set_version_flag("--version", "pelage " PELAGE_VERSION, "Print the version and stop");
    app.require_subcommand(1);
    app.get_formatter()->column_width(34);
    app.footer(
        "Exit codes: 0 success; 1 a run met NaN or infinity, a check failed; 2 bad input; 130 stopped by Ctrl-C.\n"
        "`pelage COMMAND --help` tells the options of one command.");
    pelage::app::add_run(app, exit_code);
    pelage::app::add_devices(app, exit_code);
    pelage::app::add_check(app, exit_code);
    pelage::app::add_verify(app, exit_code);
    pelage::app::add_bench(app, exit_code);
    pelage::app::add_tune(app, exit_code);
    const int parsed = parse(app, argc, argv);
    if (parsed != pelage::app::success) return parsed;
    // A run's results are files, and these are whole.
    if (!pelage::app::printed() && !app.got_subcommand("run")) return complain("standard output cannot be written");
    return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
    pelage::app::prepare_printing();
    pelage::app::tidy_when_killed();
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        return complain("out of memory");
    } catch (const std::exception& error) {
        return complain(error.what());
    }
}
