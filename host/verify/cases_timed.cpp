// Formulas that have one value in all cells, and another in every iteration: kernels compute them once for all. And
// what stays as it is while other things change: fields, counts of neighbours, a mapping beside one that is written.
#include "language/parse.hpp"
#include "verify/cases.hpp"

#include <fmt/format.h>

namespace pelage::verify {

namespace {

Experiment timed(const std::string& create, const std::string& name) {
    return parse_experiment(
        "define chemical A floor none\ndefine chemical B floor none\ndefine time_step 0.25\n"
        "use seed 11\nuse chemical A conc 2 dev 1 diff 0.2\nuse chemical B conc 2 dev 1 diff 0.1\n" +
            create +
            "\nphase \"first\" 9\n"
            "rule always react A by (0.1 * sin(0.7 * ITERATION) * B) B by (cos(TIME) * 0.05 - 0.01 * B)\n"
            "rule if (sin(ITERATION) > 0.25 or ITERATION == 5) change A conc 0.125\n"
            "phase \"second\" 100\ndefine time_step 0.125\nuse chemical A diff 0.3\n"
            "rule if (ITERATION >= 12 and B > 2) set B conc (1 + exp(-TIME))\n",
        name, ".");
}

// A mapping is written until nobody reads it, while another one is. Cells turn, though no rate has a direction. One
// chemical stays as it is until a phase narrows its bounds, and is read.
Experiment keeping(Size size) {
    return parse_experiment(
        fmt::format(
            "define chemical A limit 6 floor none\ndefine chemical B floor none\ndefine chemical C limit 2.75\n"
            "define time_step 0.25\nuse seed 5\n"
            "define field drawn (0.5 + RANDOM)\ndefine field ramp (0.25 * sin(0.7 * COLUMN))\n"
            "use chemical A conc 2 dev 1 diff 0.2\nuse chemical B conc 2 dev 1 diff 0.1\nuse chemical C conc 2 dev 1\n"
            "create matrix {} {}\nphase \"first\" 5\n"
            "rule always map A conc 0 5 to M 0.25 1\nrule always map B conc 0 5 to N 1 0.5\n"
            "rule always react A by (0.1 * M * drawn - 0.02 * A) B by (0.05 * N * NEIGHBORS)\n"
            "rule always polarize B conc\n"
            "phase \"second\" 100\ndefine chemical C limit 2.25 floor 1.5\nrule always map B conc 0 5 to N 2 1\n"
            "rule always react A by (0.1 * ramp - 0.02 * A + 0.05 * C) B by (0.05 * N * drawn - 0.01 * B)\n"
            "rule always react B by (0.03 * gradient_x(A) - 0.05 * gradient_y(A))\n"
            "rule if NEIGHBORS < 8 change B conc (0.02 * AGE)\n"
            "rule every 3 offset 4294967295 always change A conc 1\n",  // from the phase's begin: never
            size.columns, size.rows),
        "rules/keeping", ".");
}

std::string of_a_matrix(Size size) { return fmt::format("create matrix {} {} wrap", size.columns, size.rows); }

std::string of_a_grid(Size size) { return fmt::format("create sqr_grid {} {}", size.columns, size.rows); }

std::string of_a_volume(Size size) {
    return fmt::format("create volume {} {} {} wrap", size.columns, size.rows, size.layers);
}

}  // namespace

std::vector<Case> timed_cases() {
    const std::vector<Size> flat{{3, 2}, {20, 9}, {67, 31}};
    const std::vector<Size> deep{{4, 3, 5}, {18, 9, 11}};
    const auto make = [](const char* name, std::string (*create)(Size), const std::vector<Size>& sizes) {
        return Case{.name = name,
                    .experiment = [=](Size size) { return timed(create(size), name); },
                    .sizes = sizes,
                    .iterations = 40};
    };
    return {make("rules/timed/fused", of_a_matrix, flat), make("rules/timed/published", of_a_grid, flat),
            make("volume/timed/wrap", of_a_volume, deep),
            Case{.name = "rules/keeping/fused", .experiment = keeping, .sizes = flat, .iterations = 40}};
}

}  // namespace pelage::verify
