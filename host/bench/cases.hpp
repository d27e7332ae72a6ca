// The cases of `pelage bench`: experiments of any size, and what one update of a cell costs at least.
#pragma once

#include "bench/options.hpp"
#include "core/experiment.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pelage::bench {

// A lattice step that the OpenMP baseline knows by heart.
struct Kernel {
    Model model = model_named("turing");
    bool wrap = true;
};

struct Case {
    std::string suite;
    std::string name;
    // A size is the side of a lattice, a volume or a torus, or a number of free cells, points or charges.
    std::vector<std::size_t> sizes, quick_sizes;
    bool by_default = true;                         // else only when asked for by name
    std::function<std::string(std::size_t)> text;   // in the experiment language; empty: points, no experiment
    std::function<void(Experiment&)> finish;        // what no text can say; or empty
    std::function<std::size_t(std::size_t)> cells;  // at that size, to begin with
    std::function<std::string(std::size_t)> twin;   // other contents, the same work: its time is a yardstick; or empty
    std::optional<Kernel> kernel;                   // lattices only
    std::size_t whole = 0;                          // iterations of a whole run that starts anew; 0: any stretch
    double bytes = 0;                               // that one update of a cell must move, once each
    double flops = 0;                               // of one update; a fma counts as two
    bool shuffled = false;                          // points without order
    bool particles = false;                         // a size is that of an aggregate that grows; one update is a charge
    bool far_field = false;                         // that aggregate interpolates what far charges add
};

const std::vector<Case>& all_cases();

// Those that the options name, in order.
std::vector<Case> chosen_cases(const Options&);

Experiment experiment_of(const Case&, std::size_t size);
Experiment twin_of(const Case&, std::size_t size);

}  // namespace pelage::bench
