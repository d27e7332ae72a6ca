// Finds the model of a rule's reaction.
#include "reference/rules/reactions.hpp"

#include "core/error.hpp"
#include "reference/rules/reaction.hpp"
#include "reference_models.hpp"

#include <type_traits>

namespace pelage::reference {

namespace {

// Runs M where it is the reaction's model, and says whether it was.
template <class M, class T, class Sum>
bool run_if(const React& react, const Reaction<T>& reaction, Sum sum) {
    if (react.model.facts().word != M::word) return false;
    reaction.template run<M>(sum);
    return true;
}

template <class... Each, class T, class Sum>
void run(std::type_identity<std::tuple<Each...>>, const React& react, const Reaction<T>& reaction, Sum sum) {
    const bool found = (run_if<Each>(react, reaction, sum) || ...);
    if (!found) throw Error("the reference has no reaction " + react.model.facts().word);
}

}  // namespace

template <class T>
void react_cells(const React& react, Arithmetic arithmetic, T dt, Sight<T>& sight, State<T>& next,
                 const std::vector<std::uint8_t>& truth) {
    if (truth.empty()) return;
    const Reaction<T> reaction(react, sight, next, truth);
    if (arithmetic == Arithmetic::published) {
        run(std::type_identity<Models>{}, react, reaction, Published<T>{dt});
    } else {
        run(std::type_identity<Models>{}, react, reaction, Fused<T>{dt});
    }
}

template void react_cells(const React&, Arithmetic, float, Sight<float>&, State<float>&,
                          const std::vector<std::uint8_t>&);
template void react_cells(const React&, Arithmetic, double, Sight<double>&, State<double>&,
                          const std::vector<std::uint8_t>&);

}  // namespace pelage::reference
