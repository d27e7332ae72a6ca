// See trial_worker.hpp.
#include "app/trial_worker.hpp"

#include "app/say.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
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

}  // namespace

std::optional<tune::Trial> TrialWorker::try_out(const tune::Candidate& candidate, double seconds) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                        std::chrono::duration<double>(std::clamp(seconds, 0.0, 86'400.0)));
    if (!worker_) worker_ = std::make_unique<Worker>(arguments_);
    worker_->ask(dumped(to_json(candidate)));
    while (Clock::now() < end) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        pollfd waiting{worker_->output(), POLLIN, 0};
        if (poll(&waiting, 1, static_cast<int>(std::max<std::int64_t>(1, left))) <= 0) continue;
        if (const auto answer = worker_->take()) return trial_in(*answer, candidate);
        if (!worker_->ended()) continue;
        tune::Trial trial;
        trial.candidate = candidate;
        trial.verdict = tune::Verdict::crashed;
        trial.message = "the process that tried it ended with " + worker_->end();
        worker_.reset();
        return trial;
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
    if (job.options.fast) words.emplace_back("--fast");
    if (!job.options.use_cache) words.emplace_back("--no-cache");
    words.emplace_back("--");
    words.push_back(job.file.string());
    return words;
}

int answer_candidates(const TuningJob& job) {
    tune::TestStand stand(tune::make_problem(job.experiment, job.first, job.last, tune::telling_cells(job.device.type)),
                          job.options);
    for (std::string line; std::getline(std::cin, line);) {
        const tune::Trial trial = stand.try_out(tune::candidate_from_json(ordered_json::parse(line)));
        say("\n{}{}\n", answer_mark, dumped(to_json(trial)));
        std::fflush(stdout);
    }
    return 0;
}

}  // namespace pelage::app
