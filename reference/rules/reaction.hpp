// A rule's reaction, carried out by a model of the reference (see flow.hpp) in the tissue's order of operations.
#pragma once

#include "core/error.hpp"
#include "core/experiment.hpp"
#include "reference/rules/operands.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace pelage::reference {

template <class T>
struct Published {
    T dt;
    T add(T value, T scale, T flow) const { return value + ((scale * flow) * dt); }
};

template <class T>
struct Fused {
    T dt;
    T add(T value, T scale, T flow) const { return std::fma(scale * dt, flow, value); }
};

template <class T, class M>
using Parameters = std::array<T, M::parameters>;

template <class M, class T>
concept FusedApart = requires {
    &M::template fused_flow<T, Parameters<T, M>>;
};
template <class M, class T>
concept ScaledApart = requires {
    &M::template scaled_flow<T, Parameters<T, M>>;
};

// The new value of one species after another, for one cell.
template <class M, class T, class Next>
void step(const Published<T>& sum, T scale, const std::array<T, M::species>& old, const Parameters<T, M>& p,
          const Next& next) {
    std::apply(
        [&](auto... species) {
            if constexpr (ScaledApart<M, T>) {
                const auto scaled = M::scaled_flow(scale, species..., p);
                for (std::size_t i = 0; i < scaled.size(); ++i) next(i) = next(i) + scaled[i] * sum.dt;
            } else {
                const auto flow = M::flow(species..., p);
                for (std::size_t i = 0; i < flow.size(); ++i) next(i) = sum.add(next(i), scale, flow[i]);
            }
        },
        old);
}

template <class M, class T, class Next>
void step(const Fused<T>& sum, T scale, const std::array<T, M::species>& old, const Parameters<T, M>& p,
          const Next& next) {
    const auto add = [&](const auto& flow) {
        for (std::size_t i = 0; i < flow.size(); ++i) next(i) = sum.add(next(i), scale, flow[i]);
    };
    std::apply(
        [&](auto... species) {
            if constexpr (FusedApart<M, T>) {
                add(M::fused_flow(species..., p));
            } else {
                add(M::flow(species..., p));
            }
        },
        old);
}

template <class T>
class Reaction {
public:
    Reaction(const React& react, Sight<T>& sight, State<T>& next, const std::vector<std::uint8_t>& truth)
        : react_(react), sight_(sight), next_(next), truth_(truth), scale_(sight.column(react.scale)) {
        parameters_.reserve(react.parameters.size());
        for (const Operand& operand : react.parameters) parameters_.push_back(sight.column(operand));
    }

    // Throws Error unless the rule gives as many chemicals and parameters as M takes.
    template <class M, class Sum>
    void run(Sum sum) const {
        if (react_.species.size() != M::species || parameters_.size() != M::parameters)
            throw Error(std::string(M::word) + " is given other chemicals or parameters than it takes");
        std::array<const T*, M::species> old{};
        std::array<T*, M::species> next{};
        for (std::size_t i = 0; i < M::species; ++i) {
            old[i] = sight_.old.conc[react_.species[i]].data();
            next[i] = next_.conc[react_.species[i]].data();
        }
        each<M>([=](std::size_t cell, T scale, const Parameters<T, M>& p) {
            std::array<T, M::species> values{};
            for (std::size_t i = 0; i < M::species; ++i) values[i] = old[i][cell];
            step<M>(sum, scale, values, p, [&](std::size_t i) -> T& { return next[i][cell]; });
        });
    }

private:
    // Calls add(cell, scale, parameters) for the cells that react; apart where all of them share their parameters,
    // which the compiler can turn into vector code.
    template <class M, class Add>
    void each(Add&& add) const {
        const auto constant = [](const Column<T>& column) { return column.constant(); };
        const bool all = std::all_of(truth_.begin(), truth_.end(), [](auto t) { return t != 0; });
        if (all && scale_.constant() && std::all_of(parameters_.begin(), parameters_.end(), constant)) {
            const auto shared = parameters_at<M>(0);
            const T scale = scale_[0];
            for (std::size_t cell = 0; cell < truth_.size(); ++cell) add(cell, scale, shared);
            return;
        }
        for (std::size_t cell = 0; cell < truth_.size(); ++cell) {
            if (truth_[cell] != 0) add(cell, scale_[cell], parameters_at<M>(cell));
        }
    }

    template <class M>
    Parameters<T, M> parameters_at(std::size_t cell) const {
        Parameters<T, M> values{};
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = parameters_[i][cell];
        return values;
    }

    const React& react_;
    Sight<T>& sight_;
    State<T>& next_;
    const std::vector<std::uint8_t>& truth_;
    Column<T> scale_;
    std::vector<Column<T>> parameters_;
};

}  // namespace pelage::reference
