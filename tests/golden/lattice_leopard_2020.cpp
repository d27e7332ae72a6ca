// The 2020 notebooks' own results ("The leopard never changes its spots") against the double reference.
#include "lattice_support.hpp"
#include "support/shared.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <limits>
#include <random>

namespace {

using namespace pelage;

constexpr double no_limit = std::numeric_limits<double>::infinity();

// Share of the golden range by which rounding may have grown apart: the notebooks add in another order.
double tolerance(std::uint64_t steps) { return steps <= 1 ? 1e-12 : steps <= 10 ? 1e-11 : 1e-9; }

class Notebook {
public:
    explicit Notebook(std::string name) : name_(std::move(name)) {
        std::ifstream file(test::shared("golden/leopard_2020/" + name_ + ".base.json"));
        json_ = nlohmann::json::parse(file);
    }

    NpyArray array(const std::string& key) const { return test::golden("leopard_2020/" + name_ + "/" + key); }
    std::uint64_t steps(const std::string& part) const { return json_.at(part + ".steps"); }
    const nlohmann::json& parameters(const std::string& part) const { return json_.at(part + ".par"); }

    Experiment turing(const std::string& part, const std::vector<std::size_t>& shape) const {
        const nlohmann::json& p = parameters(part);
        Experiment experiment = test::matrix(shape[1], shape[0], boundary(p), Stencil::nine_point, p.at("delta_t"),
                                             {{"a", p.at("diff_a"), {p.at("inf_a"), p.at("sup_a")}},
                                              {"b", p.at("diff_b"), {p.at("inf_b"), p.at("sup_b")}}});
        const auto number = [](double value) { return Operand::number(value); };
        experiment.rules = {test::always(React{Model::turing, 0, 1, number(1), {number(16), number(12)}})};
        return experiment;
    }

    Experiment reinforcement(const std::string& part, const std::vector<std::size_t>& shape) const {
        const nlohmann::json& p = parameters(part);
        Experiment experiment = test::matrix(shape[1], shape[0], boundary(p), Stencil::nine_point, p.at("delta_t"),
                                             {{"c", p.at("diff_c"), {-no_limit, no_limit}}});
        experiment.rules = {test::always(React{Model::reinforcement,
                                               0,
                                               0,
                                               Operand::number(1),
                                               {Operand::number(p.at("threshold")), Operand::number(p.at("width"))}})};
        return experiment;
    }

    void check(const Tissue& tissue, const std::string& part, const std::string& at, double allowed) const {
        const Snapshot now = tissue.read();
        double range = 0.0;  // of a flat field nothing is learnt
        for (std::size_t chemical = 0; chemical < now.conc.size(); ++chemical) {
            const std::string key = part + "." + tissue.experiment().chemicals[chemical].name + at;
            INFO(name_ << " " << key);
            const NpyArray wanted = array(key);
            REQUIRE(wanted.shape == std::vector<std::size_t>{now.rows, now.columns});
            const test::Difference difference = test::difference(now.conc[chemical], wanted.values);
            range = std::max(range, difference.range);
            const double rounding = 8 * std::numeric_limits<double>::epsilon() * difference.magnitude;
            CHECK(difference.largest < std::max(allowed * difference.range, rounding));
        }
        CHECK(range > 0.0);
    }

private:
    static Boundary boundary(const nlohmann::json& p) { return p.at("wrap") ? Boundary::wrap : Boundary::no_flux; }

    std::string name_;
    nlohmann::json json_;
};

// The order in which an expansion inserts its lines.
enum class Order { column_first, row_first };

// Feeds the notebook's own duplicated indices to the tissue.
class Growth {
public:
    Growth(const NpyArray& picks, Order order) : picks_(picks.values), order_(order) {}

    void expand(Tissue& tissue) {
        insert(tissue, order_ == Order::column_first);
        insert(tissue, order_ == Order::row_first);
    }
    bool used_up() const { return next_ == picks_.size(); }

private:
    void insert(Tissue& tissue, bool column) {
        Insertion insertion{column, {}};
        for (std::size_t line = 0; line < (column ? tissue.rows() : tissue.columns()); ++line) {
            insertion.picks.push_back(static_cast<std::uint32_t>(picks_.at(next_++)));
        }
        tissue.expand(insertion);
    }

    std::vector<double> picks_;
    Order order_;
    std::size_t next_ = 0;
};

// Growth falls on the first iteration of a part and on every `period`-th from there.
void grow_to(Tissue& tissue, Growth& growth, std::uint64_t period, std::uint64_t iteration) {
    while (tissue.iteration() < iteration) {
        if (tissue.iteration() % period == 0) growth.expand(tissue);
        const std::uint64_t next = (tissue.iteration() / period + 1) * period;
        tissue.advance(std::min(next, iteration) - tissue.iteration());
    }
}

// numpy's RandomState(1).random_sample, added to the middle row of b before each iteration.
class NoisyRow {
public:
    void skip(std::size_t numbers) { words_.discard(2 * numbers); }

