// A candidate put to the test: first its bits, then its speed.
#pragma once

#include "core/tissue.hpp"
#include "tune/candidate.hpp"
#include "tune/problem.hpp"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace pelage::tune {

enum class Verdict {
    good,
    unfit,    // the device or the rules do not allow it: something else was carried out instead
    wrong,    // other bits than single steps give
    refused,  // an Error: no such work-group, too little local memory, ...
    crashed,  // the process that tried it ended
    hung      // it did not come to an end
};
std::string word(Verdict);
bool struck_out(Verdict);  // never to be tried again, nor used: all but good and unfit

struct Trial {
    Candidate candidate;
    Verdict verdict = Verdict::good;
    double updates_per_second = 0;  // of cells; 0 unless good
    std::string how;                // in the tissue's own words
    std::string message;            // why it was struck out
    double limit = 0;               // seconds that it had, where it hung
};

nlohmann::ordered_json to_json(const Trial&);
Trial trial_from_json(const nlohmann::ordered_json&);  // throws Error

// A tissue under way, and how to wait for all that it was told to do.
struct Subject {
    std::unique_ptr<Tissue> tissue;
    std::function<void()> finish;
};
using Begin = std::function<Subject(const OpenclOptions&, const Experiment&, const Snapshot& start)>;

// Begin on the device that the options name.
Subject begin_on_device(const OpenclOptions&, const Experiment&, const Snapshot& start);

class TestStand {
public:
    // `options`: device, precision and whatever else all candidates share. `seconds`: of one stretch that is timed.
    TestStand(Problem, OpenclOptions options, Begin = begin_on_device, double seconds = 0.06);

    // Runs the candidate and single steps from one state through full and partial passes and compares every value,
    // bit for bit; with options.fast within 1e-3. Only then are three stretches timed, of which the shortest counts.
    // Never throws Error for what a candidate does. `running` is told when all that the candidate needs is compiled and
    // has run once.
    Trial try_out(const Candidate&, const std::function<void()>& running = {});

private:
    Trial judged(const Candidate&, const std::function<void()>& running);
    std::string difference(const Candidate&, Tissue&);
    const Snapshot& expected_after(std::uint64_t iterations);
    bool settles(const Candidate&) const;
    double speed(const Candidate&, const std::function<void()>& running);

    Problem problem_;
    OpenclOptions options_;
    Begin begin_;
    double seconds_;
    std::map<std::uint64_t, Snapshot> expected_;  // of single steps, by iterations
};

}  // namespace pelage::tune
