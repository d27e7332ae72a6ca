// See array_factors.hpp: the tables.
#include "verify/array_factors.hpp"

#include "core/models.hpp"

#include <stdexcept>

namespace pelage::verify {

namespace {

// Of the course of a run, in every kind of tissue whose cells have rules.
std::vector<Factor> courses(const std::vector<std::string>& starts) {
    return {{"phases", {"none", "three"}},
            {"intervals", {"tested", "compiled"}},
            {"start", starts},
            {"precision", {"float", "double"}},
            {"ends", {"free", "bounded"}}};
}

std::vector<Factor> joined(std::vector<Factor> first, const std::vector<Factor>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

std::vector<Factor> lattice_worlds() {
    return {{"stencil", {"nine-point", "moore", "five-point", "sims", "3x3", "5x5", "published"}},
            {"boundary", {"no-flux", "wrap", "absorbing"}},
            {"path", {"step", "shared", "streamed", "tiled"}},
            {"width", {"1", "own", "other"}},
            {"group", {"one", "several"}},
            {"cut", {"whole", "small", "none"}},
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
    return joined({{"path", {"step", "shared"}},
                   {"width", {"own", "1", "other"}},
                   {"group", {"one", "several"}},
                   {"search", {"bins", "sorting"}},
                   {"domain", {"wide", "narrow", "packed"}},
                   {"limit", {"none", "4"}},
                   {"mirrors", {"none", "pairs"}},
                   {"sizes", {"tissue", "several"}},
                   {"rates", {"uniform", "uneven", "changing"}}},
                  courses({"0", "65530", "4294967200"}));
}

std::vector<Factor> volume_worlds() {
    return joined({{"stencil", {"seven-point", "twenty-seven-point"}},
                   {"boundary", {"no-flux", "wrap", "absorbing"}},
                   {"path", {"step", "streamed"}},
                   {"width", {"1", "own"}},
                   {"items", {"one", "several"}},
                   {"cut", {"whole", "small", "none"}},
                   {"extent", {"several", "many"}},
                   {"rates", {"uniform", "uneven", "changing"}},
                   {"network", {"none", "drawn"}}},
                  courses({"0", "4294967200"}));
}

std::vector<Factor> mesh_worlds() {
    return joined({{"shape", {"icosphere", "torus", "odd"}},
                   {"weights", {"uniform", "cotangent"}},
                   {"width", {"own", "1", "other"}},
                   {"group", {"usual", "several"}},
                   {"rates", {"uniform", "uneven", "changing"}},
                   {"network", {"none", "drawn"}}},
                  courses({"0", "4294967200"}));
}

std::vector<Factor> charge_worlds() {
    return {{"path", {"step", "shared"}},
            {"items", {"usual", "eight"}},
            {"sizes", {"narrow", "wide", "full"}},
            {"eta", {"0", "number", "expression"}},
            {"radius", {"number", "expression"}},
            {"towards", {"none", "number", "expression"}},
            {"field", {"exact", "far"}},
            {"where", {"everywhere", "walls", "grains"}},
            {"seeds", {"few", "line"}},
            {"family", {"none", "counted", "given"}},
            {"charges", {"alike", "number", "expression"}},
            {"when", {"always", "every", "phases"}},
            {"start", {"0", "4294966000"}},
            {"precision", {"float", "double"}},
            {"at", {"middle", "elsewhere"}}};
}

// What rules read and take.
std::vector<std::string> quantity_levels(Realm realm) {
    std::vector<std::string> words{"number", "conc",      "diff",      "mapping", "X",    "Y",         "AGE",
                                   "BIRTH",  "ITERATION", "NEIGHBORS", "RANDOM",  "TIME", "expression"};
    const bool grid = realm == Realm::lattice || realm == Realm::volume;
    if (grid) words.insert(words.end(), {"ROW", "COLUMN", "ROWS", "COLUMNS"});
    if (realm != Realm::cells) words.emplace_back("around");
    if (realm == Realm::volume || realm == Realm::mesh) words.emplace_back("Z");
    if (realm == Realm::volume) words.insert(words.end(), {"LAYER", "LAYERS"});
    return words;
}

std::vector<std::string> actions_of(Realm realm) {
    std::vector<std::string> words{"change conc", "change diff", "set conc", "set diff", "map"};
    const bool plane = realm == Realm::lattice || realm == Realm::cells;
    if (plane) words.emplace_back("polarize");
    words.emplace_back("react by");
    if (realm == Realm::cells) words.insert(words.end(), {"divide", "move"});
    for (const ModelFacts& model : model_table()) words.push_back("react " + model.word);
    return words;
}

std::vector<Factor> rules_of(Realm realm) {
    if (!has_rules(realm)) return {};
    const std::vector<std::string> quantities = quantity_levels(realm);
    std::vector<std::string> or_nothing = quantities;
    or_nothing.insert(or_nothing.begin(), "nothing");
    const bool plane = realm == Realm::lattice || realm == Realm::cells;  // `polarize` takes nothing
    return {{"action", actions_of(realm)},
            {"amount", plane ? or_nothing : quantities},
            {"condition", {"always", "==", "!=", "<", "<=", ">", ">=", "in", "probability"}},
            {"read", or_nothing},
            {"against", {"nothing", "number", "alike", "other"}},
            {"target", {"first", "middle", "last"}},
            {"when", {"always", "interval", "every", "offset", "phase"}},
            {"deviation", {"no", "yes"}},
            {"joined", {"no", "and"}}};
}

std::vector<Factor> worlds_of(Realm realm) {
    if (realm == Realm::lattice) return lattice_worlds();
    if (realm == Realm::cells) return cell_worlds();
    if (realm == Realm::volume) return volume_worlds();
    return realm == Realm::mesh ? mesh_worlds() : charge_worlds();
}

struct Tables {
    std::array<std::vector<Factor>, every_realm.size()> factors;
    std::array<std::size_t, every_realm.size()> of_world{};
};

const Tables& tables() {
    static const Tables all = [] {
        Tables made;
        for (std::size_t i = 0; i < every_realm.size(); ++i) {
            made.factors[i] = worlds_of(every_realm[i]);
            made.of_world[i] = made.factors[i].size();
            made.factors[i] = joined(made.factors[i], rules_of(every_realm[i]));
        }
        return made;
    }();
    return all;
}

}  // namespace

const char* word(Realm realm) {
    static constexpr std::array words{"lattice", "cells", "volume", "mesh", "charges"};
    return words[static_cast<std::size_t>(realm)];
}

std::size_t world_factors(Realm realm) { return tables().of_world[static_cast<std::size_t>(realm)]; }

const std::vector<Factor>& factors_of(Realm realm) { return tables().factors[static_cast<std::size_t>(realm)]; }

const std::string* Values::find(std::string_view factor) const {
    const std::vector<Factor>& factors = factors_of(realm_);
    for (std::size_t i = 0; i < row_->size(); ++i) {
        if (factors[i].name == factor) return &factors[i].values[(*row_)[i]];
    }
    return nullptr;
}

const std::string& Values::operator[](std::string_view factor) const {
    const std::string* const value = find(factor);
    if (value == nullptr) throw std::out_of_range("no factor is named " + std::string(factor));
    return *value;
}

bool Values::has(std::string_view factor, std::string_view value) const {
    const std::string* const found = find(factor);
    return found != nullptr && *found == value;
}

}  // namespace pelage::verify
