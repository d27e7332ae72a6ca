// The `pelage` command: picks the subcommand and turns every error into one sentence and an exit code.
#include "app/command_line.hpp"
#include "app/commands.hpp"

#include <CLI/App.hpp>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>

namespace {

using pelage::app::complain;

int run(int argc, char** argv) {
    int exit_code = pelage::app::success;
    CLI::App app;
    pelage::app::define(app, exit_code);
    const int parsed = pelage::app::parse(app, argc, argv);
    if (parsed != pelage::app::success) return parsed;
    if (std::fflush(stdout) != 0) return complain("standard output cannot be written");
    return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
    // PoCL reads this when the OpenCL loader starts: without it both of its threads may share a core.
    setenv("POCL_AFFINITY", "1", 0);
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        return complain("out of memory");
    } catch (const std::exception& error) {
        return complain(error.what());
    }
}
