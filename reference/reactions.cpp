// Chooses the model and the order of operations.
#include "reference/reactions.hpp"

#include "reference/models/cubic.hpp"
#include "reference/models/gm1.hpp"
#include "reference/models/gray_scott.hpp"
#include "reference/models/linear.hpp"
#include "reference/models/reinforcement.hpp"
#include "reference/models/turing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pelage::reference {

namespace {

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

template <class T>
class Reaction {
public:
    Reaction(const React& react, Sight<T>& sight, State<T>& next, const std::vector<std::uint8_t>& truth)
        : react_(react), sight_(sight), next_(next), truth_(truth), scale_(sight.column(react.scale)) {
        parameters_.reserve(react.parameters.size());
        for (const Operand& operand : react.parameters) parameters_.push_back(sight.column(operand));
    }

    // Calls add(cell, scale, parameters) for the cells that react; apart where all of them share their parameters,
    // which the compiler can turn into vector code.
    template <class Add>
    void each(Add&& add) const {
        const auto constant = [](const Column<T>& column) { return column.constant(); };
        const bool all = std::all_of(truth_.begin(), truth_.end(), [](auto t) { return t != 0; });
        if (all && scale_.constant() && std::all_of(parameters_.begin(), parameters_.end(), constant)) {
            const auto shared = parameters_at(0);
            const T scale = scale_[0];
            for (std::size_t cell = 0; cell < truth_.size(); ++cell) add(cell, scale, shared);
            return;
        }
        for (std::size_t cell = 0; cell < truth_.size(); ++cell) {
            if (truth_[cell] != 0) add(cell, scale_[cell], parameters_at(cell));
        }
    }

    template <class Model, class Sum>
    void pair(Sum sum) const {
        const T* u = sight_.old.conc[react_.u].data();
        const T* v = sight_.old.conc[react_.v].data();
        T* new_u = next_.conc[react_.u].data();
        T* new_v = next_.conc[react_.v].data();
        each([=](std::size_t cell, T scale, const auto& p) {
            const Flow<T> flow = Model::flow(u[cell], v[cell], p);
            new_u[cell] = sum.add(new_u[cell], scale, flow.u);
            new_v[cell] = sum.add(new_v[cell], scale, flow.v);
        });
    }

    template <class Model, class Sum>
    void single(Sum sum) const {
        const T* u = sight_.old.conc[react_.u].data();
        T* new_u = next_.conc[react_.u].data();
        each([=](std::size_t cell, T scale, const auto& p) {
            new_u[cell] = sum.add(new_u[cell], scale, Model::flow(u[cell], p));
        });
    }

    void published_cubic(T dt) const {
        const T* u = sight_.old.conc[react_.u].data();
        T* new_u = next_.conc[react_.u].data();
        each([=](std::size_t cell, T scale, const auto& p) {
            new_u[cell] = new_u[cell] + Cubic::scaled_flow(scale, u[cell], p) * dt;
        });
    }

private:
    std::array<T, 10> parameters_at(std::size_t cell) const {
        std::array<T, 10> values{};
        for (std::size_t i = 0; i < parameters_.size(); ++i) values[i] = parameters_[i][cell];
        return values;
    }

    const React& react_;
    Sight<T>& sight_;
    State<T>& next_;
    const std::vector<std::uint8_t>& truth_;
    Column<T> scale_;
    std::vector<Column<T>> parameters_;
};

template <class T, class Sum>
void run(const Reaction<T>& reaction, Model model, Sum sum) {
    constexpr bool published = std::is_same_v<Sum, Published<T>>;
    switch (model) {
        case Model::turing:
            reaction.template pair<Turing>(sum);
            break;
        case Model::gray_scott:
            reaction.template pair<std::conditional_t<published, GrayScott, FusedGrayScott>>(sum);
            break;
        case Model::linear:
            reaction.template pair<Linear>(sum);
            break;
        case Model::gm1:
            reaction.template pair<Gm1>(sum);
            break;
        case Model::cubic:
            if constexpr (published) {
                reaction.published_cubic(sum.dt);
            } else {
                reaction.template single<Cubic>(sum);
            }
            break;
        case Model::reinforcement:
            reaction.template single<Reinforcement>(sum);
            break;
    }
}

}  // namespace

template <class T>
void react_cells(const React& react, Arithmetic arithmetic, T dt, Sight<T>& sight, State<T>& next,
                 const std::vector<std::uint8_t>& truth) {
    if (truth.empty()) return;
    const Reaction<T> reaction(react, sight, next, truth);
    if (arithmetic == Arithmetic::published) {
        run(reaction, react.model, Published<T>{dt});
    } else {
        run(reaction, react.model, Fused<T>{dt});
    }
}

template void react_cells(const React&, Arithmetic, float, Sight<float>&, State<float>&,
                          const std::vector<std::uint8_t>&);
template void react_cells(const React&, Arithmetic, double, Sight<double>&, State<double>&,
                          const std::vector<std::uint8_t>&);

}  // namespace pelage::reference
