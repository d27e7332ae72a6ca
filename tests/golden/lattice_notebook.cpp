// See lattice_notebook.hpp.
#include "lattice_notebook.hpp"
#include "core/growable.hpp"

#include "support/shared.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <limits>

namespace test {

using namespace pelage;

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

Boundary boundary(const nlohmann::json& p) { return p.at("wrap") ? Boundary::wrap : Boundary::no_flux; }

}  // namespace

double tolerance(std::uint64_t steps) { return steps <= 1 ? 1e-12 : steps <= 10 ? 1e-11 : 1e-9; }

Notebook::Notebook(std::string name) : name_(std::move(name)) {
    std::ifstream file(shared("golden/leopard_2020/" + name_ + ".base.json"));
    json_ = nlohmann::json::parse(file);
}

NpyArray Notebook::array(const std::string& key) const { return golden("leopard_2020/" + name_ + "/" + key); }

Experiment Notebook::turing(const std::string& part, const std::vector<std::size_t>& shape) const {
    const nlohmann::json& p = parameters(part);
    Experiment experiment = matrix(
        shape[1], shape[0], boundary(p), Stencil::nine_point, p.at("delta_t"),
        {{"a", p.at("diff_a"), {p.at("inf_a"), p.at("sup_a")}}, {"b", p.at("diff_b"), {p.at("inf_b"), p.at("sup_b")}}});
    const auto number = [](double value) { return Operand::number(value); };
    experiment.rules = {always(React{model_named("turing"), {0, 1}, number(1), {number(16), number(12)}})};
    return experiment;
}

Experiment Notebook::reinforcement(const std::string& part, const std::vector<std::size_t>& shape) const {
    const nlohmann::json& p = parameters(part);
    Experiment experiment = matrix(shape[1], shape[0], boundary(p), Stencil::nine_point, p.at("delta_t"),
                                   {{"c", p.at("diff_c"), {-no_limit, no_limit}}});
    const auto number = [&](const char* key) { return Operand::number(p.at(key)); };
    experiment.rules = {
        always(React{model_named("reinforcement"), {0}, Operand::number(1), {number("threshold"), number("width")}})};
    return experiment;
}

void Notebook::check(const Tissue& tissue, const std::string& part, const std::string& at, double allowed) const {
    const Snapshot now = tissue.read();
    double range = 0.0;  // of a flat field nothing is learnt
    for (std::size_t chemical = 0; chemical < now.conc.size(); ++chemical) {
        const std::string key = part + "." + tissue.experiment().chemicals[chemical].name + at;
        INFO(name_ << " " << key);
        const NpyArray wanted = array(key);
        REQUIRE(wanted.shape == std::vector<std::size_t>{now.rows, now.columns});
        const Difference difference = test::difference(now.conc[chemical], wanted.values);
        range = std::max(range, difference.range);
        const double rounding = 8 * std::numeric_limits<double>::epsilon() * difference.magnitude;
        CHECK(difference.largest <= std::max(allowed * difference.range, rounding));
    }
    CHECK(range > 0.0);
}

void Notebook::check_steps(Tissue& tissue, const std::string& part, const Steps& steps) const {
    for (const std::uint64_t at : steps) {
        tissue.advance(at - tissue.iteration());
        check(tissue, part, std::to_string(at), tolerance(at));
    }
}

void Notebook::check_end(Tissue& tissue, const std::string& part) const {
    tissue.advance(steps(part) - tissue.iteration());
    check(tissue, part, "_end", 1e-3);
}

void Growth::advance(Tissue& tissue, std::uint64_t iteration) {
    while (tissue.iteration() < iteration) {
        if (tissue.iteration() % period_ == 0) {
            insert(tissue, order_ == Order::column_first);
            insert(tissue, order_ == Order::row_first);
        }
        const std::uint64_t next = (tissue.iteration() / period_ + 1) * period_;
        tissue.advance(std::min(next, iteration) - tissue.iteration());
    }
}

void Growth::check_steps(const Notebook& notebook, Tissue& tissue, const std::string& part, const Steps& steps) {
    for (const std::uint64_t at : steps) {
        advance(tissue, at);
        notebook.check(tissue, part, std::to_string(at), tolerance(at));
    }
}

void Growth::insert(Tissue& tissue, bool column) {
    Insertion insertion{column, {}};
    for (std::size_t line = 0; line < (column ? tissue.rows() : tissue.columns()); ++line) {
        insertion.picks.push_back(static_cast<std::uint32_t>(picks_.at(next_++)));
    }
    growable(tissue).expand(insertion);
}

}  // namespace test
