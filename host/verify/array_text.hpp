// Experiments of the generated table as text of the language, and the states that they start from.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"
#include "verify/array_factors.hpp"
#include "verify/cases.hpp"
#include "verify/seed.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pelage::verify {

// One experiment: a world and a size. Of free cells the size is that of a grid of hexagons; 0 rows: single cells. Of a
// sphere the columns say how often its triangles are cut.
struct GeneratedCase {
    const GeneratedWorld* made = nullptr;
    Realm realm = Realm::lattice;
    Size size;
    std::uint64_t seed = usual_seed;

    Values world() const { return {realm, made->world}; }
    // Of all its draws: another one for each seed, and beyond 32 bits.
    std::int64_t run_seed() const {
        return static_cast<std::int64_t>(seed - usual_seed - std::uint64_t{987'654'321'987'654'321});
    }
};

std::vector<Size> generated_sizes(const GeneratedWorld&, Realm);

std::string generated_text(const GeneratedCase&);

// That text, read, with what no text says: the weights of a network, and a mesh that is not made by rule.
Experiment generated_experiment(const GeneratedCase&, const std::string& text);

// Iterations from one comparison to the next: phases begin in the middle of one, and at the end of another.
std::vector<std::uint64_t> generated_strides(Size, Realm);

// Makes of the experiment's first state the one that the case starts from: at its iteration, with cells of many ages.
void set_stage(const GeneratedCase&, Snapshot&);

// ---- the parts of the text

// Chemicals in their order. A, B and W know no bounds, P, Q, R and S<n> react, D and E have their rates changed, G is
// never changed, F<n> are there to be many.
std::vector<std::string> generated_chemicals(const GeneratedCase&);

// The whole text for charges, which have another world and no other rules.
std::string charges_text(const GeneratedCase&);
Size charges_size(const GeneratedWorld&);

// The lines of the nth rule, first of all the `and` that it is joined to.
std::string generated_rule(const GeneratedCase&, std::size_t nth);

}  // namespace pelage::verify
