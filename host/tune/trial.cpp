// See trial.hpp.
#include "tune/trial.hpp"

#include "core/error.hpp"
#include "opencl/device/cl_error.hpp"
#include "opencl/device/session.hpp"
#include "opencl/lattice/choice.hpp"
#include "opencl/lattice/tissue.hpp"
#include "verify/tally.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

namespace pelage::tune {

namespace {

constexpr double loose = 1e-3;
constexpr std::size_t usual_depth = 24;  // of candidates that leave it open
constexpr int stretches = 3;
// The defaults go over to their best kernel only after some work.
constexpr double settling_updates = 1.25 * streamed_after;
constexpr double settling_seconds = 1.0;
constexpr std::size_t settled_bytes = 1 << 20;  // lattices that any cache holds have one kernel from the beginning

constexpr std::array<std::pair<Verdict, const char*>, 6> verdicts{{{Verdict::good, "good"},
                                                                   {Verdict::unfit, "unfit"},
                                                                   {Verdict::wrong, "wrong"},
                                                                   {Verdict::refused, "refused"},
                                                                   {Verdict::crashed, "crashed"},
                                                                   {Verdict::hung, "hung"}}};

std::size_t depth_of(const Candidate& candidate) {
    return candidate.cut.depth == 0 ? usual_depth : candidate.cut.depth;
}

// The latest note, without the iteration from which it holds.
std::string how_of(const Tissue& tissue) {
    const std::vector<std::string> notes = tissue.report();
    if (notes.empty()) return {};
    const auto colon = notes.back().find(": ");
    return colon == std::string::npos ? notes.back() : notes.back().substr(colon + 2);
}

// Whether what was carried out is what the candidate stands for.
bool is_what_it_says(const Candidate& candidate, const std::string& how) {
    return how.empty() || candidate.path == Path::automatic || how.starts_with(word(candidate.path));
}

// Runs on and on over the timed iterations.
class Track {
public:
    Track(Subject subject, const Stage& stage, std::uint64_t end)
        : subject_(std::move(subject)), stage_(stage), end_(end) {}

    struct Lap {
        double seconds = 0;
        double updates = 0;
    };

    Lap run(std::uint64_t iterations) {
        using Clock = std::chrono::steady_clock;
        Tissue& tissue = *subject_.tissue;
        iterations = std::min(iterations, end_ - stage_.start.iteration);
        if (tissue.iteration() + iterations > end_) tissue.write(stage_.start);
        const auto before = static_cast<double>(tissue.cells());
        subject_.finish();
        const auto start = Clock::now();
        tissue.advance(iterations);
        subject_.finish();
        const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
        return {seconds, static_cast<double>(iterations) * (before + static_cast<double>(tissue.cells())) / 2};
    }

    // Laps until they have taken that long together; cell-updates a second.
    double stretch(std::uint64_t iterations, double at_least) {
        Lap sum;
        while (sum.seconds < at_least) {
            const Lap lap = run(iterations);
            sum.seconds += std::max(lap.seconds, 1e-9);
            sum.updates += lap.updates;
        }
        return sum.updates / sum.seconds;
    }

