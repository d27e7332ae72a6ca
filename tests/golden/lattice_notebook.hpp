// The 2020 notebooks' golden arrays, the experiments they came from, and their growth.
#pragma once

#include "lattice_support.hpp"

#include <nlohmann/json.hpp>

namespace test {

using Steps = std::vector<std::uint64_t>;

// Share of the golden range by which rounding may have grown apart: the notebooks add in another order.
double tolerance(std::uint64_t steps);

class Notebook {  // one folder of golden/leopard_2020; a part is a stretch of its run
public:
    explicit Notebook(std::string name);

    pelage::NpyArray array(const std::string& key) const;
    std::uint64_t steps(const std::string& part) const { return json_.at(part + ".steps"); }

    pelage::Experiment turing(const std::string& part, const std::vector<std::size_t>& shape) const;
    pelage::Experiment reinforcement(const std::string& part, const std::vector<std::size_t>& shape) const;

    // The tissue against the arrays of `part` named after its chemicals and `at`.
    void check(const pelage::Tissue&, const std::string& part, const std::string& at, double allowed) const;
    void check_steps(pelage::Tissue&, const std::string& part, const Steps&) const;
    void check_end(pelage::Tissue&, const std::string& part) const;

private:
    const nlohmann::json& parameters(const std::string& part) const { return json_.at(part + ".par"); }

    std::string name_;
    nlohmann::json json_;
};

enum class Order { column_first, row_first };  // of the two insertions of an expansion

// Feeds the notebook's own duplicated indices to the tissue, on the first iteration of a part and every `period`-th.
class Growth {
public:
    Growth(const pelage::NpyArray& picks, Order order, std::uint64_t period)
        : picks_(picks.values), order_(order), period_(period) {}

    void advance(pelage::Tissue&, std::uint64_t iteration);
    void check_steps(const Notebook&, pelage::Tissue&, const std::string& part, const Steps&);
    bool used_up() const { return next_ == picks_.size(); }

private:
    void insert(pelage::Tissue&, bool column);

    std::vector<double> picks_;
    Order order_;
    std::uint64_t period_;
    std::size_t next_ = 0;
};

}  // namespace test
