// See stage.hpp.
#include "stage.hpp"

#include "app/runner.hpp"
#include "core/error.hpp"
#include "io/checkpoint.hpp"
#include "opencl/device/pocl.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cstdlib>

namespace test {

namespace {

// Grows, changes phase, and has every kind of plane: rates of each cell, polarity, mappings, births, counts.
const std::string lattice_text = R"(
define chemical U limit 9
define chemical V limit 9
define chemical W anisotropic
define time_step 0.01
use seed 5
use chemical U conc 4 dev 0.5 diff 8
use chemical V conc 4 dev 0.5 diff 2 dev 0.5
use chemical W conc 1 dev 0.5 diff 1
use polarity 30 dev 60
create matrix 7 6 wrap
phase "first" 6
rule always react U V turing alpha 16 beta 12
rule every 3 offset 1 always expand columns 1 rows 1
phase "second" 6
define time_step 0.005
use chemical V diff 1
rule always react U V turing alpha 16 beta 12
rule if AGE > 3 and
rule if NEIGHBORS > 3 change W conc 0.01 dev 0.01
rule always map X -5 5 to M 0 1
rule if M > 0.5 change V diff 0.01
rule always polarize U conc
rule from 2 always expand columns 1
)";

// So many launches that the host has to wait for the first of them.
const std::string long_text = R"(
define chemical U limit 9
define chemical V limit 9
define time_step 0.01
use chemical U conc 4 dev 0.5 diff 8
use chemical V conc 4 dev 0.5 diff 2
create matrix 70 3 no-flux
rule always react U V turing alpha 16 beta 12
rule from 80 until 80 always expand rows 1
stop at 100
)";

// Divides, moves, and has mirror pairs.
const std::string cells_text = R"(
define chemical U limit 9
define chemical V anisotropic
use seed 3
use chemical U conc 4 dev 1 diff 0.05
use chemical V conc 4 dev 1 diff 0.01
create shape "pair.txt"
use polarity 30 dev 60
create hex_circle 3 at 12 3
phase "first" 7
rule always react U V scale 0.004 turing alpha 16 beta 12
rule probability 0.3 divide direction 0 dev 180
phase "second" 5
use chemical V diff 0.02
rule if V conc > 3 move 0.05 dev 0.02
rule always map AGE 0 5 to M 0 1
rule always polarize V conc
)";

pelage::app::RunOptions options_for(const Folder& folder, Stage::Play play) {
    folder.write("pair.txt", "ABCD\ndcba\n");
    pelage::app::RunOptions options;
    const bool lattice = play == Stage::Play::lattice || play == Stage::Play::lattice_on_gpu;
    const std::string& text = play == Stage::Play::lattice_on_gpu ? long_text : lattice ? lattice_text : cells_text;
    options.file = folder.write(lattice ? "lattice.pex" : "cells.pex", text);
    options.backend = "opencl";
    options.out = folder / "results";
    options.formats = "npy,csv";
    options.snap_every = play == Stage::Play::lattice_on_gpu ? 80 : 6;
    options.checkpoint_every = play == Stage::Play::lattice_on_gpu ? 90 : 4;
    if (play == Stage::Play::sorting) {
        options.neighbours = "spatial-sorting";
        options.iterations = 5;
        options.snap_every = 3;
        options.checkpoint_every = 2;
    }
    options.quiet = true;
    options.no_self_test = true;  // it is remembered: some runs would have it and others not
    return options;
}

bool readable(const std::filesystem::path& file) {
    try {
        if (file.extension() == ".pelage") pelage::read_checkpoint(file);
        if (file.extension() == ".json") return nlohmann::json::accept(read_all(file));
        return true;
    } catch (const std::exception&) {
        return false;
    }
}

}  // namespace

namespace {

// PoCL compiles in a folder that it keeps for the whole program: not in that of a stage, which goes.
const char* name_of_temporary_folder() {
    pelage::prepare_pocl();
    return "TMPDIR";
}

}  // namespace

Stage::Stage(Play play)
    : temporary_(name_of_temporary_folder(), folder_.path().c_str()), options_(options_for(folder_, play)) {
    if (play != Play::lattice_on_gpu && play != Play::cells_on_gpu) return;
    machine.answer(CL_DEVICE_TYPE, cl_device_type{CL_DEVICE_TYPE_GPU});
}

Ending Stage::run() {
    Faults::layer().machine = machine;
    std::filesystem::remove_all(results());
    try {
        return {pelage::app::run_experiment(options_) == 0, ""};
    } catch (const pelage::Error& error) {
        return {false, error.what()};
    }
}

std::vector<std::string> Stage::damage() const {
    std::vector<std::string> found;
    if (!std::filesystem::exists(results())) return found;
    for (const std::string& name : names_in(results())) {
        // By these the next run tells what a run that broke off has left.
        if (name == ".pelage-results" || name == ".pelage-reel") continue;
        const auto known = good_.find(name);
        if (known == good_.end()) {
            found.push_back(name + " belongs nowhere");
        } else if (!readable(results() / name)) {
            found.push_back(name + " cannot be read");
        } else if (name != "manifest.json" && name != "checkpoint.pelage" &&
                   read_all(results() / name) != known->second) {
            found.push_back(name + " differs");
        }
    }
    return found;
}

void Stage::play_on_reference() {
    options_.backend = "reference";
    const Ending ending = run();
    INFO(ending.error);
    REQUIRE(ending.finished);
    keep_as_good();
    options_.backend = "opencl";
}

void Stage::resume() {
    options_.resume = folder_ / "kept.pelage";
    std::filesystem::copy_file(results() / "checkpoint.pelage", options_.resume);
}

void Stage::keep_as_good() {
    good_.clear();
    for (const std::string& name : names_in(results())) good_[name] = read_all(results() / name);
}

}  // namespace test
