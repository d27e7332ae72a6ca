// Small experiments that make every OpenCL call that the host knows, run as the command runs them.
#pragma once

#include "faults.hpp"

#include "app/run_options.hpp"
#include "support/process.hpp"
#include "support/variable.hpp"

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace test {

// How a run ended: with an exit code, or with an Error and what it said. Any other exception fails the test.
struct Ending {
    bool finished = false;
    std::string error;
};

// A folder with experiments, and the results of a run without faults to compare with.
class Stage {
public:
    // The last two on a CPU that says it is a GPU: other shapes of launches, and many of them.
    enum class Play { lattice, cells, sorting, lattice_on_gpu, cells_on_gpu };

    explicit Stage(Play);

    pelage::app::RunOptions& options() { return options_; }
    Machine machine;  // to run on

    // Runs on `machine` into a new, empty results folder.
    Ending run();

    // What is wrong with the results folder: files that are half-written or belong nowhere, and, against the files of
    // good(), contents that differ.
    std::vector<std::string> damage() const;

    void keep_as_good();
    void play_on_reference();  // and keep its results as the good ones: they equal a device's to the bit

    // Makes the next run go on from this one's checkpoint.
    void resume();
    const std::map<std::string, std::string>& good() const { return good_; }
    std::filesystem::path results() const { return folder_ / "results"; }

private:
    Folder folder_;
    Variable device_{"PELAGE_DEVICE", nullptr};
    Variable temporary_;  // where sources of programs go that could not be built
    pelage::app::RunOptions options_;
    std::map<std::string, std::string> good_;  // by name
};

}  // namespace test
