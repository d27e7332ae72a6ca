"""What `pelage verify --full` does not run on PoCL, and why."""

FAILS = "only where a call fails or memory is short: opencl_faults lets each call of a run fail"
REFUSES = "a sentence to who asks for what cannot be: tests/opencl, tests/opencl_cells and tests/app ask"
OTHER_DEVICE = "of another kind of device than PoCL's: opencl_faults pretends to have one, docs/conformance tells of real ones"
LITTLE_MEMORY = "of devices with less local memory than PoCL's: tests/opencl cuts for them"
RASTERISER = "of rusticl on llvmpipe, which ends long loops: docs/conformance keeps its report"
CHOICE = "what a run takes where nothing is asked for; checks ask for each path by name: tests/opencl asks what is chosen"
ASKED = "of a tissue or backend, for the command: tests/app and tests/sweep read it"
NEVER = "cannot be: all cases are above it"
ORDERS = "of programs in another order (PELAGE_SCHEDULE): test_schedules runs them"

# A file (a pattern of the shell), what tells the lines, and the reason. What tells: a regular expression found in the
# statement that a line is part of; or "within ...": one found in the head of a block around the line.
HOST = [
    ("host/opencl/*", r"\bthrow Error\(", REFUSES),
    ("host/opencl/*", r"within \} catch \(", FAILS),
    ("host/opencl/*", r"ProgramCounts|> report\(\)|string name\(\) const|iteration\(\) const|do_cells\(\)", ASKED),
    # Devices, and what is told of them
    ("host/opencl/backend.cpp", r"return fmt::format\(\"device '\{\}' has no double precision", REFUSES),
    ("host/opencl/backend.cpp", r"precision\(\) const|device\(\) const|build_options\(\) const", ASKED),
    ("host/opencl/backend.cpp", r"within structure|batch_room", ASKED),
    ("host/opencl/device/cl_error.cpp", r"within names_of_codes|cl_error_name|cl_failure", FAILS),
    ("host/opencl/device/device.cpp", r"within why_no_devices|failure_of|stand_in", FAILS),
    ("host/opencl/device/device.cpp", r"return \"(accelerator|other)\"|OpenCL 1.2 is needed|stand_in", OTHER_DEVICE),
    ("host/opencl/device/device_choice.cpp", r"within listing|is_type|rank", "a device by its kind: tests/opencl asks for several"),
    ("host/opencl/device/device_choice.cpp", r"is_type\(word\)|platform_version", "a device by its name: tests/opencl asks for several"),
    ("host/opencl/device/device_choice.cpp", r"try \{|devices\.at\(", "the variable PELAGE_DEVICE: tests/opencl sets it"),
    ("host/opencl/device/guards.cpp", r"const auto at = ", "where a kernel wrote past an end: tests/verify lets one"),
    ("host/opencl/device/options.hpp", r"operator==", "of the tuner: tests/tune compares cuts"),
    ("host/opencl/device/options.hpp", r"std::size_t (depth|columns|rows|group) = 0;", "nothing to run: a compiler may count them at all"),
    ("host/opencl/device/pocl.cpp", r"trouble \+?=|rlim_cur", FAILS),
    ("host/opencl/device/pocl.cpp", r"pocl_folder_name", ASKED),
    ("host/opencl/device/pocl.cpp", r"std::max\(most_threads, usable\)", "the variable of PoCL for its threads: tests/app sets it"),
    ("host/opencl/device/pocl.cpp", r"^return value;|create_directories|emplace_back\(\*set\)", "the variable POCL_CACHE_DIR: tests/app sets it"),
    ("host/opencl/device/pocl.cpp", r"within share_processors", "of the process that deals checks, which runs none here: tests/app watches its children's processors"),
    ("host/opencl/device/pocl_programs.cpp", r"within write_whole", "programs that another run has left: tests/opencl puts them back"),
    ("host/opencl/device/schedule.cpp", r"within seed_of", ORDERS),
    ("host/opencl/device/schedule.cpp", r"seed|reverse|settings|^source;", ORDERS),
    ("host/opencl/device/session.hpp", r"device\(\) const", ASKED),
    ("host/opencl/device/room.cpp", r"return fmt::format|mallopt", FAILS),
    ("host/opencl/device/session.cpp", r"options_\.units", "one processor for each of the lattices that `pelage sweep` runs side by side: tests/sweep and tests/app do"),
    ("host/opencl/device/session.cpp", r"within Session::program", ASKED),
    ("host/opencl/device/subnormal.cpp", r"const std::string how|return how", OTHER_DEVICE),
    # Programs and their cache
    ("host/opencl/device/cache.cpp", r"XDG_CACHE_HOME|HOME", "where caches lie: tests/app sets these variables"),
    ("host/opencl/device/pocl_header.cpp", r"header_may_help", FAILS),
    ("host/opencl/device/pocl_programs.cpp", r"within put_back", FAILS),
    ("host/opencl/device/pocl_programs.cpp", r"within if \(pocl_folder\(\)\.empty\(\)\)", FAILS),
    ("host/opencl/device/program.cpp", r"within keep_source|refuse|told_of_missing_memory|from_source\(|from_brief", FAILS),
    ("host/opencl/device/program.cpp", r"within from_cache|keep_binary", OTHER_DEVICE),
    ("host/opencl/device/program.cpp", r"from_cache\(|= from_source\(|keep_binary\(|return \{program\}", OTHER_DEVICE),
    # Lattices and volumes
    ("host/opencl/lattice/choice.cpp", r"within caches_hold|why_not_streamed|Answer best|foreseen_work|too_small", CHOICE),
    ("host/opencl/lattice/choice.cpp", r"^answer = allowed|^cut = cut_of|free \? best|^choice = choose", CHOICE),
    ("host/opencl/lattice/explain.cpp", r"within ", "what --explain says: tests/app reads it"),
    ("host/opencl/lattice/emit_lattice.cpp", r"^return \"\";", NEVER),
    ("host/opencl/lattice/fused_cut.cpp", r"within turns_of_pass|while \(ends_loops", RASTERISER),
    ("host/opencl/lattice/fused_cut.cpp", r"while \(2 \* units % bands", "of more than two processors: tests/opencl cuts for them"),
    ("host/opencl/lattice/fused_cut.cpp", r"within while \(shape\.together", "of more than two processors: tests/opencl cuts for them"),
    ("host/opencl/lattice/fused_cut.cpp", r"within while \(bytes\(\) > there\)", LITTLE_MEMORY),
    ("host/opencl/lattice/planes.cpp", r"to\.resize\(count\)|enqueueReadBuffer\(now_|take_cells\(grid, to|resize\(grid", OTHER_DEVICE),
    ("host/opencl/lattice/planes.cpp", r"std::copy\(cells, cells", OTHER_DEVICE),
    ("host/opencl/lattice/step.cpp", r"within if \(!device\.processor\(\)\)", OTHER_DEVICE),
    ("host/opencl/lattice/structure.cpp", r"within batch_room", ASKED),
    ("host/opencl/volume/step.cpp", r"within if \(!device\.processor\(\)\)", OTHER_DEVICE),
    # Free cells, neighbours, aggregates
    ("host/opencl/aggregate/*", r"candidate_bytes|place_room_ \*|candidate_room_ \*", "of tests/aggregate, which weighs a candidate"),
    ("host/opencl/aggregate/far_device.cpp", r"return one \? 1", "run, but counted in the line before it"),
    ("host/opencl/aggregate/device.cpp", r"within particles_at_once", RASTERISER),
    ("host/opencl/aggregate/tissue.cpp", r"do_set_rate|do_non_finite", "nothing diffuses there, and all values are whole numbers or sums of few"),
    ("host/opencl/cells/state.cpp", r"within forget_torn", FAILS),
    ("host/opencl/cells/together.cpp", r"within longest_launch", RASTERISER),
    ("host/opencl/cells/together.cpp", r"software_rasteriser", RASTERISER),
    ("host/opencl/cells/together.cpp", r"2000u : 800u", CHOICE),
    ("host/opencl/cells/tissue.cpp", r"divide rules; free cells", REFUSES),
    ("host/opencl/neighbours/bins.cpp", r"tuning\.(width|chunks|per_chunk|bits|tickets) =", OTHER_DEVICE),
    ("host/opencl/neighbours/spatial_sorting.cpp", r"within if \(rounds_", "rounds that C++ alone may ask for: tests/opencl_cells does"),
    # Rules
    ("host/opencl/rules/emit_operand.cpp", r"^default:|^break;|^return \"R\(0\)\"", NEVER),
    ("host/opencl/rules/emit_whole.cpp", r"^return no_range", NEVER),
    ("host/opencl/rules/functions.cpp", r"function_table\(\)\.front", NEVER),
]