    void settle(std::uint64_t iterations) {
        Lap sum;
        while (sum.updates < settling_updates && sum.seconds < settling_seconds) {
            const Lap lap = run(iterations);
            sum.seconds += std::max(lap.seconds, 1e-9);
            sum.updates += lap.updates;
        }
    }

private:
    Subject subject_;
    const Stage& stage_;
    std::uint64_t end_;
};

}  // namespace

std::string word(Verdict verdict) {
    for (const auto& [value, name] : verdicts) {
        if (verdict == value) return name;
    }
    return "unknown";
}

bool struck_out(Verdict verdict) { return verdict != Verdict::good && verdict != Verdict::unfit; }

nlohmann::ordered_json to_json(const Trial& trial) {
    return {{"candidate", to_json(trial.candidate)},
            {"verdict", word(trial.verdict)},
            {"updates_per_second", trial.updates_per_second},
            {"how", trial.how},
            {"message", trial.message},
            {"limit", trial.limit}};
}

Trial trial_from_json(const nlohmann::ordered_json& json) {
    try {
        Trial trial;
        trial.candidate = candidate_from_json(json.at("candidate"));
        const std::string name = json.at("verdict").get<std::string>();
        const auto found = std::ranges::find_if(verdicts, [&](const auto& pair) { return name == pair.second; });
        if (found == verdicts.end()) throw Error("there is no verdict '" + name + "' on a candidate");
        trial.verdict = found->first;
        trial.updates_per_second = json.at("updates_per_second").get<double>();
        trial.how = json.at("how").get<std::string>();
        trial.message = json.at("message").get<std::string>();
        trial.limit = json.value("limit", 0.0);
        return trial;
    } catch (const nlohmann::json::exception& error) {
        throw Error(fmt::format("this is no trial of a candidate: {}", error.what()));
    }
}

Subject begin_on_device(const OpenclOptions& options, const Experiment& experiment, const Snapshot& start) {
    const auto session = std::make_shared<const Session>(select_device(options.device), options);
    Subject subject;
    subject.tissue = make_opencl_lattice(session, std::make_shared<const Experiment>(experiment), start);
    subject.finish = [session] { with_device(session->info().name, [&] { session->queue().finish(); }); };
    return subject;
}

TestStand::TestStand(Problem problem, OpenclOptions options, Begin begin, double seconds)
    : problem_(std::move(problem)), options_(std::move(options)), begin_(std::move(begin)), seconds_(seconds) {}

Trial TestStand::try_out(const Candidate& candidate, const std::function<void()>& running) {
    try {
        return judged(candidate, running);
    } catch (const Error& error) {
        Trial trial;
        trial.candidate = candidate;
        trial.verdict = Verdict::refused;
        trial.message = error.what();
        return trial;
    }
}

Trial TestStand::judged(const Candidate& candidate, const std::function<void()>& running) {
    Trial trial;
    trial.candidate = candidate;
    const Stage& stage = problem_.verified;
    const Subject subject = begin_(applied(candidate, options_), stage.experiment, stage.start);
    trial.message = difference(candidate, *subject.tissue);
    trial.how = how_of(*subject.tissue);
    if (!trial.message.empty()) {
        trial.verdict = Verdict::wrong;
    } else if (!is_what_it_says(candidate, trial.how)) {
        trial.verdict = Verdict::unfit;
        trial.message = "carried out otherwise: " + trial.how;
    } else {
        trial.updates_per_second = speed(candidate, running);
    }
    return trial;
}

// The first iteration goes alone, for rules may read the neighbours it counts; then come two full passes and a part of
// one.
std::string TestStand::difference(const Candidate& candidate, Tissue& tissue) {
    const std::size_t depth = depth_of(candidate);
    const Snapshot& expected = expected_after(2 * depth + 3);
    tissue.advance(1 + 2 * depth);
    tissue.advance(2);
    verify::Tally tally;
    verify::add(tally, expected, tissue.read(), options_.precision, fmt::format("iteration {}", tissue.iteration()));
    if (tally.equal()) return {};
    const bool near = std::min(tally.max_relative, tally.max_scaled) <= loose && tally.same_structure;
    return options_.fast && near ? "" : tally.first;
}

const Snapshot& TestStand::expected_after(std::uint64_t iterations) {
    const auto known = expected_.find(iterations);
    if (known != expected_.end()) return known->second;
    const Stage& stage = problem_.verified;
    const Subject subject = begin_(applied(single_step(), options_), stage.experiment, stage.start);
    subject.tissue->advance(iterations);
    return expected_.emplace(iterations, subject.tissue->read()).first->second;
}

bool TestStand::settles(const Candidate& candidate) const {
    const Snapshot& start = problem_.timed.start;
    const std::size_t scalar = options_.precision == Precision::double_ ? 8 : 4;
    return candidate.path == Path::automatic && 2 * scalar * start.conc.size() * start.cells() > settled_bytes;
}

double TestStand::speed(const Candidate& candidate, const std::function<void()>& running) {
    const Stage& stage = problem_.timed;
    Track track(begin_(applied(candidate, options_), stage.experiment, stage.start), stage, problem_.end);
    const std::size_t depth = depth_of(candidate);
    track.run(1 + depth);
    if (running) running();
    if (settles(candidate)) track.settle(depth);
    const double pass = std::max(track.run(depth).seconds, 1e-9);
    const auto passes = static_cast<std::uint64_t>(std::clamp(std::ceil(seconds_ / pass), 1.0, 1e5));
    double best = 0;
    for (int i = 0; i < stretches; ++i) best = std::max(best, track.stretch(passes * depth, 0.9 * seconds_));
    return best;
}

}  // namespace pelage::tune
