// See starts.hpp.
#include "core/starts.hpp"

#include "core/space.hpp"
#include "core/visit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace pelage {

namespace {

struct Reach {
    double low = 0.0;
    double high = 0.0;
};

// Where the values of a spread lie: drawn ones in float, as initial_state() draws them.
Reach reach(const Spread& spread) {
    const auto value = static_cast<float>(spread.value);
    const auto deviation = static_cast<float>(spread.deviation);
    if (deviation == 0.0f) return {spread.value, spread.value};
    return {double{value - deviation}, double{value + deviation}};
}

bool drawn(const Spread& spread) { return static_cast<float>(spread.deviation) != 0.0f; }

// A limit that cannot be told from the value in float is met.
bool beyond(double value, double bound) {
    return value > bound &&
           static_cast<float>(value) > static_cast<float>(bound) + 1e-6f * std::fabs(static_cast<float>(bound));
}
bool above(double value, const Bounds& bounds) { return beyond(value, bounds.limit); }
bool below(double value, const Bounds& bounds) { return beyond(-value, -bounds.floor); }

std::string range(const Bounds& bounds) {
    if (std::isinf(bounds.limit)) return fmt::format("its floor {}", bounds.floor);
    if (std::isinf(bounds.floor)) return fmt::format("its limit {}", bounds.limit);
    return fmt::format("its bounds {} to {}", bounds.floor, bounds.limit);
}

class Search {
public:
    explicit Search(const Experiment& experiment) : experiment_(experiment), space_(space_of(experiment)) {
        untold_ = starting_outside();
    }

    std::vector<StartFault> faults() {
        for (place_ = 0; place_ < experiment_.prepattern.size(); ++place_) look(experiment_.prepattern[place_]);
        for (std::size_t chemical = 0; chemical < experiment_.chemicals.size(); ++chemical) look_at_picture(chemical);
        return std::move(found_);
    }

private:
    void look(const Statement& statement) {
        std::visit(Overloaded{
                       [&](const UseChemical& use) {
                           if (use.diff) rate(use.chemical, *use.diff);
                           if (use.conc) concentration(use.chemical, *use.conc);
                           if (use.conc) std::erase(untold_, use.chemical);
                       },
                       [&](const SetCells& set) { look(set.what); },
                       [&](const UsePolarity&) {},
                       [&](const UseSeed&) {},
                       [&](const auto&) { create(); },
                   },
                   statement);
    }

    void look(const decltype(SetCells::what)& what) {
        if (const auto* set = std::get_if<SetRate>(&what)) rate(set->chemical, set->value);
        if (const auto* set = std::get_if<SetConcentration>(&what)) concentration(set->chemical, set->value);
    }

    const std::string& name(std::size_t chemical) const { return experiment_.chemicals[chemical].name; }
    const Bounds& bounds(std::size_t chemical) const { return experiment_.phases.front().bounds[chemical]; }

    void note(bool of_rate, bool refused, std::string text) {
        found_.push_back({place_, std::nullopt, of_rate, false, refused, std::move(text)});
    }

    // What an expression gives is known when the cells are there: initial_state() judges it.
    void rate(std::size_t chemical, const Spread& spread) {
        if (spread.expression) return;
        const Reach values = reach(spread);
        if (!(values.low < 0.0)) return;
        if (drawn(spread)) {
            return note(true, true,
                        fmt::format("the diffusion rate of '{}' is drawn from {:.6g} to {:.6g}; below 0 there are "
                                    "pairs of cells whose mean rate has no bound, so 'dev' may be {} at most",
                                    name(chemical), values.low, values.high, std::max(0.0, spread.value)));
        }
        if (keeps_places(space_)) {
            return note(true, true,
                        fmt::format("the diffusion rate {} of '{}' is below 0; {} every difference would "
                                    "grow without end",
                                    spread.value, name(chemical),
                                    std::holds_alternative<Volume>(space_)      ? "in a volume"
                                    : std::holds_alternative<MeshCells>(space_) ? "on a mesh"
                                                                                : "on a lattice"));
        }
        note(true, false,
             fmt::format("the diffusion rate {} of '{}' is below 0; such cells pump towards where there is more, "
                         "without end",
                         spread.value, name(chemical)));
    }

    void concentration(std::size_t chemical, const Spread& spread) {
        if (experiment_.chemicals[chemical].initial || spread.expression) return;
        const Reach values = reach(spread);
        const Bounds& allowed = bounds(chemical);
        if (!below(values.low, allowed) && !above(values.high, allowed)) return;
        if (!drawn(spread)) {
            return note(false, true,
                        fmt::format("'{}' starts at {}, outside {}", name(chemical), spread.value, range(allowed)));
        }
        const bool outside = below(values.high, allowed) || above(values.low, allowed);
        note(false, outside,
             fmt::format("'{}' starts between {:.6g} and {:.6g}, {}outside {}{}", name(chemical), values.low,
                         values.high, outside ? "" : "partly ", range(allowed),
                         outside ? "" : "; the first iteration cuts what is"));
    }

    // Chemicals that start at 0, outside their bounds, unless something else is said.
    std::vector<std::size_t> starting_outside() const {
        std::vector<std::size_t> chemicals;
        for (std::size_t chemical = 0; chemical < experiment_.chemicals.size(); ++chemical) {
            if (experiment_.chemicals[chemical].initial || is_set(chemical)) continue;
            if (below(0.0, bounds(chemical)) || above(0.0, bounds(chemical))) chemicals.push_back(chemical);
        }
        return chemicals;
    }

    bool is_set(std::size_t chemical) const {
        return std::ranges::any_of(experiment_.prepattern, [&](const Statement& statement) {
            const auto* set = std::get_if<SetCells>(&statement);
            const auto* conc = set == nullptr ? nullptr : std::get_if<SetConcentration>(&set->what);
            return conc != nullptr && conc->chemical == chemical;
        });
    }

    void create() {
        for (const std::size_t chemical : untold_) {
            note(false, true,
                 fmt::format("'{0}' starts at 0, outside {1}; write 'use chemical {0} conc VALUE' before",
                             name(chemical), range(bounds(chemical))));
            found_.back().untold = true;
        }
        untold_.clear();
    }

    void look_at_picture(std::size_t chemical) {
        const auto& field = experiment_.chemicals[chemical].initial;
        if (!field || field->values.empty()) return;
        const auto [low, high] = std::ranges::minmax(field->values);
        const Bounds& allowed = bounds(chemical);
        if (!below(low, allowed) && !above(high, allowed)) return;
        found_.push_back({std::nullopt, chemical, false, false, true,
                          fmt::format("the picture of '{}' holds {:.6g} to {:.6g}, outside {}", name(chemical), low,
                                      high, range(allowed))});
    }

    const Experiment& experiment_;
    Space space_;
    std::size_t place_ = 0;
    std::vector<std::size_t> untold_;  // of starting_outside() those of which no `use` has told yet
    std::vector<StartFault> found_;
};

}  // namespace

std::vector<StartFault> start_faults(const Experiment& experiment) { return Search(experiment).faults(); }

}  // namespace pelage
