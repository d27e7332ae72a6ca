// validate(): what makes an experiment meaningless, whoever built it.
#include "core/aggregate.hpp"
#include "core/checks.hpp"
#include "core/counted.hpp"
#include "core/experiment.hpp"
#include "core/scene.hpp"
#include "core/space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace pelage {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

class Checker : public Checks {
public:
    explicit Checker(const Experiment& experiment) : Checks(experiment), space_(space_of(experiment)) {}

    void check() {
        check_names();
        check_phases();
        validate_start(experiment_);
        check_fields();
        check_stencils();
        for (const Rule& rule : experiment_.rules) check_rule(rule);
        check_charges();
        check_beyond_plane();
        for (const Output& output : experiment_.outputs) check_output(output);
        if (experiment_.outputs.empty()) fail("an experiment needs at least one output");
        if (experiment_.stop_at > largest_iteration)
            fail(fmt::format("a run cannot pass iteration {}", largest_iteration));
        if (!std::is_sorted(experiment_.snap_at.begin(), experiment_.snap_at.end())) fail("snapshots are not in order");
    }

private:
    void check_output(const Output& output) const {
        check_chemical(output.chemical, "an output");
        if (output.projection) check_projection(*output.projection);
        if (output.expressions.size() > 1 && !output.rgb()) fail("an output draws one expression, or three");
        for (const Expression& expression : output.expressions) {
            check_expression(expression);
            each_operand(expression, [&](const Operand& part) { check_operand(part); });
        }
    }

    void check_projection(const Projection& projection) const {
        const auto* volume = std::get_if<Volume>(&space_);
        if (volume == nullptr) fail("`slice`, `maximum` and `transparent` show a volume; `create volume`");
        const std::array sides{volume->columns, volume->rows, volume->layers};
        const std::size_t side = sides[static_cast<std::size_t>(projection.axis)];
        if (projection.at.value_or(0) >= side)
            fail(fmt::format("an output shows slice {}; there are slices 0 to {}", *projection.at, side - 1));
    }

    void check_stencils() const {
        const auto square = [](std::size_t count) { return count == 9 || count == 25 || count == 49; };
        for (const NamedStencil& stencil : experiment_.stencils) {
            if (!square(stencil.weights.size()))
                fail(fmt::format("stencil '{}' must have 9, 25 or 49 weights", stencil.name));
            for (const double weight : stencil.weights) {
                if (!std::isfinite(weight)) fail(fmt::format("a weight of stencil '{}' is not finite", stencil.name));
            }
        }
        if (lattice() != nullptr && of_volumes(lattice()->stencil))
            fail("a matrix takes a stencil of the plane; seven-point and twenty-seven-point are those of volumes");
        if (lattice() == nullptr || lattice()->stencil != Stencil::own) return;
        const std::size_t weights = lattice()->weights.size();
        if (weights != 9 && weights != 25) fail("a stencil of one's own must have 9 or 25 weights");
        if (weights == 9) return;
        for (const Chemical& chemical : experiment_.chemicals) {
            if (chemical.anisotropic)
                fail(fmt::format(
                    "chemical '{}' is anisotropic, which needs a stencil of the cells beside; this one is 5x5",
                    chemical.name));
        }
    }

    void check_names() const {
        if (experiment_.chemicals.empty()) fail("no chemical is defined; `define chemical NAME`");
        if (experiment_.chemicals.size() > largest_chemical_count) {
            fail(fmt::format("{} chemicals are defined; at most {} are allowed", experiment_.chemicals.size(),
                             largest_chemical_count));
        }
        std::set<std::string> names;
        for (const Chemical& chemical : experiment_.chemicals) {
            if (!names.insert(chemical.name).second) fail(fmt::format("chemical '{}' is defined twice", chemical.name));
        }
        for (const std::string& mapping : experiment_.mappings) {
            if (!names.insert(mapping).second) fail(fmt::format("the name '{}' is used twice", mapping));
        }
    }

    void check_phases() const {
        const auto& phases = experiment_.phases;
        if (phases.empty() || phases.front().begin != 0) fail("the first phase must begin at iteration 0");
        for (std::size_t i = 0; i < phases.size(); ++i) {
            if (i > 0 && phases[i].begin <= phases[i - 1].begin)
                fail(fmt::format("phase '{}' is empty", phases[i].name));
            check_phase(phases[i]);
        }
    }