    void advance(Tissue& tissue, std::uint64_t iteration) {
        while (tissue.iteration() < iteration) {
            Snapshot state = tissue.read();
            for (std::size_t column = 0; column < state.columns; ++column) {
                state.conc[1][65 * state.columns + column] += 0.01 * uniform();
            }
            tissue.write(state);
            tissue.advance(1);
        }
    }

private:
    double uniform() {
        const auto high = static_cast<double>(words_() >> 5);
        const auto low = static_cast<double>(words_() >> 6);
        return (high * 67108864.0 + low) / 9007199254740992.0;
    }

    std::mt19937 words_{1};
};

using Steps = std::vector<std::uint64_t>;

void check_steps(const Notebook& notebook, Tissue& tissue, const std::string& part, const Steps& steps) {
    for (const std::uint64_t at : steps) {
        tissue.advance(at - tissue.iteration());
        notebook.check(tissue, part, std::to_string(at), tolerance(at));
    }
}

void check_end(const Notebook& notebook, Tissue& tissue, const std::string& part) {
    tissue.advance(notebook.steps(part) - tissue.iteration());
    notebook.check(tissue, part, "_end", 1e-3);
}

void check_growth(const Notebook& notebook, Tissue& tissue, const std::string& part, Growth& growth,
                  std::uint64_t period, const Steps& steps) {
    for (const std::uint64_t at : steps) {
        grow_to(tissue, growth, period, at);
        notebook.check(tissue, part, std::to_string(at), tolerance(at));
    }
}

}  // namespace

TEST_CASE("the notebooks' examples of reaction and diffusion") {
    if (test::shared_missing("golden/leopard_2020/base_rd")) return;
    const Notebook notebook("base_rd");
    for (const std::string part : {"ex1", "ex2", "ex3", "ex4", "ex5", "ex6"}) {
        const NpyArray a = notebook.array(part + ".a0");
        const auto tissue = test::start(notebook.turing(part, a.shape), {a, notebook.array(part + ".b0")});
        check_steps(notebook, *tissue, part, {1, 10, 100});
        check_end(notebook, *tissue, part);
    }
}

TEST_CASE("the notebooks' examples of reinforcement") {
    if (test::shared_missing("golden/leopard_2020/base_re")) return;
    const Notebook notebook("base_re");
    for (const std::string part : {"ex1", "ex2", "ex3", "ex4", "ex5", "ex6", "ex7"}) {
        const NpyArray c = notebook.array(part + ".c0");
        const auto tissue = test::start(notebook.reinforcement(part, c.shape), {c});
        check_steps(notebook, *tissue, part, {1, 10, 100});
        check_end(notebook, *tissue, part);
    }
}

TEST_CASE("the notebooks' frog, growing") {
    if (test::shared_missing("golden/leopard_2020/frog")) return;
    const Notebook notebook("frog");
    const NpyArray a = notebook.array("p1.a0");
    const auto still = test::start(notebook.turing("p1", a.shape), {a, notebook.array("p1.b0")});
    check_steps(notebook, *still, "p1", {1, 10, 100});
    check_end(notebook, *still, "p1");

    const NpyArray end = notebook.array("p1.a_end");
    const auto tissue = test::start(notebook.turing("p2", end.shape), {end, notebook.array("p1.b_end")});
    Growth growth(notebook.array("p2.picks"), Order::column_first);
    check_growth(notebook, *tissue, "p2", growth, 200, {1, 10, 100, 200, 201, 1000});
    grow_to(*tissue, growth, 200, notebook.steps("p2"));
    notebook.check(*tissue, "p2", "_end", 1e-3);
    CHECK(growth.used_up());
}

TEST_CASE("the notebooks' reticulate whipray, growing") {
    if (test::shared_missing("golden/leopard_2020/whip")) return;
    const Notebook notebook("whip");
    const NpyArray a = notebook.array("ret_p1.a0");
    const auto still = test::start(notebook.turing("ret_p1", a.shape), {a, notebook.array("ret_p1.b0")});
    check_steps(notebook, *still, "ret_p1", {1, 10, 100});

    const NpyArray end = notebook.array("ret_p1.a_end");
    const auto tissue = test::start(notebook.turing("ret_p2", end.shape), {end, notebook.array("ret_p1.b_end")});
    Growth growth(notebook.array("ret_p2.picks"), Order::column_first);
    check_growth(notebook, *tissue, "ret_p2", growth, 100, {1, 10, 100, 1000});
}

