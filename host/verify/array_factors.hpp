// The factors of generated experiments, of lattices and of free cells: in what world rules act, and what rules do.
#pragma once

#include "verify/covering.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pelage::verify {

enum class Realm { lattice, cells };

// Factors of a world come first, then those of a rule.
const std::vector<Factor>& factors_of(Realm);
std::size_t world_factors(Realm);  // how many are the world's

bool feasible(Realm, std::size_t strength, const Choice&, const Choice&);

// The values of a row, by the names of factors.
class Values {
public:
    Values(Realm realm, const ArrayRow& row) : realm_(realm), row_(&row) {}
    const std::string& operator[](std::string_view factor) const;  // throws std::out_of_range
    Realm realm() const { return realm_; }

private:
    Realm realm_;
    const ArrayRow* row_;
};

struct GeneratedWorld {
    std::size_t number = 0;
    ArrayRow world;
    std::vector<ArrayRow> rules;  // whole rows: the world's values, then the rule's
};

// Worlds in which all pairs of values meet (strength 2), of the world, of rules, and between the two; or (3) all
// triples of settings of the world, and of parts of a rule that have few values together.
const std::vector<GeneratedWorld>& generated_worlds(Realm, std::size_t strength);

// How many there are, and their values, known without dealing out the rules.
std::size_t world_count(Realm, std::size_t strength);
const ArrayRow& world_row(Realm, std::size_t strength, std::size_t nth);

Array world_array(Realm, std::size_t strength);
Array rule_array(Realm, std::size_t strength);  // on the worlds of world_array()

}  // namespace pelage::verify
