// See verification.hpp.
#include "app/verification.hpp"

#include "app/interrupt.hpp"
#include "app/last_will.hpp"
#include "app/progress.hpp"
#include "app/run_options.hpp"
#include "app/say.hpp"
#include "app/worker.hpp"
#include "core/allowance.hpp"
#include "core/error.hpp"
#include "opencl/device/kernel_sources.hpp"
#include "opencl/device/pocl.hpp"
#include "opencl/device/pocl_programs.hpp"
#include "opencl/device/schedule.hpp"
#include "opencl/device/session.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <deque>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include <poll.h>
#include <unistd.h>

namespace pelage::app {

namespace {

using verify::Check;
using verify::Result;
using Clock = std::chrono::steady_clock;

constexpr std::size_t most_jobs = 8;  // unless more are asked for

std::vector<std::string> worker_arguments(const DeviceInfo& device, const VerifyOptions& options) {
    std::vector<std::string> words{"verify",     "--worker",
                                   "--device",   std::to_string(device.index),
                                   "--seed",     std::to_string(options.seed),
                                   "--evidence", options.evidence.string()};
    words.emplace_back(options.full ? "--full" : "--quick");
    if (options.small) words.emplace_back("--small");
    return words;
}

class Dealer {
public:
    Dealer(const DeviceInfo& device, const std::vector<Check>& checks, const VerifyOptions& options)
        : checks_(checks),
          options_(options),
          arguments_(worker_arguments(device, options)),
          results_(checks.size()),
          dealt_(checks.size()) {}

    std::vector<Result> run() {
        seats_.resize(std::clamp<std::size_t>(jobs(), 1, checks_.size()));
        if (seats_.size() > 1) share_processors();
        for (Seat& seat : seats_) next(seat);
        while (done_ < checks_.size() && !Interrupt::came()) wait();
        show("");
        return those_known();
    }

private:
    struct Seat {
        std::unique_ptr<Worker> worker;
        std::optional<std::size_t> check;  // what it is at
        std::set<std::string> kernels;     // those that its worker has compiled
    };

    // All of them, but where a signal came before.
    std::vector<Result> those_known() {
        std::vector<Result> known;
        for (std::optional<Result>& result : results_) {
            if (result) known.push_back(std::move(*result));
        }
        return known;
    }

    std::size_t jobs() const { return options_.jobs != 0 ? options_.jobs : std::min(most_jobs, usable_processors()); }

    void next(Seat& seat) {
        seat.check.reset();
        if (asked_ == checks_.size()) {
            seat.worker.reset();
            return;
        }
        if (!seat.worker) {
            seat.worker = std::make_unique<Worker>(arguments_);
            seat.kernels.clear();
        }
        seat.check = choose(seat);
        dealt_[*seat.check] = true;
        ++asked_;
        begun_.insert(checks_[*seat.check].kernel);
        seat.kernels.insert(checks_[*seat.check].kernel);
        show(checks_[*seat.check].name);
        seat.worker->ask(checks_[*seat.check].name);
    }

    // Checks of one kernel share programs, which each worker compiles for itself: it goes on with those that it has
    // begun, else with those that nobody has, else with those of which most are left, the last first: checks that share
    // most lie next to each other.
    std::size_t choose(const Seat& seat) const {
        std::map<std::string, std::size_t> left;
        for (std::size_t i = 0; i < checks_.size(); ++i) left[checks_[i].kernel] += dealt_[i] ? 0 : 1;
        const auto rank = [&](std::size_t i) {
            const std::string& kernel = checks_[i].kernel;
            const std::size_t claim = seat.kernels.contains(kernel) ? 2 : begun_.contains(kernel) ? 0 : 1;
            return std::tuple(claim, claim == 0 ? left[kernel] : 0, claim == 0 ? i : 0);
        };
        std::optional<std::size_t> best;
        for (std::size_t i = 0; i < checks_.size(); ++i) {
            if (!dealt_[i] && (!best || rank(*best) < rank(i))) best = i;
        }
        return *best;
    }

    void wait() {
        std::vector<pollfd> waiting;
        std::vector<Seat*> busy;
        for (Seat& seat : seats_) {
            if (!seat.check) continue;
            waiting.push_back({seat.worker->output(), POLLIN, 0});
            busy.push_back(&seat);
        }
        poll(waiting.data(), waiting.size(), 500);
        for (std::size_t i = 0; i < busy.size(); ++i) {
            if (waiting[i].revents != 0) {
                hear(*busy[i]);
            } else if (Clock::now() - busy[i]->worker->asked() > std::chrono::seconds(options_.limit)) {
                give_up(*busy[i], fmt::format("did not end within {} {}", options_.limit,
                                              noun(static_cast<std::uint64_t>(options_.limit), "second")));
            }
        }
    }

