// See functions.hpp; the list of functions is made by cmake/WriteFunctions.cmake.
#include "reference/rules/functions.hpp"

#include "core/functions.hpp"
#include "reference_functions.hpp"

#include <array>
#include <utility>

namespace pelage::reference {

namespace {

template <class T, class Function>
void over_columns(const T* const* columns, std::size_t count, T* out) {
    for (std::size_t i = 0; i < count; ++i) {
        std::array<T, Function::parameters> arguments;
        for (std::size_t place = 0; place < Function::parameters; ++place) arguments[place] = columns[place][i];
        out[i] = Function::template of<T>(arguments.data());
    }
}

template <class T, class List>
struct Entries;

template <class T, class... Function>
struct Entries<T, std::tuple<Function...>> {
    static constexpr std::array<T (*)(const T*), sizeof...(Function)> one{&Function::template of<T>...};
    static constexpr std::array<void (*)(const T* const*, std::size_t, T*), sizeof...(Function)> column{
        &over_columns<T, Function>...};
};

}  // namespace

template <class T>
T apply_function(std::size_t index, const T* arguments) {
    return Entries<T, Functions>::one.at(index)(arguments);
}

template float apply_function(std::size_t, const float*);
template double apply_function(std::size_t, const double*);

}  // namespace pelage::reference

namespace pelage {

template <class T>
void compute_function(std::size_t index, const T* const* columns, std::size_t count, T* out) {
    reference::Entries<T, reference::Functions>::column.at(index)(columns, count, out);
}

template void compute_function(std::size_t, const float* const*, std::size_t, float*);
template void compute_function(std::size_t, const double* const*, std::size_t, double*);

}  // namespace pelage
