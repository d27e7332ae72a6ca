// The factors of generated experiments, in each kind of tissue: in what world rules act, and what rules do.
#pragma once

#include "verify/covering.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace pelage::verify {

enum class Realm { lattice, cells, volume, mesh, charges };

inline constexpr std::array every_realm{Realm::lattice, Realm::cells, Realm::volume, Realm::mesh, Realm::charges};

const char* word(Realm);  // "lattice", ...

// Rules that do something to each cell for itself; what acts on charges belongs to their world.
constexpr bool has_rules(Realm realm) { return realm != Realm::charges; }

// Factors of a world come first, then those of a rule.
const std::vector<Factor>& factors_of(Realm);
std::size_t world_factors(Realm);  // how many are the world's

// Which two values may stand together in the pairs (strength 2) or triples (3).
std::function<bool(const Choice&, const Choice&)> feasibility(Realm, std::size_t strength);

// The values of a row, by the names of factors.
class Values {
public:
    Values(Realm realm, const ArrayRow& row) : realm_(realm), row_(&row) {}
    const std::string& operator[](std::string_view factor) const;  // throws std::out_of_range
    // Whether there is such a factor, and the row has that value of it.
    bool has(std::string_view factor, std::string_view value) const;
    Realm realm() const { return realm_; }

private:
    const std::string* find(std::string_view factor) const;

    Realm realm_;
    const ArrayRow* row_;
};

struct GeneratedWorld {
    std::size_t number = 0;
    ArrayRow world;
    std::vector<ArrayRow> rules;  // whole rows: the world's values, then the rule's
    std::size_t alike = 0;        // lattices before it that have its path and kind of sizes
    std::size_t expressions = 0;  // how many rules of the worlds before have one
};

// Worlds in which all pairs of values meet (strength 2), of the world, of rules, and between the two; or (3) all
// triples of settings of the world, and of parts of a rule that have few values together. In volumes and on meshes
// pairs with many values are left out: rules are made by one emitter for all.
const std::vector<GeneratedWorld>& generated_worlds(Realm, std::size_t strength);

// Whether the rule takes or reads an expression.
bool has_expression(Realm, const ArrayRow& rule);

// How many there are, and their values, known without dealing out the rules.
std::size_t world_count(Realm, std::size_t strength);
const ArrayRow& world_row(Realm, std::size_t strength, std::size_t nth);

Array world_array(Realm, std::size_t strength);
Array rule_array(Realm, std::size_t strength);  // on the worlds of world_array()

}  // namespace pelage::verify