    void check_phase(const Phase& phase) const {
        if (!(phase.time_step >= smallest_time_step) || !std::isfinite(phase.time_step)) {
            fail(fmt::format("the time step must be positive and no less than {:.3g}; found {}", smallest_time_step,
                             phase.time_step));
        }
        const std::size_t count = experiment_.chemicals.size();
        if (phase.bounds.size() != count || phase.rates.size() != count) {
            fail(fmt::format("phase '{}' needs bounds and rates for each of the {} chemicals", phase.name, count));
        }
        for (std::size_t chemical = 0; chemical < count; ++chemical) {
            const std::string& name = experiment_.chemicals[chemical].name;
            check_bounds(phase.bounds[chemical], name);
            const double rate = phase.rates[chemical].value_or(0.0);
            if (rate >= 0.0 && std::isfinite(rate)) continue;
            fail(fmt::format("phase '{}' gives '{}' the diffusion rate {}; a rate is a number not below 0", phase.name,
                             name, rate));
        }
    }

    void check_bounds(const Bounds& bounds, const std::string& name) const {
        if (std::isnan(bounds.floor) || std::isnan(bounds.limit) || bounds.floor > bounds.limit) {
            fail(fmt::format("chemical '{}' has floor {} above its limit {}", name, bounds.floor, bounds.limit));
        }
        if (bounds.floor == infinity || bounds.limit == -infinity) {
            fail(fmt::format("chemical '{}' has bounds that no number meets: {} to {}", name, bounds.floor,
                             bounds.limit));
        }
    }

    void check_fields() {
        if (experiment_.fields.size() > largest_field_count)
            fail(fmt::format("{} fields are defined; at most {} are allowed", experiment_.fields.size(),
                             largest_field_count));
        for (std::size_t i = 0; i < experiment_.fields.size(); ++i) {
            line_ = experiment_.fields[i].line;
            std::visit([&](const auto& source) { check_field(source, i); }, experiment_.fields[i].source);
        }
        line_ = 0;
    }
    void check_field(const ComputedField& field, std::size_t place) const {
        check_expression(field.expression);
        each_operand(field.expression, [&](const Operand& part) {
            check_operand(part);
            if (!seen_by_field(part.quantity)) fail("a field reads what changes from iteration to iteration");
            if (part.quantity == Quantity::field && part.index >= place)
                fail("a field reads one that is defined after it");
            if (part.quantity == Quantity::random && !on_grid(space_))
                fail("RANDOM in a field needs a lattice, where fields are computed once; " + these_are());
        });
    }
    void check_field(const PictureField&, std::size_t) const {
        if (lattice() == nullptr) fail("a field from a picture needs a lattice; " + these_are());
    }
    void check_field(const BlobField& blobs, std::size_t) const {
        if (!keeps_places(space_)) fail("a field of blobs needs a lattice, a volume or a mesh; " + these_are());
        if (blobs.count > largest_blob_count)
            fail(fmt::format("a field has {} blobs; at most {} are allowed", blobs.count, largest_blob_count));
        if (!(blobs.sigma > 0.0) || !std::isfinite(blobs.sigma)) fail("the sigma of blobs must be above 0");
    }

    const Lattice* lattice() const { return std::get_if<Lattice>(&space_); }
    bool volume() const { return std::holds_alternative<Volume>(space_); }
    bool mesh() const { return std::holds_alternative<MeshCells>(space_); }
    std::string these_are() const { return pelage::these_are(space_); }

