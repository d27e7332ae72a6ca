// `pelage check FILE...`: reads experiments without running them.
#include "app/commands.hpp"
#include "app/progress.hpp"
#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "opencl/explain.hpp"

#include <fmt/format.h>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace pelage::app {

namespace {

std::string counted(std::size_t count, const char* one, const char* many) {
    return fmt::format("{} {}", grouped(count), count == 1 ? one : many);
}

int check(const std::vector<std::string>& files, bool explain) {
    int exit_code = success;
    for (const std::string& file : files) {
        try {
            const Experiment experiment = parse_experiment_file(file);
            validate(experiment);
            fmt::print("{}: ok: {}, {}, {}, {}\n", file, counted(count_cells(experiment), "cell", "cells"),
                       counted(experiment.chemicals.size(), "chemical", "chemicals"),
                       counted(experiment.rules.size(), "rule", "rules"),
                       counted(experiment.last_iteration(), "iteration", "iterations"));
            if (!explain) continue;
            for (const std::string& line : explain_lattice(experiment, initial_state(experiment), Precision::single_)) {
                fmt::print("  {}\n", line);
            }
        } catch (const Error& error) {
            fmt::print(stderr, "pelage: {}\n", error.what());
            exit_code = bad_input;
        }
    }
    return exit_code;
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
    const auto files = std::make_shared<std::vector<std::string>>();
    CLI::App* command = app.add_subcommand("check", "Read experiments and say what is wrong with them; run nothing");
    command->add_option("FILE", *files, "Experiments (.pex)")->required()->type_name("");
    const auto explain = std::make_shared<bool>(false);
    command->add_flag("--explain", *explain,
                      "Say of lattices which iterations are fused on CPUs, and why others are not");
    command->callback([files, explain, &exit_code] { exit_code = check(*files, *explain); });
}

}  // namespace pelage::app
