// See measure.hpp.
#include "bench/measure.hpp"

#include "bench/contest.hpp"
#include "core/error.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace pelage::bench {

namespace {

using Clock = std::chrono::steady_clock;

// How long threads of OpenMP spin after their work: the next backend shall not share cores with them. Made to sleep at
// once (OMP_WAIT_POLICY=passive) they would be slow themselves on small grids.
constexpr std::chrono::milliseconds pause{25};

double seconds_of(Task& task, std::uint64_t iterations) {
    const auto start = Clock::now();
    task.work(iterations);
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// Bytes of main memory that this process holds.
double resident_bytes() {
    malloc_trim(0);  // what was freed shall not count
    double pages = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> pages >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

struct Rest {
    bool needed;
    ~Rest() {
        if (needed) std::this_thread::sleep_for(pause);
    }
};

struct Runner {
    Contender contender;
    std::unique_ptr<Task> task;
    std::uint64_t iterations = 1;  // of one run
    double largest_difference = 0;
    double bytes = 0;  // that the task holds; 0: not known
    std::vector<double> seconds;

    double median() const {
        std::vector<double> sorted = seconds;
        std::ranges::sort(sorted);
        const std::size_t half = sorted.size() / 2;
        return sorted.size() % 2 != 0 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
    }
    double best() const { return std::ranges::min(seconds); }
    double spread() const { return (std::ranges::max(seconds) - best()) / median(); }
};

double largest_difference(const Outcome& expected, const Outcome& found) {
    double most = 0;
    for (std::size_t i = 0; i < std::min(expected.size(), found.size()); ++i) {
        if (!expected[i].numbers) continue;
        for (std::size_t k = 0; k < std::min(expected[i].words.size(), found[i].words.size()); ++k) {
            const double difference = std::fabs(static_cast<double>(std::bit_cast<float>(expected[i].words[k])) -
                                                static_cast<double>(std::bit_cast<float>(found[i].words[k])));
            most = std::isnan(difference) ? difference : std::max(most, difference);
        }
    }
    return most;
}

class Measurement {
public:
    Measurement(const Options& options, const Case& one, std::size_t size, Contest contest, Report& report,
                const Say& say)
        : options_(options), case_(one), size_(size), contest_(std::move(contest)), report_(report), say_(say) {}

    void carry_out() {
        report_.notes.insert(report_.notes.end(), contest_.absent.begin(), contest_.absent.end());
        for (const Contender& contender : contest_.contenders) enter(contender);
        if (runners_.empty()) return;
        for (const Contender& probe : contest_.probes) enter_probe(probe);
        time();
        for (const Runner& runner : runners_) {
            if (still_right(runner)) report_.results.push_back(result_of(runner));
        }
    }

private:
    void say(const std::string& backend, const char* what) const {
        say_(fmt::format("{} {} {}: {} {}", case_.suite, case_.name, size_, what, backend));
    }

    void note(const Contender& contender, const std::string& text, bool wrong) {
        report_.notes.push_back({case_.suite, case_.name, size_, contender.backend, contender.device, text, wrong});
    }

    // Makes the task, lets it come to its usual speed, and holds its result against the first one's.
    void enter(const Contender& contender) {
        say(contender.backend, "comparing");
        const Rest rest{contender.threads};
        const double bytes_before = resident_bytes();
        try {
            Runner runner{contender, contender.make(), 1, 0, 0, {}};
            if (contest_.whole != 0) {
                runner.iterations = contest_.whole;
            } else {
                runner.iterations = stretch_for(*runner.task, least_work(contender));
                runner.task->restart();
            }
            runner.task->work(contest_.stretch);
            Outcome found = runner.task->outcome();
            if (expected_.empty()) {
                const std::string wrong = disagreement(contest_.initial, found, found);
                if (!wrong.empty()) return note(contender, wrong, true);
                expected_ = found;
            } else if (contender.exact) {
                const std::string wrong = disagreement(contest_.initial, expected_, found);
                if (!wrong.empty()) return note(contender, wrong, true);
            } else if (!contender.twin) {
                runner.largest_difference = largest_difference(expected_, found);
            }
            found = {};
            runner.bytes = bytes_held(runner, bytes_before);
            runners_.push_back(std::move(runner));
        } catch (const Error& error) {
            note(contender, error.what(), false);
        }
    }

    // A device that is the processor itself keeps its buffers in this process; beside large ones its compiler's own
    // memory matters little.
    double bytes_held(const Runner& runner, double bytes_before) const {
        if (const std::size_t known = runner.task->bytes_held(); known > 0) return static_cast<double>(known);
        constexpr double large = 128e6;
        const double held = resident_bytes() - bytes_before;
        return runner.contender.in_memory && held >= large ? held : 0;
    }

    void enter_probe(const Contender& probe) {
        const bool needed = std::ranges::any_of(
            runners_, [&](const Runner& runner) { return runner.contender.device == probe.device; });
        if (!needed) return;
        const Rest rest{probe.threads};
        try {
            Runner runner{probe, probe.make(), 1, 0, 0, {}};
            runner.iterations = stretch_for(*runner.task, 0);
            probes_.push_back(std::move(runner));
        } catch (const Error& error) {
            note(probe, error.what(), false);
        }
    }

    // Cell updates after which a lattice on OpenCL has compiled all it wants to.
    double least_work(const Contender& contender) const {
        const bool chooses = contender.backend == "opencl" || contender.backend == "opencl-fast" || contender.twin;
        return !chooses || case_.suite != "lattice" ? 0 : options_.quick ? 1e6 : 6e9;
    }

    // Iterations that take about as long as a run shall.
    std::uint64_t stretch_for(Task& task, double least_work) const {
        const double target = options_.seconds_a_run();
        double done = 0;
        for (std::uint64_t count = 1;;) {
            seconds_of(task, count);  // compiles, as a rule
            const double seconds = std::max(1e-7, seconds_of(task, count));
            done += 2 * static_cast<double>(count) * contest_.updates;
            if (seconds >= target / 4 && (done >= least_work || seconds > 4 * target)) {
                const double wanted = std::max(1.0, target / seconds * static_cast<double>(count));
                count = static_cast<std::uint64_t>(wanted);
                // What was timed may have been a compilation, and another program may have come in meanwhile.
                const double again = std::max(1e-7, seconds_of(task, count));
                if (again < target / 2) continue;
                const auto iterations = static_cast<std::uint64_t>(std::max(1.0, wanted * target / again));
                return iterations < 32 ? iterations : iterations / 16 * 16;  // whole passes where steps are fused
            }
            count *= seconds < target / 32 ? 8 : 2;
        }
    }

    void time() {
        say("", "timing");
        for (std::size_t run = 0; run < options_.runs; ++run) {
            for (std::vector<Runner>* list : {&probes_, &runners_}) {
                for (Runner& runner : *list) {
                    const Rest rest{runner.contender.threads};
                    if (contest_.whole != 0 && list == &runners_) runner.task->restart();
                    runner.seconds.push_back(seconds_of(*runner.task, runner.iterations));
                }
            }
        }
    }

    // What was timed may be another program than the one that was compared: backends choose as they go.
    bool still_right(const Runner& runner) {
        constexpr std::size_t quick_to_compare = 4'000'000;
        if (!runner.contender.exact || contest_.cells > quick_to_compare) return true;
        runner.task->restart();
        runner.task->work(contest_.stretch);
        const std::string wrong = disagreement(contest_.initial, expected_, runner.task->outcome());
        if (!wrong.empty()) note(runner.contender, "after it was timed: " + wrong, true);
        return wrong.empty();
    }

    double copy_bandwidth(const std::string& device) const {
        for (const Runner& probe : probes_) {
            if (probe.contender.device != device) continue;
            return case_.bytes * static_cast<double>(contest_.cells) * static_cast<double>(probe.iterations) /
                   probe.median();
        }
        return 0;
    }

    double peak(const std::string& device) const {
        for (const Yardstick& yardstick : report_.yardsticks) {
            if (yardstick.device == device) return yardstick.peak;
        }
        return 0;
    }

    Result result_of(const Runner& runner) const {
        Result result;
        result.suite = case_.suite;
        result.name = case_.name;
        result.size = size_;
        result.backend = runner.contender.backend;
        result.device = runner.contender.device;
        result.cells = contest_.cells;
        result.iterations = runner.iterations;
        result.seconds = runner.median();
        result.best = runner.best();
        result.spread = runner.spread();
        const double updates =
            contest_.whole != 0 ? contest_.updates : contest_.updates * static_cast<double>(runner.iterations);
        result.updates_per_second = updates / result.seconds;
        result.bytes_per_second = result.updates_per_second * case_.bytes;
        result.copy_bandwidth = copy_bandwidth(result.device);
        if (result.copy_bandwidth > 0) result.bandwidth_share = result.bytes_per_second / result.copy_bandwidth;
        result.flops_per_update = case_.flops;
        result.bytes_per_update = case_.bytes;
        const double most = peak(result.device);
        if (most > 0) result.arithmetic_share = result.updates_per_second * case_.flops / most;
        result.bytes_per_cell = runner.bytes / static_cast<double>(contest_.cells);
        result.largest_difference = runner.largest_difference;
        return result;
    }

    const Options& options_;
    const Case& case_;
    std::size_t size_;
    Contest contest_;
    Report& report_;
    const Say& say_;
    Outcome expected_;
    std::vector<Runner> runners_, probes_;
};

}  // namespace

Report measure(const Options& options, const Say& say, const Keep& keep) {
    check(options);
    const std::vector<Case> cases = chosen_cases(options);
    if (cases.empty()) throw Error(fmt::format("--cases names none of suite '{}'", options.suite));
    const std::vector<DeviceSessions> devices = open_devices(options.device);
    Report report;
    if (getloadavg(&report.load, 1) != 1) report.load = 0;
    say("measuring the host and each device");
    report.yardsticks.push_back(measure_host(options.quick));
    for (const DeviceSessions& device : devices) {
        report.yardsticks.push_back(measure_device(device.plain, options.quick));
    }
    for (const Case& one : cases) {
        const auto& own = options.quick ? one.quick_sizes : one.sizes;
        for (const std::size_t size : options.sizes.empty() ? own : options.sizes) {
            try {
                Measurement(options, one, size, make_contest(options, one, size, devices), report, say).carry_out();
            } catch (const Error& error) {
                report.notes.push_back({one.suite, one.name, size, "all", "", error.what(), false});
            }
            keep(report);
        }
    }
    return report;
}

}  // namespace pelage::bench
