// See formula_cases.hpp.
#include "bench/formula_cases.hpp"

#include <fmt/format.h>

#include <array>

namespace pelage::bench {

namespace {

struct Pair {
    const char* name;
    const char* word;
    const char* formula;
    double flops;  // of a step, with 10 of the stencil and 2 of the bounds for each of two chemicals
};

constexpr std::array pairs{
    Pair{"turing-formula", "U V turing alpha 16 beta 12", "U by (16 - U * V) V by (U * V - V - 12)", 33},
    Pair{"gray-scott-formula", "U V gray-scott f 0.037 k 0.06",
         "U by (-U * V ^ 2 + 0.037 * (1 - U)) V by (U * V ^ 2 - (0.037 + 0.06) * V)", 37},
    Pair{"linear-formula", "U V linear au 0.5 bu -0.25 cu 1 du 0.25 mu 2 av 0.5 bv 0.25 cv 0 dv 0.5 mv 3",
         "U by (clamp(0.5 * U - 0.25 * V + 1, 0, 2) - 0.25 * U) V by (clamp(0.5 * U + 0.25 * V, 0, 3) - 0.5 * V)", 44},
    Pair{"gm1-formula", "U V gm1 a 0.1 b 0.5 c 0.25",
         "U by (0.1 - 0.5 * U + U ^ 2 / (V * (1 + 0.25 * U ^ 2))) V by (U ^ 2 - V)", 41},
    Pair{"cubic-formula", "U V cubic a 1 b 2 c 3", "U by ((U - 1) * (U - 2) * (U - 3))", 31},
    Pair{"reinforcement-formula", "U reinforcement threshold 3.5 width 0.5",
         "U by ((3.5 - 0.5 - U) * (3.5 - U) * (3.5 + 0.5 - U) * (3 * sqrt(3) / (2 * 0.5 ^ 2)))", 36}};

std::string text(std::size_t side, const char* reaction) {
    return fmt::format(
        "define chemical U limit 6\ndefine chemical V limit 6\ndefine time_step 0.01\nuse seed 7\n"
        "use chemical U conc 2 dev 0.75 diff 2\nuse chemical V conc 1 dev 0.25 diff 1\ncreate matrix {0} {0} wrap\n"
        "rule always react {1}\n",
        side, reaction);
}

}  // namespace

std::vector<Case> formula_cases() {
    std::vector<Case> cases;
    for (const Pair& pair : pairs) {
        Case one;
        one.suite = "formula";
        one.name = pair.name;
        one.sizes = {1024};
        one.quick_sizes = {24};
        one.text = [&pair](std::size_t side) { return text(side, pair.formula); };
        one.twin = [&pair](std::size_t side) { return text(side, pair.word); };
        one.cells = [](std::size_t side) { return side * side; };
        one.bytes = 16;
        one.flops = pair.flops;
        cases.push_back(one);
    }
    return cases;
}

}  // namespace pelage::bench