UNCLANGED = "of compilers other than clang: PoCL's is clang, and so are those of most devices"
FAST = "--fast gives up equality with the reference: tests/opencl looks at its results"
BENCH = "of the benchmarks, which look at its results themselves"

# A file, the kind of a part and its text, both as the report names them (text: a regular expression), and the reason.
KERNELS = [
    ("kernels/common/prelude.cl", "branch", r"^#ifdef PELAGE_FAST", FAST),
    ("kernels/functions/numbers.cl", "branch", r"^#ifdef PELAGE_FAST", FAST),
    ("kernels/common/prelude.cl", "branch", r"^#else of #ifdef __clang__", UNCLANGED),
    ("kernels/learn/iteration.cl", "branch", r"^#else of #ifdef __clang__", UNCLANGED),
    ("kernels/rules/neural.cl", "branch", r"^#else of #ifdef __clang__", UNCLANGED),
    ("kernels/rules/philox.cl", "branch", r"^#else of #ifdef __clang__", UNCLANGED),
    ("kernels/common/schedule.cl", "file", r".", ORDERS),
    ("kernels/common/schedule.cl", "branch", r".", ORDERS),
    ("kernels/common/yardstick.cl", "file", r".", BENCH),
    ("kernels/common/yardstick.cl", "kernel", r".", BENCH),
    ("kernels/lattice/stream.cl", "branch", r"^#else, of #ifdef PELAGE_PREFETCH",
     "the same without hints to a processor's caches, for devices that are none"),
    ("kernels/lattice/together.cl", "branch", r"^#else, of #ifndef PATIENCE",
     "tests/opencl compiles it for the host with a patience of its own"),
]