    void check_operand(const Operand& operand) const {
        switch (operand.quantity) {
            case Quantity::number:
                if (!std::isfinite(operand.value)) fail("a rule holds a number that is not finite");
                break;
            case Quantity::concentration:
            case Quantity::rate:
                check_chemical(operand.index, "a rule");
                break;
            case Quantity::mapping:
                if (operand.index >= experiment_.mappings.size()) fail("a rule reads a mapping that is not defined");
                break;
            case Quantity::laplacian:
                check_chemical(operand.index, "a rule");
                if (!keeps_places(space_)) fail("a laplacian needs a lattice; these are free cells");
                break;
            case Quantity::gradient_x:
            case Quantity::gradient_y:
                check_chemical(operand.index, "a rule");
                if (!on_grid(space_)) fail("gradients need a lattice; " + these_are());
                break;
            case Quantity::gradient_z:
                check_chemical(operand.index, "a rule");
                check_layers();
                break;
            case Quantity::z:
                if (!mesh()) check_layers();
                break;
            case Quantity::layer:
            case Quantity::layers:
                check_layers();
                break;
            case Quantity::stencil:
                check_chemical(operand.index, "a rule");
                if (operand.stencil >= experiment_.stencils.size()) fail("a rule names a stencil that is not defined");
                if (lattice() == nullptr) fail("a stencil with a name needs a lattice; " + these_are());
                break;
            case Quantity::field:
                if (operand.index >= experiment_.fields.size()) fail("a rule reads a field that is not defined");
                break;
            case Quantity::expression:
                each_operand(checked_expression(operand.index, "a rule"),
                             [&](const Operand& part) { check_operand(part); });
                break;
            case Quantity::row:
            case Quantity::column:
            case Quantity::rows:
            case Quantity::columns:
                if (!on_grid(space_))
                    fail("ROW, COLUMN, ROWS and COLUMNS need a lattice; " + these_are() +
                         (mesh() ? " (use X, Y and Z)" : " (use X and Y)"));
                break;
            default:
                break;
        }
    }

    void check_layers() const {
        if (!volume()) fail("Z, LAYER, LAYERS and gradient_z need a volume; `create volume COLUMNS ROWS LAYERS`");
    }

    void check_rule(const Rule& rule) {
        line_ = rule.line;
        if (rule.every == 0) fail("`every 0` never comes; the smallest period is 1");
        std::visit([&](const auto& condition) { check_condition(condition); }, rule.condition);
        std::visit([&](const auto& action) { check_action(rule, action); }, rule.action);
        line_ = 0;
    }

    void check_condition(const Always&) const {}
    void check_condition(const Compare& compare) const {
        check_operand(compare.left);
        check_operand(compare.right);
    }
    void check_condition(const Within& within) const {
        check_operand(within.value);
        check_operand(within.low);
        check_operand(within.high);
    }
    void check_condition(const Probability& probability) const { check_operand(probability.chance); }

