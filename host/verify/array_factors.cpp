// See array_factors.hpp.
#include "verify/array_factors.hpp"

#include "core/models.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <utility>

namespace pelage::verify {

namespace {

std::vector<Factor> lattice_worlds() {
    return {{"stencil", {"nine-point", "moore", "five-point", "sims", "3x3", "published"}},
            {"boundary", {"no-flux", "wrap", "absorbing"}},
            {"path", {"step", "shared", "streamed", "tiled"}},
            {"width", {"1", "own", "other"}},
            {"group", {"one", "several"}},
            {"cut", {"whole", "small"}},
            {"sizes", {"several", "many"}},
            {"rates", {"uniform", "uneven", "directed", "changing"}},
            {"phases", {"none", "three"}},
            {"growth", {"none", "inserted", "stretched"}},
            {"intervals", {"tested", "compiled"}},
            {"start", {"0", "65530", "4294967200"}},
            {"precision", {"float", "double"}},
            {"ends", {"free", "bounded"}},
            {"chemicals", {"few", "twenty"}}};
}

std::vector<Factor> cell_worlds() {
    return {{"path", {"step", "shared"}},
            {"width", {"own", "1", "other"}},
            {"group", {"one", "several"}},
            {"search", {"bins", "sorting"}},
            {"domain", {"wide", "narrow", "packed"}},
            {"limit", {"none", "4"}},
            {"mirrors", {"none", "pairs"}},
            {"sizes", {"tissue", "several"}},
            {"rates", {"uniform", "uneven", "changing"}},
            {"phases", {"none", "three"}},
            {"intervals", {"tested", "compiled"}},
            {"start", {"0", "65530", "4294967200"}},
            {"precision", {"float", "double"}},
            {"ends", {"free", "bounded"}}};
}

std::vector<std::string> quantity_levels(Realm realm, const char* first) {
    std::vector<std::string> words{first, "number", "conc",      "diff",      "mapping", "X",    "Y",
                                   "AGE", "BIRTH",  "ITERATION", "NEIGHBORS", "RANDOM",  "TIME", "expression"};
    if (realm == Realm::lattice) words.insert(words.end(), {"ROW", "COLUMN", "ROWS", "COLUMNS", "around"});
    return words;
}

std::vector<Factor> rules_of(Realm realm) {
    std::vector<std::string> actions{"change conc", "change diff", "set conc", "set diff",
                                     "map",         "polarize",    "react by"};
    if (realm == Realm::cells) actions.insert(actions.end(), {"divide", "move"});
    for (const ModelFacts& model : model_table()) actions.push_back("react " + model.word);
    return {{"action", actions},
            {"amount", quantity_levels(realm, "nothing")},
            {"condition", {"always", "==", "!=", "<", "<=", ">", ">=", "in", "probability"}},
            {"read", quantity_levels(realm, "nothing")},
            {"against", {"nothing", "number", "alike", "other"}},
            {"target", {"first", "middle", "last"}},
            {"when", {"always", "interval", "every", "offset", "phase"}},
            {"deviation", {"no", "yes"}},
            {"joined", {"no", "and"}}};
}

// Of values that cannot stand together, or would hide what a case is there to show.
struct Exclusion {
    std::string_view factor, values, other, others;  // words between bars: "|a|b|"
};

constexpr std::string_view all_but_nothing = "!|nothing|";

constexpr std::array exclusions{
    // There is no such thing.
    Exclusion{"stencil", "|published|", "boundary", "|absorbing|"},
    Exclusion{"stencil", "|published|", "growth", "!|none|"},
    Exclusion{"path", "|shared|", "group", "|several|"},
    Exclusion{"path", "!|streamed|tiled|", "cut", "|small|"},
    Exclusion{"path", "|shared|", "search", "|sorting|"},
    Exclusion{"phases", "|none|", "when", "|phase|"},
    // Lattices of many cells are few and plain, or they would take long.
    Exclusion{"sizes", "|many|", "chemicals", "|twenty|"},
    Exclusion{"sizes", "|many|", "growth", "!|none|"},
    // They differ from others in weights alone, which single steps go through, and the longest programs do not change.
    Exclusion{"path", "|streamed|tiled|", "stencil", "|moore|sims|"},
    // Where no rule comes or goes there is one program for those that act, and many iterations are one launch.
    Exclusion{"intervals", "|compiled|", "when", "!|always|"},
    Exclusion{"intervals", "|compiled|", "phases", "|three|"},  // so that rules of phases meet all settings
    // Rates that nothing changes are kept as means of neighbours.
    Exclusion{"rates", "|uneven|directed|", "action", "|change diff|set diff|"},
    Exclusion{"rates", "|directed|", "action", "|polarize|"},
    // The parts of a rule.
    Exclusion{"action", "|polarize|", "amount", all_but_nothing},
    Exclusion{"action", "!|polarize|", "amount", "|nothing|"},
    Exclusion{"action", "!|change conc|change diff|divide|move|", "deviation", "|yes|"},
    Exclusion{"action", "|map|", "condition", "!|always|"},
    Exclusion{"condition", "|always|", "read", all_but_nothing},
    Exclusion{"condition", "!|always|", "read", "|nothing|"},
    Exclusion{"condition", "|always|probability|", "against", all_but_nothing},
    Exclusion{"condition", "!|always|probability|", "against", "|nothing|"},
    Exclusion{"read", "|number|nothing|", "against", "|number|"},
    // What is set always, and far moves, hide all else; children without end take long.
    Exclusion{"action", "|set conc|set diff|", "condition", "|always|"},
    Exclusion{"action", "|move|", "amount", "!|number|conc|diff|mapping|RANDOM|"},
    Exclusion{"action", "|divide|", "joined", "|no|"},
    Exclusion{"action", "|divide|", "when", "|always|"},
};

// Left out of pairs: these programs are the longest to compile, and the parts that they are made of are in others.
constexpr std::array left_to_triples{
    Exclusion{"action", "!|change conc|change diff|set conc|set diff|map|polarize|divide|move|", "amount",
              "!|nothing|number|conc|mapping|ITERATION|RANDOM|"},
    Exclusion{"action", "!|change conc|change diff|set conc|set diff|map|polarize|divide|move|", "read",
              "!|nothing|number|conc|AGE|RANDOM|"},
    // What one work-item does alone hides that others must wait.
    Exclusion{"path", "|streamed|tiled|", "group", "|one|"},
    Exclusion{"stencil", "|moore|sims|", "rates", "|uneven|directed|"},
    Exclusion{"path", "|streamed|tiled|", "chemicals", "|twenty|"},
    Exclusion{"path", "|streamed|tiled|", "precision", "|double|"},
    Exclusion{"search", "|bins|sorting|", "precision", "|double|"},
    Exclusion{"search", "|bins|sorting|", "width", "|other|"},
    Exclusion{"search", "|bins|sorting|", "condition", "|!=|<=|>|>=|"},
    Exclusion{"search", "|bins|sorting|", "against", "|other|"},
};

bool among(std::string_view list, const std::string& word) {
    const bool inside = list.find("|" + word + "|") != std::string_view::npos;
    return list.front() == '!' ? !inside : inside;
}

bool excluded(const Exclusion& one, const std::string& factor, const std::string& value, const std::string& other,
              const std::string& other_value) {
    return one.factor == factor && one.other == other && among(one.values, value) && among(one.others, other_value);
}

// For each pair of values whether they may stand together: asked millions of times.
class Table {
public:
    Table(Realm realm, std::size_t strength) : quick_(strength == 2) {
        const std::vector<Factor>& factors = factors_of(realm);
        for (const Factor& factor : factors) {
            first_.push_back(count_);
            count_ += factor.values.size();
        }
        may_.assign(count_ * count_, true);
        for (std::size_t a = 0; a < factors.size(); ++a) {
            for (std::size_t b = 0; b < factors.size(); ++b) fill(factors, a, b);
        }
    }

