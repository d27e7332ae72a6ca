// What a reaction model returns. Every model takes the two concentrations and its parameters p, in the order of
// parameter_names(), and is written with the parenthesisation that all backends share.
#pragma once

namespace pelage::reference {

template <class T>
struct Flow {  // du/dt and dv/dt
    T u;
    T v;
};

}  // namespace pelage::reference
