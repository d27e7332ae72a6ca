// The subcommands of `pelage`: one file each, one line here and in command_line.cpp.
#pragma once

namespace CLI {
class App;
}

namespace pelage::app {

// Exit codes of every subcommand.
inline constexpr int success = 0;
inline constexpr int failed_check = 1;  // a run met NaN or infinity, a check failed
inline constexpr int bad_input = 2;     // nothing, or not all, could be done: the message says why
inline constexpr int interrupted = 130;

// Each adds its subcommand; when the command line names it, it runs while that is parsed and sets the exit code.
void add_run(CLI::App&, int& exit_code);
void add_devices(CLI::App&, int& exit_code);
void add_check(CLI::App&, int& exit_code);
void add_sweep(CLI::App&, int& exit_code);
void add_measure(CLI::App&, int& exit_code);
void add_learn(CLI::App&, int& exit_code);
void add_verify(CLI::App&, int& exit_code);
void add_bench(CLI::App&, int& exit_code);
void add_tune(CLI::App&, int& exit_code);
void add_import(CLI::App&, int& exit_code);
void add_help(CLI::App&, int& exit_code);
void add_completion(CLI::App&, int& exit_code);

}  // namespace pelage::app
