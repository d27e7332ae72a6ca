// See trial_worker.hpp.
#include "app/trial_worker.hpp"

#include "app/last_will.hpp"
#include "app/say.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <iostream>

#include <poll.h>

namespace pelage::app {

namespace {

using nlohmann::ordered_json;

std::string dumped(const ordered_json& json) {
    return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);  // a driver may not speak UTF-8
}

// An answer that cannot be read comes from a process whose memory cannot be trusted.
tune::Trial trial_in(const std::string& answer, const tune::Candidate& candidate) {
    try {
        tune::Trial trial = tune::trial_from_json(ordered_json::parse(answer));
        if (trial.candidate == candidate) return trial;
    } catch (const Error&) {
    } catch (const ordered_json::exception&) {
    }
    tune::Trial trial;
    trial.candidate = candidate;
    trial.verdict = tune::Verdict::crashed;
    trial.message = "the process that tried it gave an answer that cannot be read";
    return trial;
}

// The time that a candidate has left.
class Patience {
public:
    Patience(const Worker& worker, double running, double whole)
        : worker_(worker), running_(running), whole_(whole), computed_(worker.processor_seconds()) {}

    void is_running() {
        started_ = true;
        compiled_ = since(start_);
    }

    double left() const {
        constexpr double longest_compilation = 60;
        constexpr double share = 4;  // of processors, with as many others at work
        constexpr double beginning = 2;
        const double computed = beginning + share * (worker_.processor_seconds() - computed_);
        const double end = running_ + (started_ ? compiled_ : std::min(computed, longest_compilation));
        return std::min(end, whole_) - since(start_);
    }

private:
    using Clock = std::chrono::steady_clock;

    static double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

    const Worker& worker_;
    double running_;
    double whole_;
    double computed_;
    Clock::time_point start_ = Clock::now();
    bool started_ = false;
    double compiled_ = 0;  // seconds until then
};

tune::Trial crash_of(const tune::Candidate& candidate, const std::string& how) {
    tune::Trial trial;
    trial.candidate = candidate;
    trial.verdict = tune::Verdict::crashed;
    trial.message = "the process that tried it ended with " + how;
    return trial;
}

// What a child says within that time; answers may come together.
std::optional<std::string> heard(Worker& worker, double seconds) {
    if (auto answer = worker.next()) return answer;
    pollfd waiting{worker.output(), POLLIN, 0};
    if (poll(&waiting, 1, 1 + static_cast<int>(1000 * seconds)) <= 0) return {};
    return worker.take();
}

constexpr const char* is_running = "running";  // an answer before the answer

}  // namespace

std::optional<tune::Trial> TrialWorker::try_out(const tune::Candidate& candidate, double running, double whole) {
    constexpr double often = 0.1;  // what was compiled meanwhile gives more time
    if (!worker_) worker_ = std::make_unique<Worker>(arguments_);
    Patience patience(*worker_, running, whole);
    worker_->ask(dumped(to_json(candidate)));
    for (double left = patience.left(); left > 0; left = patience.left()) {
        const auto answer = heard(*worker_, std::min(left, often));
        if (answer == is_running) {
            patience.is_running();
            worker_->is_busy();
        } else if (answer) {
            return trial_in(*answer, candidate);
        } else if (worker_->ended()) {
            const tune::Trial trial = crash_of(candidate, worker_->end());
            worker_.reset();
            return trial;
        }
    }
    worker_.reset();
    return {};
}

std::vector<std::string> worker_arguments(const TuningJob& job) {
    std::vector<std::string> words{"tune",        "--worker",
                                   "--device",    job.options.device.value_or("0"),
                                   "--precision", job.options.precision == Precision::double_ ? "double" : "float",
                                   "--seed",      std::to_string(job.experiment.run_seed()),
                                   "--from",      std::to_string(job.first),
                                   "--until",     std::to_string(job.last)};
    for (const Parameter& one : job.experiment.parameters) {
        words.insert(words.end(), {"--set", fmt::format("{}={}", one.name, one.value)});
    }
    if (job.options.fast) words.emplace_back("--fast");
    if (!job.options.use_cache) words.emplace_back("--no-cache");
    words.emplace_back("--");
    words.push_back(job.file.string());
    return words;
}

int answer_candidates(const TuningJob& job) {
    end_with_parent();
    const auto answer = [](const std::string& line) {
        say("\n{}{}\n", answer_mark, line);
        send();
    };
    tune::TestStand stand(tune::make_problem(job.experiment, job.first, job.last, tune::telling_cells(job.device.type)),
                          job.options);
    for (std::string line; std::getline(std::cin, line);) {
        const tune::Trial trial =
            stand.try_out(tune::candidate_from_json(ordered_json::parse(line)), [&] { answer(is_running); });
        answer(dumped(to_json(trial)));
    }
    return 0;
}

}  // namespace pelage::app