    bool may(const Choice& a, const Choice& b) const {
        return may_[(first_[a.factor] + a.value) * count_ + first_[b.factor] + b.value];
    }

private:
    void fill(const std::vector<Factor>& factors, std::size_t a, std::size_t b) {
        for (std::size_t i = 0; i < factors[a].values.size(); ++i) {
            for (std::size_t k = 0; k < factors[b].values.size(); ++k) {
                const std::string &va = factors[a].values[i], &vb = factors[b].values[k];
                const auto forbids = [&](const Exclusion& one) {
                    return excluded(one, factors[a].name, va, factors[b].name, vb) ||
                           excluded(one, factors[b].name, vb, factors[a].name, va);
                };
                const bool no = std::ranges::any_of(exclusions, forbids) ||
                                (quick_ && std::ranges::any_of(left_to_triples, forbids));
                if (no) may_[(first_[a] + i) * count_ + first_[b] + k] = false;
            }
        }
    }

    bool quick_;
    std::vector<std::size_t> first_;
    std::size_t count_ = 0;
    std::vector<bool> may_;
};

const Table& table(Realm realm, std::size_t strength) {
    static std::map<std::pair<Realm, std::size_t>, Table> known;
    auto at = known.find({realm, strength});
    if (at == known.end()) at = known.emplace(std::pair{realm, strength}, Table(realm, strength)).first;
    return at->second;
}

const Covering& worlds(Realm realm, std::size_t strength) {
    static std::map<std::pair<Realm, std::size_t>, Covering> known;
    auto at = known.find({realm, strength});
    if (at == known.end()) at = known.emplace(std::pair{realm, strength}, cover(world_array(realm, strength))).first;
    return at->second;
}

// About how long the compiler is at one rule.
std::size_t cost(const Values& world) {
    std::size_t cost = world["width"] == "1" ? 2 : 3;
    if (world["precision"] == "double") cost += 1;
    const std::string& path = world["path"];
    if (path == "streamed") return 8 * cost;
    if (path == "tiled" || world.realm() == Realm::cells) return (path == "shared" ? 12 : 4) * cost;
    return cost;
}

std::vector<GeneratedWorld> deal_rules(Realm realm, std::size_t strength) {
    std::vector<GeneratedWorld> made;
    for (const ArrayRow& world : worlds(realm, strength).rows) made.push_back({made.size(), world, {}});
    const Covering rules = cover(rule_array(realm, strength));
    for (std::size_t i = 0; i < rules.rows.size(); ++i) made[rules.of_given[i]].rules.push_back(rules.rows[i]);
    return made;
}

// Among the first 800 these draws deal pairs into the worlds whose programs are compiled soonest.
std::uint64_t draw_of(Realm realm) { return realm == Realm::lattice ? 240 : 338; }

}  // namespace

std::size_t world_factors(Realm realm) {
    static const std::size_t of_lattices = lattice_worlds().size(), of_cells = cell_worlds().size();
    return realm == Realm::lattice ? of_lattices : of_cells;
}

const std::vector<Factor>& factors_of(Realm realm) {
    const auto join = [](std::vector<Factor> world, const std::vector<Factor>& rule) {
        world.insert(world.end(), rule.begin(), rule.end());
        return world;
    };
    static const auto of_lattices = join(lattice_worlds(), rules_of(Realm::lattice));
    static const auto of_cells = join(cell_worlds(), rules_of(Realm::cells));
    return realm == Realm::lattice ? of_lattices : of_cells;
}

bool feasible(Realm realm, std::size_t strength, const Choice& a, const Choice& b) {
    return table(realm, strength).may(a, b);
}

const std::string& Values::operator[](std::string_view factor) const {
    const std::vector<Factor>& factors = factors_of(realm_);
    for (std::size_t i = 0; i < row_->size(); ++i) {
        if (factors[i].name == factor) return factors[i].values[(*row_)[i]];
    }
    throw std::out_of_range("no factor is named " + std::string(factor));
}

namespace {

// Of triples those of settings of the world, and those of parts of a rule that have few values together. What a rule
// has to do with its world is in the pairs.
constexpr std::size_t most_triples_of_parts = 150;

std::function<bool(const std::vector<std::size_t>&)> wanted_sets(Realm realm, std::size_t strength) {
    if (strength == 2) return {};
    return [realm](const std::vector<std::size_t>& set) {
        const auto of_world = [&](std::size_t factor) { return factor < world_factors(realm); };
        if (std::ranges::any_of(set, of_world)) return std::ranges::all_of(set, of_world);
        std::size_t tuples = 1;
        for (const std::size_t factor : set) tuples *= factors_of(realm)[factor].values.size();
        return tuples <= most_triples_of_parts;
    };
}

}  // namespace

Array world_array(Realm realm, std::size_t strength) {
    const std::vector<Factor>& all = factors_of(realm);
    const auto count = static_cast<std::ptrdiff_t>(world_factors(realm));
    return {{all.begin(), all.begin() + count},
            strength,
            [&may = table(realm, strength)](const Choice& a, const Choice& b) { return may.may(a, b); },
            {},
            wanted_sets(realm, strength),
            {},
            draw_of(realm)};
}

Array rule_array(Realm realm, std::size_t strength) {
    Array array{factors_of(realm), strength,
                [&may = table(realm, strength)](const Choice& a, const Choice& b) { return may.may(a, b); },
                worlds(realm, strength).rows, wanted_sets(realm, strength)};
    for (const ArrayRow& world : array.given) array.costs.push_back(cost({realm, world}));
    return array;
}

std::size_t world_count(Realm realm, std::size_t strength) { return worlds(realm, strength).rows.size(); }

const ArrayRow& world_row(Realm realm, std::size_t strength, std::size_t nth) {
    return worlds(realm, strength).rows[nth];
}

const std::vector<GeneratedWorld>& generated_worlds(Realm realm, std::size_t strength) {
    static std::map<std::pair<Realm, std::size_t>, std::vector<GeneratedWorld>> known;
    auto at = known.find({realm, strength});
    if (at == known.end()) at = known.emplace(std::pair{realm, strength}, deal_rules(realm, strength)).first;
    return at->second;
}

}  // namespace pelage::verify