    void check_action(const Rule&, const React& react) const {
        if (react.model.index >= model_table().size()) fail("a rule names a reaction that is not in the table");
        const ModelFacts& model = react.model.facts();
        if (react.species.size() != model.species.size()) {
            fail(fmt::format("{} takes {}; found {}", model.word, counted(model.species.size(), "chemical"),
                             react.species.size()));
        }
        for (const std::size_t chemical : react.species) check_chemical(chemical, "a reaction");
        if (std::set(react.species.begin(), react.species.end()).size() != react.species.size()) {
            fail("a reaction needs different chemicals");
        }
        check_operand(react.scale);
        if (react.parameters.size() != model.parameters.size()) {
            fail(fmt::format("{} takes {}; found {}", model.word, counted(model.parameters.size(), "parameter"),
                             react.parameters.size()));
        }
        for (const Operand& parameter : react.parameters) check_operand(parameter);
    }
    void check_action(const Rule&, const Formula& formula) const {
        std::set<std::size_t> chemicals;
        for (const Formula::Part& part : formula.parts) {
            check_chemical(part.chemical, "a formula");
            check_operand(part.rate);
            if (!chemicals.insert(part.chemical).second) fail("a formula changes each chemical at most once");
        }
        if (formula.parts.empty()) fail("a formula changes no chemical");
    }
    void check_action(const Rule&, const Neural& neural) const {
        if (!keeps_places(space_)) fail("a neural reaction needs a lattice; these are free cells");
        if (neural.network == nullptr) fail("a neural reaction has no network");
        if (neural.species.size() != neural.network->chemicals) {
            fail(fmt::format("the network takes {}; found {}", counted(neural.network->chemicals, "chemical"),
                             neural.species.size()));
        }
        for (const std::size_t chemical : neural.species) check_chemical(chemical, "a neural reaction");
        if (std::set(neural.species.begin(), neural.species.end()).size() != neural.species.size())
            fail("a neural reaction needs different chemicals");
        check_operand(neural.rate);
        check_operand(neural.diffusion);
        if (neural.diffusion.quantity == Quantity::number && neural.diffusion.value < 0.0)
            fail(fmt::format("a network's diffusion {} is below 0; every difference would grow without end",
                             neural.diffusion.value));
    }
    void check_action(const Rule&, const Change& change) const {
        check_chemical(change.chemical, "a `change`");
        check_operand(change.amount);
        check_deviation(change.deviation);
    }
    void check_action(const Rule&, const Set& set) const {
        check_chemical(set.chemical, "a `set`");
        check_operand(set.value);
    }
    void check_action(const Rule& rule, const Map& map) const {
        if (!std::holds_alternative<Always>(rule.condition)) fail("a `map` rule takes the condition `always`");
        if (map.mapping >= experiment_.mappings.size()) fail("a `map` rule writes a mapping that is not defined");
        for (const double end : {map.from_low, map.from_high, map.to_low, map.to_high})
            check_number(end, "an end of a `map` rule's interval");
        if (static_cast<float>(map.from_low) == static_cast<float>(map.from_high))
            fail("a `map` rule needs two different source limits");
        check_operand(map.value);
    }
    void check_action(const Rule&, const Polarize& polarize) const {
        check_chemical(polarize.chemical, "a `polarize`");
    }
    void check_action(const Rule&, const Divide& divide) const {
        check_operand(divide.direction);
        check_deviation(divide.deviation);
    }
    void check_action(const Rule&, const Move& move) const {
        check_operand(move.distance);
        check_deviation(move.deviation);
    }
    void check_action(const Rule&, const And&) const {}
    void check_action(const Rule& rule, const Expand& expand) const {
        if (lattice() == nullptr || !lattice()->expandable)
            fail("`expand` needs a matrix; `create matrix COLUMNS ROWS`");
        if (!std::holds_alternative<Always>(rule.condition)) fail("an `expand` rule takes the condition `always`");
        if (expand.columns + expand.rows == 0) fail("an `expand` rule inserts no columns and no rows");
        if (expand.columns > 1000 || expand.rows > 1000)
            fail("an `expand` rule inserts at most 1000 columns and rows at a time");
        if (!(expand.band_weight >= 0.0) || !std::isfinite(expand.band_weight)) fail("a weight must be 0 or more");
        const bool whole = expand.band_low <= 0.0 && expand.band_high >= 1.0;
        if (expand.band_weight == 0.0 && whole) fail("a weight of 0 for all rows or columns leaves none to pick");
        if (expand.distribution == Distribution::shuffled && expand.band_weight != 1.0) {
            fail("a shuffled distribution picks every place equally often and takes no weight");
        }
        const bool draws =
            expand.rows_first || expand.distribution != Distribution::uniform || expand.band_weight != 1.0;
        if (expand.interpolation && draws) fail("an interpolation takes no order, no distribution and no weight");
    }

    void check_action(const Rule& rule, const Aggregate& aggregate) const {
        if (lattice() == nullptr || !lattice()->charges)
            fail("`aggregate` needs charges; `create charges COLUMNS ROWS`");
        if (!std::holds_alternative<Always>(rule.condition)) fail("an `aggregate` rule takes the condition `always`");
        const std::vector<std::size_t> held = held_by(aggregate);
        for (const std::size_t chemical : held) check_chemical(chemical, "an `aggregate`");
        if (std::set(held.begin(), held.end()).size() != held.size())
            fail("an `aggregate` keeps order, potential, seed and size in different chemicals");
        const Aggregate& first = aggregate_of(experiment_);
        if (held != held_by(first) || aggregate.seed != first.seed)
            fail("all `aggregate` rules keep order, potential, seed and size in the same chemicals, or none of a kind");
        if (aggregate.far_field != first.far_field)
            fail("all `aggregate` rules of an experiment say `far-field`, or none of them does");
        if (aggregate.far_field && aggregate.strength != Operand::number(0.0))
            fail("an `aggregate` with `far-field` takes no `towards`");
        each_parameter(aggregate, [&](const Operand& operand) { check_parameter(operand, false); });
        check_parameter(aggregate.grown, true);
    }
    static std::vector<std::size_t> held_by(const Aggregate& aggregate) {
        std::vector<std::size_t> held{aggregate.order, aggregate.potential};
        if (aggregate.seed) held.push_back(*aggregate.seed);
        if (aggregate.size) held.push_back(*aggregate.size);
        return held;
    }
    void check_parameter(const Operand& operand, bool drawn) const {
        check_operand(operand);
        const auto check = [&](const Operand& part) {
            const Quantity quantity = part.quantity;
            if (quantity == Quantity::number || quantity == Quantity::iteration || quantity == Quantity::time) return;
            if (drawn && quantity == Quantity::random) return;
            fail(
                "parameters of `aggregate` are the same for all sites: numbers, ITERATION and TIME, and RANDOM for a "
                "size");
        };
        if (operand.quantity != Quantity::expression) return check(operand);
        each_operand(checked_expression(operand.index, "a rule"), check);
    }

