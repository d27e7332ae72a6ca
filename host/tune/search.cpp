// See search.hpp.
#include "tune/search.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage::tune {

namespace {

constexpr int rounds = 2;

bool deserves_more(const Trial& trial, const Budget& budget) {
    return trial.verdict == Verdict::hung && trial.limit < budget.candidate;
}

class Search {
public:
    Search(Record& record, const Budget& budget, const Hands& hands)
        : record_(record), budget_(budget), hands_(hands), began_(hands.clock()) {}

    void all(const std::vector<Candidate>& candidates) {
        for (std::size_t i = 0; i < candidates.size() && elapsed() < budget_.start; ++i) {
            const Trial* known = record_.find(candidates[i]);
            const bool again = known != nullptr && record_.exhaustive && deserves_more(*known, budget_);
            if (known == nullptr || again) one(candidates[i], i + 1, candidates.size());
        }
    }

    // Where something seems to be faster than the defaults.
    void again(std::size_t finalists) {
        for (int round = 0; round < rounds && record_.best() != Candidate{}; ++round) {
            std::vector<Candidate> list = fastest(finalists);
            const Trial* defaults = record_.find({});
            if (defaults != nullptr && defaults->verdict == Verdict::good) list.insert(list.begin(), Candidate{});
            for (std::size_t i = 0; i < list.size() && elapsed() < budget_.again; ++i) one(list[i], i + 1, list.size());
        }
    }

    void close() {
        record_.complete = record_.find({}) != nullptr;
        hands_.keep(record_);
    }

private:
    double elapsed() const { return hands_.clock() - began_; }

    // The fastest ones that are good, the defaults not among them.
    std::vector<Candidate> fastest(std::size_t most) const {
        std::vector<Trial> good = record_.trials;
        std::erase_if(
            good, [](const Trial& trial) { return trial.verdict != Verdict::good || trial.candidate == Candidate{}; });
        std::ranges::sort(good, std::ranges::greater{}, &Trial::updates_per_second);
        std::vector<Candidate> list;
        for (std::size_t i = 0; i < std::min(most, good.size()); ++i) list.push_back(good[i].candidate);
        return list;
    }

    void one(const Candidate& candidate, std::size_t place, std::size_t all) {
        hands_.announce(place, all, candidate);
        const double left = budget_.whole - elapsed();
        std::optional<Trial> trial = hands_.try_out(candidate, budget_.candidate, left);
        if (!trial && elapsed() >= budget_.whole) return;
        if (!trial) {
            trial.emplace();
            trial->candidate = candidate;
            trial->verdict = Verdict::hung;
            trial->limit = budget_.candidate;
            trial->message = fmt::format("did not come to an end within {:g} {}", budget_.candidate,
                                         budget_.candidate == 1 ? "second" : "seconds");
        }
        const Trial* before = record_.find(candidate);
        if (before != nullptr && before->verdict == Verdict::good && trial->verdict == Verdict::good) {
            trial->updates_per_second = std::max(trial->updates_per_second, before->updates_per_second);
        }
        record_.put(*trial);
        hands_.keep(record_);
    }

    Record& record_;
    const Budget& budget_;
    const Hands& hands_;
    double began_;
};

}  // namespace

bool has_more_patience(const Budget& budget, const Record& record) {
    return std::ranges::any_of(record.trials, [&](const Trial& trial) { return deserves_more(trial, budget); });
}

void search(Record& record, const std::vector<Candidate>& candidates, Effort effort, const Budget& budget,
            const Hands& hands) {
    const bool exhaustive = effort == Effort::exhaustive;
    if (exhaustive && !record.exhaustive) {
        std::erase_if(record.trials, [](const Trial& trial) { return !struck_out(trial.verdict); });
    }
    record.exhaustive = exhaustive;
    record.complete = false;
    Search work(record, budget, hands);
    work.all(candidates);
    work.again(exhaustive ? 3 : 1);
    work.close();
}

}  // namespace pelage::tune
