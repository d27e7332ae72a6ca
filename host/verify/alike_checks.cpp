// See check.hpp: which worlds can be carried out together is the backend's to say (OpenclBackend::structure); whatever
// it takes for alike must have the bits that it has alone.
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "reference/backend.hpp"
#include "verify/check.hpp"

#include <fmt/format.h>

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace pelage::verify {

namespace {

constexpr std::string_view drawn_rule = "rule always change U conc (0.1 * RANDOM)\n";

// Worlds of every kind of space, and lattices that grow.
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> every_kind{{
    {"create matrix 9 7 wrap\n", drawn_rule},
    {"create matrix 9 7 no-flux\nrule every 3 always expand columns 1 rows 1\n", drawn_rule},
    {"create matrix 9 7 wrap\nrule always expand columns 1 rows 1 by bilinear\n", drawn_rule},
    {"create volume 5 4 3 wrap\n", drawn_rule},
    {"create charges 9 7\nset cells where (COLUMN == 4) chemical V conc 1\n", "rule always aggregate V U eta 2\n"},
    {"create icosphere 1\n", drawn_rule},
    {"create hex_grid 5 4\n", drawn_rule},
    {"create sqr_grid 5 4 fixed\n", drawn_rule},
}};

// A lattice, and what another one has in its place.
constexpr std::string_view one_lattice =
    "define time_step 0.5\n"
    "define chemical U\n"
    "define chemical V limit 0.5\n"
    "use chemical U diff 0.1\n"
    "use seed 1\n"
    "create matrix 9 7 wrap at 1 2\n"
    "set cells where (RANDOM < 0.5) chemical V conc 0.25\n"
    "rule from 2 until 11 every 3 offset 1 always change U conc (0.1 * RANDOM)\n"
    "rule if U conc > 0.05 change V conc 0.01\n"
    "phase \"one\" 4\n"
    "use chemical U diff 0.2\n"
    "rule always react U V linear au 0.08 bu -0.08 cu 0.04 du 0.03 mu 2 av 0.1 bv 0 cv -0.15 dv 0.06 mv 2\n"
    "phase \"two\" 6\n"
    "define chemical V limit 0.4\n"
    "rule until 5 every 2 always change V conc (0.01 * X)\n"
    "phase \"three\" 20\n"
    "use chemical U diff 0.3\n";
constexpr std::array<std::pair<std::string_view, std::string_view>, 28> one_apart{{
    {"time_step 0.5", "time_step 0.25"},
    {"V limit 0.5", "V limit 0.3"},
    {"V limit 0.5", "V limit none"},
    {"V limit 0.4", "V limit none"},
    {"use chemical U diff 0.1\n", ""},
    {"diff 0.1", "diff 0.05"},
    {"diff 0.2", "diff 0.05"},
    {"use chemical U diff 0.2\n", ""},
    {"seed 1", "seed 2"},
    {"9 7", "7 9"},
    {"9 7", "21 3"},
    {"wrap", "no-flux"},
    {"at 1 2", "at 3 2"},
    {"at 1 2", "at 1 5"},
    {"RANDOM < 0.5", "RANDOM < 0.25"},
    {"from 2", "from 3"},
    {"until 11", "until 7"},
    {"every 3", "every 2"},
    {"offset 1", "offset 2"},
    {"> 0.05", "> 0.02"},
    {"> 0.05", "< 0.05"},
    {"\"one\" 4", "\"one\" 5"},
    {"\"two\" 6", "\"two\" 8"},
    {"until 5", "until 3"},
    {"every 2", "every 4"},
    {"du 0.03", "du 0.01"},
    {"0.01 * X", "0.01 * Y"},
    {"react U V", "react V U"},
}};

class AlikeCheck {
public:
    explicit AlikeCheck(Place& place)
        : backend_(place.backend(setting_)), reference_(reference_backend(setting_.precision)) {}

    // Together and alone, at these iterations; if the backend takes the two for alike.
    void compare(const std::string& one, const std::string& other, const std::string& what) {
        const std::vector<BatchStart> starts{start_of(one), start_of(other)};
        const std::string structure = structure_of(starts.front());
        if (structure.empty() || structure != structure_of(starts.back())) return;
        ++taken_;
        const auto batch = backend_.make_batch(starts);
        std::vector<std::unique_ptr<Tissue>> alone;
        for (const BatchStart& start : starts) alone.push_back(reference_->make_tissue(*start.experiment, start.state));
        for (const std::uint64_t steps : {3u, 13u}) {
            batch->advance(steps);
            for (std::size_t nth = 0; nth < starts.size(); ++nth) {
                alone[nth]->advance(steps);
                add(outcome_.tally, alone[nth]->read(), batch->read(nth), setting_.precision,
                    fmt::format("{}, lattice {}, iteration {}", what, nth, alone[nth]->iteration()));
            }
        }
    }

    Outcome outcome() {
        conclude(outcome_);
        if (taken_ > 0) return outcome_;
        return {Verdict::failed, {}, "no lattice is carried out together with its like", {}};
    }

private:
    BatchStart start_of(const std::string& text) const {
        Experiment experiment = parse_experiment(text, "a text of batch/alike", ".");
        Snapshot state = initial_state(experiment, setting_.precision);
        return {std::make_shared<const Experiment>(std::move(experiment)), std::move(state)};
    }

    std::string structure_of(const BatchStart& start) const {
        return backend_.structure(*start.experiment, start.state);
    }

    Setting setting_;
    OpenclBackend& backend_;
    std::shared_ptr<Backend> reference_;
    std::size_t taken_ = 0;
    Outcome outcome_;
};

std::string lattice_with(std::string_view words, std::string_view others) {
    std::string text(one_lattice);
    return text.replace(text.find(words), words.size(), others);
}

Outcome check_alike(Place& place) {
    AlikeCheck check(place);
    for (const auto& [words, others] : one_apart)
        check.compare(std::string(one_lattice), lattice_with(words, others),
                      fmt::format("'{}' and '{}'", words, others));
    return check.outcome();
}

Outcome check_kinds(Place& place) {
    AlikeCheck check(place);
    for (const auto& kind : every_kind) {
        const auto text = [&](int seed) {
            return fmt::format("define chemical U\ndefine chemical V\nuse seed {}\n{}{}", seed, kind.first,
                               kind.second);
        };
        check.compare(text(1), text(2), std::string(kind.first));
    }
    return check.outcome();
}

}  // namespace

std::vector<Check> alike_checks() {
    return {{"batch/alike", "batches", true, check_alike}, {"batch/kinds", "batches", true, check_kinds}};
}

}  // namespace pelage::verify
