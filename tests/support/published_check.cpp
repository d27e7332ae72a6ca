// See published_check.hpp.
#include "support/published_check.hpp"

#include "core/prepattern.hpp"
#include "reference/cells/tissue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace test {

using namespace pelage;

namespace {

class Comparison {
public:
    Comparison(const PublishedCells& published, const std::string& state) : published_(published), state_(state) {}

    void values(const std::string& what, const std::vector<double>& found, const std::vector<double>& wanted,
                double noise) {
        if (found.size() != wanted.size())
            return wrong("{}: {} cells instead of {}", what, found.size(), wanted.size());
        const auto [low, high] = std::minmax_element(wanted.begin(), wanted.end());
        const double share = state_ == "final" ? 1e-5 : 4e-6;
        const double allowed = std::max(share * std::max(*high - *low, std::abs(*high)), 4 * noise);
        for (std::size_t i = 0; i < found.size(); ++i) {
            if (std::abs(found[i] - wanted[i]) <= allowed) continue;
            return wrong("{} of cell {}: {} instead of {}, {:.3g} allowed", what, i, found[i], wanted[i], allowed);
        }
    }

    void optional(const std::string& array, const std::vector<double>& found, double noise) {
        const std::string name = array + "_" + state_;
        if (published_.has(name)) values(array, found, published_.array(name), noise);
    }

    std::string text() const { return text_; }

    template <class... Values>
    void wrong(fmt::format_string<Values...> format, Values&&... values) {
        text_ += fmt::format("{} at {}: ", published_.name(), state_);
        text_ += fmt::format(format, std::forward<Values>(values)...) + "\n";
    }

private:
    const PublishedCells& published_;
    std::string state_;
    std::string text_;
};

}  // namespace

std::unique_ptr<Tissue> start_published(const Experiment& experiment) {
    const auto search = experiment.domain.packed ? NeighbourSearch::spatial_sorting : NeighbourSearch::kd_tree;
    return make_reference_cells(std::make_shared<const Experiment>(experiment), initial_state(experiment),
                                Precision::single_, search);
}

std::string published_mismatch(const PublishedCells& published, Tissue& tissue, const std::string& state) {
    const std::uint64_t iteration = state == "final" ? published.iterations() : std::stoull(state);
    tissue.advance(iteration - tissue.iteration());
    const Snapshot now = tissue.read();
    Comparison comparison(published, state);
    const double noise = published.noise(state);
    const auto conc = published.by_chemical("conc_" + state);
    for (std::size_t chemical = 0; chemical < conc.size(); ++chemical) {
        comparison.values(published.experiment().chemicals[chemical].name, now.conc[chemical], conc[chemical], noise);
    }
    comparison.optional("x", now.x, published.position_noise(state));
    comparison.optional("y", now.y, published.position_noise(state));
    comparison.optional("px", now.polarity_x, noise);
    comparison.optional("py", now.polarity_y, noise);
    comparison.optional("birth", {now.birth.begin(), now.birth.end()}, 0.0);
    if (published.has("neighbors_" + state)) {
        const std::vector<double> counts = published.array("neighbors_" + state);
        if (std::vector<double>(now.neighbours.begin(), now.neighbours.end()) != counts) {
            comparison.wrong("other neighbour counts");
        }
    }
    return comparison.text();
}

}  // namespace test
