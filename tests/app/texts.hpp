// Experiments that the tests of the command run.
#pragma once

#include <string>

namespace test {

// 24 x 16 cells, 60 iterations, with random numbers during the run.
inline const std::string spots =
    "define chemical U limit 10\n"
    "define chemical V limit 10\n"
    "define time_step 0.01\n"
    "use seed 7\n"
    "use chemical U conc 4 dev 0.5 diff 10\n"
    "use chemical V conc 4 dev 0.5 diff 2\n"
    "create matrix 24 16 wrap\n"
    "rule always react U V turing alpha 16 beta 12\n"
    "rule probability 0.05 change V conc 0.1 dev 0.05\n"
    "stop at 60\n";

// The amount doubles with every iteration, in row 2 of 5 x 4 cells: 2^128 is no float.
inline const std::string doubling =
    "define chemical U\n"
    "use chemical U conc 1\n"
    "create matrix 5 4 no-flux\n"
    "rule if ROW == 2 change U conc U conc\n"
    "stop at 100000\n";

// Far beyond the explicit limit of dt = 2 / (rate * 16/3), but kept finite by its bounds.
inline const std::string unstable =
    "define chemical A limit 1\n"
    "define chemical B limit 1\n"
    "define time_step 0.5\n"
    "use chemical A conc 0.5 dev 0.5 diff 0.1\n"
    "use chemical B conc 0.5 dev 0.5 diff 3\n"
    "create matrix 8 8 wrap\n"
    "stop at 20\n";

}  // namespace test
