// What a check is, where it runs and what comes of it.
#pragma once

#include "opencl/backend.hpp"
#include "opencl/device/session.hpp"
#include "verify/tally.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace pelage::verify {

// Which kernel variant a state comes from. None of these may change a bit, but for the precision.
struct Setting {
    Precision precision = Precision::single_;
    Path path = Path::step;
    std::size_t work_group = 0;  // 0: as a run would choose it
    std::size_t width = 0;
    std::size_t variants = 16;
    std::size_t columns = 0;                         // of a band or tile, as rows, depth and group: see LatticeCut
    NeighbourSearch search = NeighbourSearch::bins;  // of free cells
    std::size_t rows = 0;
    std::size_t depth = 0;
    std::size_t group = 0;
    bool guarded = true;  // false: as a run has it, where nothing hides what is left over in a buffer

    auto operator<=>(const Setting&) const = default;
    std::string text() const;  // "double", "double, streamed", "work-group 3"; empty for the default
};

inline constexpr std::size_t enough_cells = 200;  // fewer are soon all the same, which proves nothing
inline constexpr std::size_t small_cells = 260;   // no more where a device is a simulator

// The device under test: every buffer is guarded, every output poisoned, but where a setting says otherwise. Not for
// several threads.
class Place {
public:
    Place(DeviceInfo, std::uint64_t seed, bool full, bool small);

    const DeviceInfo& device() const { return device_; }
    std::uint64_t seed() const { return seed_; }
    // With the usual seed as it is written; with another one drawn anew, at the start and on its way.
    Experiment seeded(Experiment) const;
    bool full() const { return full_; }    // the long form of a check
    bool small() const { return small_; }  // the smallest sizes alone, for simulators

    OpenclBackend& backend(const Setting&);
    const Session& session(Precision = Precision::single_);

    // Turns that a loop of one work-item may take before the device ends it silently; 0: no end was met in 70,000.
    std::uint64_t loop_limit();

    // Why results may differ from the reference's where numbers are subnormal; empty: they may not.
    const std::string& subnormal_difference();

private:
    DeviceInfo device_;
    std::uint64_t seed_;
    bool full_;
    bool small_;
    std::map<Setting, std::unique_ptr<OpenclBackend>> backends_;
    std::map<Precision, std::unique_ptr<Session>> sessions_;
    std::optional<std::uint64_t> loop_limit_;
    std::optional<std::string> subnormal_difference_;
};

enum class Verdict { passed, failed, mistrusted, skipped };
const char* word(Verdict);  // "passed", ...

// Values of a lattice's chemical on both sides, to be drawn.
struct Evidence {
    std::string what;  // "conc[0] after 1 iteration"
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::vector<double> expected;
    std::vector<double> found;
};

struct Outcome {
    Verdict verdict = Verdict::passed;
    Tally tally;
    std::string message;  // why it is not passed, or with what bound it is; may be empty
    std::optional<Evidence> evidence;
    bool broken_off = false;  // by an error: what else this process asks of the device may fail, too
};

// Failed where something differs.
void conclude(Outcome&);

// The experiment in each of these settings, in single precision, compared with the reference after each stretch of
// iterations.
Outcome beside_the_reference(Place&, const Experiment&, std::span<const Setting>,
                             std::span<const std::uint64_t> stretches);

// Numbers of elements around those at which kernels cut their work.
std::vector<std::size_t> telling_counts(const Place&);

struct Check {
    std::string name;    // "diffusion/nine-point/wrap": unique
    std::string kernel;  // the row of the table of verdicts it counts for
    bool quick = false;  // belongs to the quick form too
    std::function<Outcome(Place&)> run;
};

// The checks of the full form or of the quick one, in the order in which they run. `seed` makes the random ones.
std::vector<Check> all_checks(std::uint64_t seed, bool full = true);

// Parts of them.
std::vector<Check> lattice_checks();
std::vector<Check> batch_checks();
std::vector<Check> alike_checks();
std::vector<Check> law_checks(std::uint64_t seed);
std::vector<Check> cell_checks();
std::vector<Check> aggregate_checks();
std::vector<Check> term_checks();
std::vector<Check> learn_checks();
std::vector<Check> mesh_checks();
std::vector<Check> primitive_checks(std::uint64_t seed);
std::vector<Check> function_checks();
std::vector<Check> neighbour_checks(std::uint64_t seed);
std::vector<Check> order_checks();
std::vector<Check> gather_checks(std::uint64_t seed);
std::vector<Check> random_checks(std::uint64_t seed);
std::vector<Check> checkpoint_checks();
std::vector<Check> array_checks(bool full);
std::vector<Check> finite_checks();
std::vector<Check> course_checks();
std::vector<Check> reading_checks();

// Runs one check: whatever is thrown becomes a failure.
Outcome carry_out(const Check&, Place&);

}  // namespace pelage::verify
