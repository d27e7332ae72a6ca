// See array_factors.hpp: which values may stand together.
#include "verify/array_factors.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace pelage::verify {

namespace {

// Of values that cannot stand together, or would hide what a case is there to show.
struct Exclusion {
    std::string_view factor, values, other, others;  // words between bars: "|a|b|"
};

constexpr std::string_view all_but_nothing = "!|nothing|";
constexpr std::string_view reactions = "!|change conc|change diff|set conc|set diff|map|polarize|divide|move|";
constexpr std::string_view reactions_of_models =
    "!|change conc|change diff|set conc|set diff|map|polarize|react by|divide|move|";

constexpr std::array exclusions{
    // There is no such thing.
    Exclusion{"stencil", "|published|", "boundary", "|absorbing|"},
    Exclusion{"stencil", "|published|", "growth", "!|none|"},
    Exclusion{"stencil", "|5x5|", "rates", "|directed|"},
    Exclusion{"path", "|shared|", "group", "|several|"},
    Exclusion{"path", "!|streamed|tiled|", "cut", "!|none|"},
    Exclusion{"path", "|streamed|tiled|", "cut", "|none|"},
    Exclusion{"path", "|streamed|", "items", "|several|"},
    Exclusion{"path", "|shared|", "search", "|sorting|"},
    Exclusion{"phases", "|none|", "when", "|phase|"},
    Exclusion{"towards", "!|none|", "field", "|far|"},
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
    Exclusion{"action", reactions, "amount", "!|nothing|number|conc|mapping|ITERATION|RANDOM|"},
    Exclusion{"action", reactions, "read", "!|nothing|number|conc|AGE|RANDOM|"},
    Exclusion{"stencil", "|moore|sims|", "rates", "|uneven|directed|"},
    Exclusion{"path", "|streamed|tiled|", "stencil", "|5x5|"},
    Exclusion{"path", "|streamed|tiled|", "chemicals", "|twenty|"},
    Exclusion{"path", "|streamed|tiled|", "precision", "|double|"},
    // What is not cut small shows the deepest passes, which nothing may break off.
    Exclusion{"cut", "|whole|", "growth", "!|none|"},
    Exclusion{"cut", "|whole|", "intervals", "|tested|"},
    // A model is one function for all paths: here a formula and what rules do to chemicals stand for it.
    Exclusion{"path", "|streamed|tiled|", "action", reactions_of_models},
    Exclusion{"search", "|bins|sorting|", "precision", "|double|"},
    // What is long to calculate and to compare is plain; what phases change is in the shorter programs.
    Exclusion{"stencil", "|twenty-seven-point|", "extent", "|many|"},
    Exclusion{"stencil", "|twenty-seven-point|", "phases", "|three|"},
    Exclusion{"network", "|drawn|", "extent", "|many|"},
    Exclusion{"boundary", "!|wrap|", "extent", "|many|"},
    Exclusion{"precision", "|double|", "extent", "|many|"},
    Exclusion{"rates", "!|uniform|", "extent", "|many|"},
    // More items or another precision are the same steps of an aggregate in a program that is long to compile.
    Exclusion{"items", "|eight|", "where", "!||"},
    Exclusion{"family", "!||", "precision", "|double|"},
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

}  // namespace

std::function<bool(const Choice&, const Choice&)> feasibility(Realm realm, std::size_t strength) {
    return [&may = table(realm, strength)](const Choice& a, const Choice& b) { return may.may(a, b); };
}

}  // namespace pelage::verify
