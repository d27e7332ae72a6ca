// Visits a variant with one function a kind: std::visit(Overloaded{[](A) {...}, [](B) {...}}, value). A kind without a
// function does not compile.
#pragma once

namespace pelage {

template <class... Functions>
struct Overloaded : Functions... {
    using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;  // clang 14 does not deduce aggregates by itself

}  // namespace pelage