    // Nothing but growth happens to charges.
    void check_charges() {
        check_open();
        if (lattice() == nullptr || !lattice()->charges) return;
        if (lattice()->columns > widest_aggregate || lattice()->rows > widest_aggregate)
            fail(fmt::format("charges are at most {} in a row or column", widest_aggregate));
        for (const Rule& rule : experiment_.rules) {
            line_ = rule.line;
            if (!std::holds_alternative<Aggregate>(rule.action)) fail("charges know no rule but `aggregate`");
        }
        line_ = 0;
        check_still();
        const Aggregate& aggregate = aggregate_of(experiment_);
        for (const Phase& phase : experiment_.phases) {
            for (const std::size_t chemical : held_by(aggregate)) check_free(phase, chemical);
        }
    }
    void check_open() const {
        for (const Statement& statement : experiment_.prepattern) {
            const auto* made = std::get_if<CreateMatrix>(&statement);
            if (made == nullptr || !made->where) continue;
            if (!made->charges || *made->where >= experiment_.fields.size())
                fail("`where` belongs to `create charges` and names a field");
        }
    }
    void check_still() const {
        const auto moves = [](const Statement& statement) {
            if (const auto* set = std::get_if<SetCells>(&statement)) return std::holds_alternative<SetRate>(set->what);
            const auto* use = std::get_if<UseChemical>(&statement);
            return use != nullptr && use->diff && (use->diff->value != 0.0 || use->diff->deviation != 0.0);
        };
        for (const Statement& statement : experiment_.prepattern) {
            if (moves(statement)) fail("nothing diffuses among charges; leave the diffusion rate out");
        }
        for (const Phase& phase : experiment_.phases) {
            for (const auto& rate : phase.rates) {
                if (rate.value_or(0.0) != 0.0) fail("nothing diffuses among charges; leave the diffusion rate out");
            }
        }
    }
    void check_free(const Phase& phase, std::size_t chemical) const {
        const Bounds& bounds = phase.bounds[chemical];
        if (bounds.floor <= 0.0 && bounds.limit == infinity) return;
        fail(fmt::format("'{}' holds something of charges; it takes no bounds", experiment_.chemicals[chemical].name));
    }

    // What a plane alone has: volumes and meshes have no polarity, and their cells neither move nor grow in number.
    void check_beyond_plane() {
        if (!volume() && !mesh()) return;
        const std::string plane = " belongs to a plane; " + these_are();
        for (const Rule& rule : experiment_.rules) {
            line_ = rule.line;
            if (std::holds_alternative<Polarize>(rule.action)) fail("`polarize`" + plane);
            if (std::holds_alternative<Divide>(rule.action)) fail("`divide`" + plane);
            if (std::holds_alternative<Move>(rule.action)) fail("`move`" + plane);
        }
        line_ = 0;
        for (const Chemical& chemical : experiment_.chemicals) {
            if (chemical.anisotropic) fail(fmt::format("chemical '{}' is anisotropic, which{}", chemical.name, plane));
            if (chemical.initial)
                fail(fmt::format("chemical '{}' starts from a picture, which{}", chemical.name, plane));
        }
        for (const Statement& statement : experiment_.prepattern) {
            const auto* set = std::get_if<SetCells>(&statement);
            if (std::holds_alternative<UsePolarity>(statement) ||
                (set != nullptr && std::holds_alternative<SetPolarity>(set->what)))
                fail("polarity" + plane);
        }
        if (experiment_.texture) fail("a texture" + plane);
    }

    Space space_;
};

}  // namespace

void validate(const Experiment& experiment) { Checker(experiment).check(); }

}  // namespace pelage
