// See neural.hpp.
#include "reference/rules/neural.hpp"

#include "core/subnormal.hpp"
#include "reference/common/with_fma.hpp"
#include "reference/functions/quick_sigmoid.hpp"

#include <algorithm>
#include <cmath>

namespace pelage::reference {

namespace {

template <class T>
struct Weights {  // in the precision of the run
    explicit Weights(const Network& network)
        : chemicals(network.chemicals),
          hidden(network.hidden),
          first(rounded(network.first)),
          bias(rounded(network.bias)),
          second(rounded(network.second)) {}

    static std::vector<T> rounded(const std::vector<double>& values) {
        std::vector<T> all;
        for (const double value : values) all.push_back(in_precision<T>(value));
        return all;
    }

    std::size_t chemicals, hidden;
    std::vector<T> first, bias, second;
};

template <class T>
PELAGE_INLINE void add_row(std::size_t count, T factor, const T* row, T* sums) {
    for (std::size_t i = 0; i < count; ++i) sums[i] = std::fma(factor, row[i], sums[i]);
}

template <class T>
PELAGE_INLINE void ask_cells(const Weights<T>& w, const std::vector<const T*>& x, std::size_t cells,
                             std::vector<std::vector<T>>& f) {
    std::vector<T> hidden(w.hidden), sums(w.chemicals);
    for (std::size_t cell = 0; cell < cells; ++cell) {
        std::copy(w.bias.begin(), w.bias.end(), hidden.begin());
        for (std::size_t i = 0; i < w.chemicals; ++i)
            add_row(w.hidden, x[i][cell], w.first.data() + i * w.hidden, hidden.data());
        std::fill(sums.begin(), sums.end(), T(0));
        for (std::size_t h = 0; h < w.hidden; ++h) {
            const T z = hidden[h];
            const T a = z * functions::quick_sigmoid(T(5) * z);
            add_row(w.chemicals, a, w.second.data() + h * w.chemicals, sums.data());
        }
        for (std::size_t i = 0; i < w.chemicals; ++i) f[i][cell] = sums[i];
    }
}

#ifdef PELAGE_WITH_FMA
template <class T>
PELAGE_WITH_FMA void ask_with_fma(const Weights<T>& w, const std::vector<const T*>& x, std::size_t cells,
                                  std::vector<std::vector<T>>& f) {
    ask_cells(w, x, cells, f);
}
#endif

}  // namespace

template <class T>
std::vector<std::vector<T>> ask(const Network& network, const std::vector<const T*>& x, std::size_t cells) {
    const Weights<T> weights(network);
    std::vector<std::vector<T>> f(network.chemicals, std::vector<T>(cells));
#ifdef PELAGE_WITH_FMA
    if (runs_with_fma()) {
        ask_with_fma(weights, x, cells, f);
        return f;
    }
#endif
    ask_cells(weights, x, cells, f);
    return f;
}

template std::vector<std::vector<float>> ask(const Network&, const std::vector<const float*>&, std::size_t);
template std::vector<std::vector<double>> ask(const Network&, const std::vector<const double*>&, std::size_t);

}  // namespace pelage::reference
