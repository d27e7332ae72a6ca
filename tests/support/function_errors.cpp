// See function_errors.hpp.
#include "support/function_errors.hpp"

namespace test {

namespace {

template <class E>
E sigmoid(E x) {
    return 1 / (1 + std::exp(-x));
}

}  // namespace

#define PELAGE_ONE(name, bound)                                                                         \
    {                                                                                                   \
#name, bound, [](double x) { return std::name(x); }, [](long double x) { return std::name(x); } \
    }
#define PELAGE_TWO(name, bound)                                                                                      \
    {                                                                                                                \
#name, bound, [](double x, double y) { return std::name(x, y); },                                            \
                                                                       [](long double x,                             \
                                                                          long double y) { return std::name(x, y); } \
    }

const std::vector<OneArgument>& functions_of_one() {
    static const std::vector<OneArgument> functions{
        PELAGE_ONE(exp, 1),  PELAGE_ONE(log, 1),  PELAGE_ONE(sin, 1),
        PELAGE_ONE(cos, 1),  PELAGE_ONE(tan, 1),  PELAGE_ONE(asin, 1),
        PELAGE_ONE(acos, 1), PELAGE_ONE(atan, 1), PELAGE_ONE(sinh, 1),
        PELAGE_ONE(cosh, 1), PELAGE_ONE(tanh, 1), {"sigmoid", 1, sigmoid<double>, sigmoid<long double>}};
    return functions;
}

const std::vector<TwoArguments>& functions_of_two() {
    static const std::vector<TwoArguments> functions{PELAGE_TWO(pow, 1), PELAGE_TWO(atan2, 1), PELAGE_TWO(hypot, 1)};
    return functions;
}

}  // namespace test
