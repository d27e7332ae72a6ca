// See check.hpp: lattices that are carried out together (opencl/lattice/batch.hpp) have the bits of those that run
// alone, each with numbers, a seed and a start of its own.
#include "core/prepattern.hpp"
#include "core/visit.hpp"
#include "reference/backend.hpp"
#include "verify/bounded.hpp"
#include "verify/cases.hpp"
#include "verify/check.hpp"
#include "verify/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>
#include <variant>

namespace pelage::verify {

namespace {

constexpr Size batch_size{37, 26}, small_batch_size{19, 11};
constexpr std::array<std::string_view, 2> quick_batches{"rules/keeping/fused", "rates/uneven/published/open"};
constexpr std::size_t batch_members = 5, leaves_early = 1;
constexpr std::array<std::uint64_t, 3> batch_strides{1, 7, 6};

// The case with numbers, seed, time step, births and counts that no other member has, some iterations on.
BatchStart member_of(const Case& one, Size size, std::size_t nth, Precision precision) {
    Experiment experiment = one.experiment(size);
    const double factor = 1.0 - 0.01 * static_cast<double>(nth);
    experiment.seed = experiment.run_seed() + static_cast<std::int64_t>(nth);
    for (Phase& phase : experiment.phases) phase.time_step *= factor;
    for (Rule& rule : experiment.rules) {
        auto* const react = std::get_if<React>(&rule.action);
        if (react == nullptr) continue;
        for (Operand& parameter : react->parameters) {
            if (parameter.quantity == Quantity::number) parameter.value *= factor;
        }
    }
    Snapshot state = initial_state(experiment, precision);
    if (one.touch) one.touch(state);
    state.iteration = 6;
    for (std::size_t cell = 0; cell < state.cells(); ++cell) {
        state.birth[cell] = static_cast<std::uint32_t>((cell + nth) % 7);
        state.neighbours[cell] = static_cast<std::int32_t>((cell + 2 * nth) % 9);
    }
    return {std::make_shared<const Experiment>(std::move(experiment)), std::move(state)};
}

class BatchCheck {
public:
    BatchCheck(const Case& one, Place& place, const Setting& setting, Outcome& outcome)
        : setting_(setting), backend_(place.backend(setting)), outcome_(outcome) {
        const auto reference = reference_backend(setting.precision);
        const bool exact = !one.divides || rounds_exactly(place, setting);
        const Size size = place.small() ? small_batch_size : batch_size;
        for (std::size_t nth = 0; nth < batch_members; ++nth) {
            starts_.push_back(member_of(one, size, nth, setting.precision));
            Backend& truth = exact ? static_cast<Backend&>(*reference) : backend_;
            alone_.push_back(truth.make_tissue(*starts_.back().experiment, starts_.back().state));
        }
    }

    void run() {
        const auto batch = backend_.make_batch(starts_);
        for (std::size_t stride = 0; stride < batch_strides.size(); ++stride) {
            batch->advance(batch_strides[stride]);
            for (std::size_t nth = 0; nth < batch_members; ++nth) {
                if (nth == leaves_early && stride == 2) continue;
                alone_[nth]->advance(batch_strides[stride]);
                add(outcome_.tally, alone_[nth]->read(), batch->read(nth), setting_.precision,
                    fmt::format("lattice {} of {}, iteration {}{}{}", nth, batch_members, alone_[nth]->iteration(),
                                setting_.text().empty() ? "" : ", ", setting_.text()));
            }
            if (stride == 1) batch->end(leaves_early);
        }
        mistrust();
    }

private:
    // Members that end alike would hide that one is taken for another.
    void mistrust() {
        for (std::size_t nth = 1; nth < batch_members; ++nth) {
            if (alone_[nth]->read().conc != alone_[nth - 1]->read().conc) continue;
            outcome_.verdict = Verdict::mistrusted;
            outcome_.message = fmt::format("lattices {} and {} end alike", nth - 1, nth);
        }
    }

    Setting setting_;
    OpenclBackend& backend_;
    std::vector<BatchStart> starts_;
    std::vector<std::unique_ptr<Tissue>> alone_;
    Outcome& outcome_;
};

Outcome every_path(const Case& one, Place& place) {
    std::vector<Setting> settings{{.variants = 1}, {.path = Path::tiled, .variants = 1}};
    const std::size_t group = std::min<std::size_t>(3, place.device().max_work_group);
    if (place.full()) settings.push_back({.work_group = group, .width = 1, .variants = 0});
    if (place.full() && place.device().fp64) settings.push_back({.precision = Precision::double_, .variants = 1});
    Outcome outcome;
    for (const Setting& setting : settings) BatchCheck(one, place, setting, outcome).run();
    conclude(outcome);
    return outcome;
}

bool may_be_batch(const Case& one) {
    const auto begins = [&](const char* word) { return one.name.starts_with(word); };
    const bool alike = one.name.find("/moore/") != std::string::npos || one.name.find("/sims/") != std::string::npos;
    return !one.grows && !alike && !begins("volume/") && !begins("values/") && !begins("sizes/");
}

}  // namespace

std::vector<Check> batch_checks() {
    std::vector<Check> checks;
    for (const Case& one : lattice_cases()) {
        if (!may_be_batch(one)) continue;
        const bool quick = std::ranges::find(quick_batches, std::string_view(one.name)) != quick_batches.end();
        checks.push_back(
            {"batch/" + one.name, "batches", quick, [&one](Place& place) { return every_path(one, place); }});
    }
    return checks;
}

}  // namespace pelage::verify
