// See array_factors.hpp: the worlds, and the rules that are dealt out to them.
#include "verify/array_factors.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

namespace pelage::verify {

namespace {

using Known = std::pair<Realm, std::size_t>;

const Covering& worlds(Realm realm, std::size_t strength) {
    static std::map<Known, Covering> known;
    auto at = known.find({realm, strength});
    if (at == known.end()) at = known.emplace(Known{realm, strength}, cover(world_array(realm, strength))).first;
    return at->second;
}

// About how long the compiler is at one rule.
std::size_t cost(const Values& world) {
    std::size_t cost = world.has("width", "1") ? 2 : 3;
    if (world["precision"] == "double") cost += 1;
    if (world.realm() == Realm::lattice && world["path"] == "streamed") return 8 * cost;
    if (world.has("path", "tiled")) return 4 * cost;
    if (world.realm() == Realm::cells) return (world["path"] == "shared" ? 12 : 4) * cost;
    return cost;
}

std::vector<GeneratedWorld> deal_rules(Realm realm, std::size_t strength) {
    std::vector<GeneratedWorld> made;
    for (const ArrayRow& world : worlds(realm, strength).rows) made.push_back({made.size(), world, {}});
    if (!has_rules(realm)) return made;
    const Covering rules = cover(rule_array(realm, strength));
    for (std::size_t i = 0; i < rules.rows.size(); ++i) made[rules.of_given[i]].rules.push_back(rules.rows[i]);
    std::size_t expressions = 0;
    std::map<std::pair<std::string, std::string>, std::size_t> known;
    for (GeneratedWorld& world : made) {
        const Values values(realm, world.world);
        if (realm == Realm::lattice) world.alike = known[{values["path"], values["sizes"]}]++;
        world.expressions = expressions;
        expressions += static_cast<std::size_t>(
            std::ranges::count_if(world.rules, [&](const ArrayRow& rule) { return has_expression(realm, rule); }));
    }
    return made;
}

// Among thousands these draws deal pairs into the worlds whose programs are compiled soonest, or the fewest.
std::uint64_t draw_of(Realm realm) {
    static constexpr std::array<std::uint64_t, every_realm.size()> draws{2328, 338, 10248, 219, 472};
    return draws[static_cast<std::size_t>(realm)];
}

// Of triples those of settings of the world, and those of parts of a rule that have few values together. What a rule
// has to do with its world is in the pairs.
constexpr std::size_t most_triples_of_parts = 150;

// In volumes and on meshes, of pairs of a rule's part those that have few values together.
constexpr std::size_t most_pairs_of_parts = 40;

std::function<bool(const std::vector<std::size_t>&)> wanted_sets(Realm realm, std::size_t strength) {
    if (strength == 2 && (realm == Realm::lattice || realm == Realm::cells)) return {};
    return [realm, strength](const std::vector<std::size_t>& set) {
        const auto of_world = [&](std::size_t factor) { return factor < world_factors(realm); };
        if (std::ranges::all_of(set, of_world)) return true;
        if (strength == 3 && std::ranges::any_of(set, of_world)) return false;
        std::size_t tuples = 1;
        for (const std::size_t factor : set) tuples *= factors_of(realm)[factor].values.size();
        return tuples <= (strength == 2 ? most_pairs_of_parts : most_triples_of_parts);
    };
}

}  // namespace

Array world_array(Realm realm, std::size_t strength) {
    const std::vector<Factor>& all = factors_of(realm);
    const auto count = static_cast<std::ptrdiff_t>(world_factors(realm));
    return {{all.begin(), all.begin() + count},
            strength,
            feasibility(realm, strength),
            {},
            wanted_sets(realm, strength),
            {},
            draw_of(realm)};
}

Array rule_array(Realm realm, std::size_t strength) {
    Array array{factors_of(realm), strength, feasibility(realm, strength), worlds(realm, strength).rows,
                wanted_sets(realm, strength)};
    for (const ArrayRow& world : array.given) array.costs.push_back(cost({realm, world}));
    return array;
}

bool has_expression(Realm realm, const ArrayRow& rule) {
    const Values values(realm, rule);
    return values.has("amount", "expression") || values.has("read", "expression");
}

std::size_t world_count(Realm realm, std::size_t strength) { return worlds(realm, strength).rows.size(); }

const ArrayRow& world_row(Realm realm, std::size_t strength, std::size_t nth) {
    return worlds(realm, strength).rows[nth];
}

const std::vector<GeneratedWorld>& generated_worlds(Realm realm, std::size_t strength) {
    static std::map<Known, std::vector<GeneratedWorld>> known;
    auto at = known.find({realm, strength});
    if (at == known.end()) at = known.emplace(Known{realm, strength}, deal_rules(realm, strength)).first;
    return at->second;
}

}  // namespace pelage::verify