TEST_CASE("the notebooks' comparison of growing models") {
    if (test::shared_missing("golden/leopard_2020/comparison")) return;
    const Notebook notebook("comparison");
    const NpyArray a0 = notebook.array("ref.a0");
    const auto still = test::start(notebook.turing("ref", a0.shape), {a0, notebook.array("ref.b0")});
    check_steps(notebook, *still, "ref", {1, 10, 100});

    const NpyArray a = notebook.array("ref.a_end");
    const NpyArray b = notebook.array("ref.b_end");
    for (const std::string part : {"rd", "sat"}) {
        const auto tissue = test::start(notebook.turing(part, a.shape), {a, b});
        Growth growth(notebook.array(part + ".picks"), Order::column_first);
        check_growth(notebook, *tissue, part, growth, 50, {1, 10, 50, 100, 500});
    }
    const auto tissue = test::start(notebook.reinforcement("rein", b.shape), {b});
    Growth growth(notebook.array("rein.picks"), Order::row_first);
    check_growth(notebook, *tissue, "rein", growth, 50, {1, 10, 50, 100, 500});
}

TEST_CASE("the notebooks' growth without diffusion only moves elements") {
    if (test::shared_missing("golden/leopard_2020/comparison")) return;
    const NpyArray b = test::golden("leopard_2020/comparison/ref.b_end");
    const Experiment still = test::matrix(b.shape[1], b.shape[0], Boundary::wrap, Stencil::nine_point, 1.0,
                                          {{"b", 0.0, {-no_limit, no_limit}}});
    const auto tissue = test::start(still, {b});
    Growth growth(test::golden("leopard_2020/comparison/nodiff.picks"), Order::column_first);
    for (const std::uint64_t steps : {50, 500, 5000}) {
        grow_to(*tissue, growth, 50, steps);
        const NpyArray wanted = test::golden("leopard_2020/comparison/nodiff.b" + std::to_string(steps));
        const test::Difference difference = test::difference(tissue->read().conc[0], wanted.values);
        CHECK(difference.range > 0.0);
        CHECK(difference.unequal == 0);
    }
    CHECK(growth.used_up());
}

TEST_CASE("the notebooks' leopard: definition of its spots") {
    if (test::shared_missing("golden/leopard_2020/leopard")) return;
    const Notebook notebook("leopard");
    const NpyArray a0 = notebook.array("p1a.a0");
    NoisyRow noise;
    noise.skip(130 * 130);  // drawn for an initial b that is then replaced
    const auto first = test::start(notebook.turing("p1a", a0.shape), {a0, notebook.array("p1a.b0")});
    noise.skip(130);        // already in b0
    first->advance(1);
    notebook.check(*first, "p1a", "1", 1e-12);
    noise.advance(*first, 10);
    notebook.check(*first, "p1a", "10", 1e-11);
    noise.advance(*first, 100);
    notebook.check(*first, "p1a", "100", 1e-9);
    noise.advance(*first, 1000);
    notebook.check(*first, "p1a", "1000", 1e-9);

    const NpyArray end = notebook.array("p1a.a_end");
    const auto second = test::start(notebook.turing("p1b", end.shape), {end, notebook.array("p1a.b_end")});
    NoisyRow again;  // the stream starts anew with each part
    for (const std::uint64_t steps : {1, 10, 100}) {
        again.advance(*second, steps);
        notebook.check(*second, "p1b", std::to_string(steps), tolerance(steps));
    }
}

TEST_CASE("the notebooks' leopard: growth and maintenance") {
    if (test::shared_missing("golden/leopard_2020/leopard")) return;
    const Notebook notebook("leopard");
    const NpyArray a = notebook.array("p1b.a_end");
    const NpyArray b = notebook.array("p1b.b_end");
    const auto spots = test::start(notebook.turing("p2ab", a.shape), {a, b});
    Growth growth(notebook.array("p2ab.picks"), Order::row_first);
    check_growth(notebook, *spots, "p2ab", growth, 50, {1, 10, 100, 1000});

    const auto base = test::start(notebook.reinforcement("p2c", b.shape), {b});
    Growth same_growth(notebook.array("p2c.picks"), Order::row_first);
    check_growth(notebook, *base, "p2c", same_growth, 50, {1, 10, 100, 1000});
}

TEST_CASE("the notebooks' leopard: maintenance between two growths") {
    if (test::shared_missing("golden/leopard_2020/leopard")) return;
    const Notebook notebook("leopard");
    for (const std::string part : {"p3base", "p3spot"}) {
        const NpyArray c = notebook.array(part + ".c0");  // after the first growth; kept in float
        const auto tissue = test::start(notebook.reinforcement(part, c.shape), {c});
        for (const std::uint64_t at : {1, 10, 100}) {
            tissue->advance(at - tissue->iteration());
            notebook.check(*tissue, part, std::to_string(at), 1e-6);
        }
    }
}
