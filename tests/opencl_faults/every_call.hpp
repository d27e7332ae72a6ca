// Runs with one OpenCL call that fails. What must follow: an Error that names the OpenCL code and the device, or a run
// to the end with the right results; all objects given back; and no file that is half-written.
#pragma once

#include "faults.hpp"
#include "stage.hpp"

#include <cstddef>
#include <vector>

namespace test {

inline const std::vector<Stage::Play> all_plays{Stage::Play::lattice, Stage::Play::cells, Stage::Play::sorting,
                                                Stage::Play::lattice_on_gpu, Stage::Play::cells_on_gpu};

// The calls of a run without faults, whose results are kept as the good ones.
std::vector<Call> calls_of_a_good_run(Stage&);

// Runs with the nth call failing with that code, and checks what followed. False when the run did not get so far: how
// many batches it takes, and so how many calls, depends on the time they take.
bool check_failing_call(Stage&, std::size_t nth, cl_int code);

// What must be true after any run.
void check_nothing_broken(const Stage&, const Ending&);

}  // namespace test
