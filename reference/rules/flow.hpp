// What a reaction model returns: the rates of change of the species that it changes, in order. A model is one file in
// reference/models. x_y.hpp defines a struct XY with
//   word        in the language
//   species     how many concentrations flow() takes
//   parameters  how many entries p has, in the order of ModelFacts::parameters
//   flow(species..., p)
// written with the parenthesisation that all backends share. Where a matrix takes the same formula in another order of
// operations (fma), that is fused_flow(species..., p); where the published program multiplies by the scale within the
// formula, that is scaled_flow(scale, species..., p).
#pragma once

#include <array>
#include <cstddef>

namespace pelage::reference {

template <class T, std::size_t Changed>
using Flow = std::array<T, Changed>;

}  // namespace pelage::reference