    void hear(Seat& seat) {
        const std::optional<std::string> answer = seat.worker->take();
        if (answer) {
            Result result = verify::result_from_json(nlohmann::ordered_json::parse(*answer));
            const bool broken_off = result.broken_off;
            put(*seat.check, std::move(result));
            if (broken_off) seat.worker.reset();  // a driver may be in disarray: the next check begins afresh
            next(seat);
        } else if (seat.worker->ended() && !Interrupt::came()) {  // Ctrl-C ends workers, too
            give_up(seat, "");
        }
    }

    void give_up(Seat& seat, const std::string& reason) {
        const auto taken = Clock::now() - seat.worker->asked();
        const std::string end = seat.worker->end();
        Result result;
        result.name = checks_[*seat.check].name;
        result.kernel = checks_[*seat.check].kernel;
        result.verdict = verify::Verdict::failed;
        result.message = reason.empty() ? "the process that ran it ended with " + end : reason;
        result.seconds = std::chrono::duration<double>(taken).count();
        put(*seat.check, result);
        seat.worker.reset();
        next(seat);
    }

    void put(std::size_t check, Result result) {
        results_[check] = std::move(result);
        ++done_;
    }

    void show(const std::string& name) const {
        if (options_.quiet || isatty(STDERR_FILENO) == 0) return;
        const std::string text = name.empty() ? "" : fmt::format("[{}/{}] {}", asked_, checks_.size(), name);
        say(stderr, "\r\x1b[K{}", text);
        std::fflush(stderr);
    }

    const std::vector<Check>& checks_;
    const VerifyOptions& options_;
    std::vector<std::string> arguments_;
    std::vector<std::optional<Result>> results_;
    std::vector<bool> dealt_;
    std::set<std::string> begun_;  // the kernels that some worker has compiled
    std::vector<Seat> seats_;
    std::size_t asked_ = 0;
    std::size_t done_ = 0;
};

}  // namespace

std::vector<Check> selected(const VerifyOptions& options) {
    std::vector<Check> checks;
    for (Check& check : verify::all_checks(options.seed, options.full)) {
        if (check.name.find(options.filter) != std::string::npos) checks.push_back(std::move(check));
    }
    if (checks.empty()) {
        throw Error(fmt::format("no check of the {} form has '{}' in its name; `pelage verify --list` names them",
                                options.full ? "full" : "quick", options.filter));
    }
    return checks;
}

verify::DeviceReport verify_device(const DeviceInfo& device, const std::vector<Check>& checks,
                                   const VerifyOptions& options) {
    verify::DeviceReport report;
    report.device = device;
    report.build_options = Session(device, {}).build_options();
    report.results = Dealer(device, checks, options).run();
    return report;
}

int answer_checks(const VerifyOptions& options) {
    end_with_parent();
    const std::vector<Check> checks = verify::all_checks(options.seed, options.full);
    verify::Place place(select_device(options.device), options.seed, options.full, options.small);
    for (std::string name; std::getline(std::cin, name);) {
        const auto check = std::ranges::find(checks, name, &Check::name);
        if (check == checks.end()) throw Error("there is no check '" + name + "'");
        const Result result = verify::judge(*check, place, options.evidence);
        keep_compiled();
        const auto replace = nlohmann::ordered_json::error_handler_t::replace;  // a driver may not speak UTF-8
        say("\n{}{}\n", answer_mark, to_json(result).dump(-1, ' ', false, replace));
        send();
    }
    return 0;
}

std::string reproduce_command(const VerifyOptions& options, const DeviceInfo& device, const std::string& check) {
    std::vector<std::string> words;
    if (const std::string folder = kernels_folder(); !folder.empty())
        words.push_back("PELAGE_KERNELS=" + shell_quoted(folder));
    if (!schedule().empty()) words.push_back("PELAGE_SCHEDULE=" + shell_quoted(schedule()));
    words.insert(words.end(), {options.command, "verify", "--device", std::to_string(device.index),
                               options.full ? "--full" : "--quick"});
    if (options.small) words.emplace_back("--small");
    for (const std::string& word :
         {std::string("--seed"), std::to_string(options.seed), std::string("--filter"), check}) {
        words.push_back(shell_quoted(word));
    }
    return fmt::format("{}", fmt::join(words, " "));
}

}  // namespace pelage::app
