// See forecast.hpp.
#include "core/forecast.hpp"

#include "core/events.hpp"
#include "core/prepattern.hpp"
#include "core/schedule.hpp"

#include <algorithm>
#include <variant>

namespace pelage {

namespace {

// How often a rule acts in iterations 0 .. last - 1.
double activations(const Rule& rule, std::uint64_t last) {
    const std::uint64_t first = next_active(rule, 0);
    if (last == 0 || first > last - 1) return 0;
    const std::uint64_t count = (std::min(rule.until, last - 1) - first) / rule.every + 1;
    return static_cast<double>(count);
}

}  // namespace

std::optional<LatticeSize> final_size(const Experiment& experiment, std::uint64_t last) {
    const auto matrix =
        std::find_if(experiment.prepattern.begin(), experiment.prepattern.end(),
                     [](const auto& statement) { return std::holds_alternative<CreateMatrix>(statement); });
    if (matrix == experiment.prepattern.end()) return {};
    auto columns = static_cast<double>(std::get<CreateMatrix>(*matrix).columns);
    auto rows = static_cast<double>(std::get<CreateMatrix>(*matrix).rows);
    for (std::size_t place = 0; place < experiment.rules.size(); ++place) {
        const Rule& rule = experiment.rules[place];
        const std::optional<Event> event = event_of(rule, place);
        const auto* expansion = event ? std::get_if<Expansion>(&*event) : nullptr;
        if (expansion == nullptr) continue;
        columns += activations(rule, last) * static_cast<double>(expansion->growth->columns);
        rows += activations(rule, last) * static_cast<double>(expansion->growth->rows);
    }
    return LatticeSize{columns, rows};
}

double final_cells(const Experiment& experiment, std::uint64_t last) {
    const auto size = final_size(experiment, last);
    return size ? size->columns * size->rows : static_cast<double>(count_cells(experiment));
}

std::uint64_t end_of_set(const Experiment& experiment, const std::vector<bool>& active, std::uint64_t iteration) {
    std::uint64_t end = forever;
    for (std::size_t i = 0; i < experiment.rules.size(); ++i) {
        const Rule& rule = experiment.rules[i];
        if (is_event(rule)) continue;
        if (active[i] && rule.until != forever) end = std::min(end, rule.until + 1);
        if (!active[i] && rule.every == 1) end = std::min(end, next_active(rule, iteration));
    }
    return end;
}

}  // namespace pelage
